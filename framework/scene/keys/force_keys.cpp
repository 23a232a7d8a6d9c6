// SPDX-License-Identifier: MIT
#include "scene/keys/force_keys.hpp"

#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "scene/language/expression.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

namespace rigor {

namespace {

int body_index(const Value& value, const std::vector<BodyDescription>& bodies)
{
    const std::string name = line_of_text(value, "the name of a body");
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].name == name) return static_cast<int>(i);
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(bodies.size(), 1000); ++i)
        names.push_back(bodies[i].name);
    throw Mistake{value.line, fmt::format("expected the name of a body, found {}{}",
                                          in_quotes(name), suggestion(name, names))};
}

bool can_move(const BodyDescription& body)
{
    return !body.is_static && !body.drive;
}

// Refuses a force, a spring or a pair that would have no effect.
void need_motion(bool any_moves, const Value& value, const std::string& name)
{
    if (!any_moves)
        throw Mistake{value.line, fmt::format("expected a body that can move, found {}, which is "
                                              "static or driven",
                                              in_quotes(name))};
}

struct SpringDraft {
    Spring spring;
    const Value *body1 = nullptr, *body2 = nullptr, *stiffness = nullptr;
};

constexpr Key<SpringDraft> spring_keys[] = {
    {"body1", "the name of a body; left out, `point1` is fixed in the world",
     [](SpringDraft& d, const Value& v) { d.body1 = &v; }},
    {"point1", "in the frame of `body1`, or in the world; default [0, 0, 0] [m]",
     [](SpringDraft& d, const Value& v) { d.spring.point1 = vector3(v); }},
    {"body2", "as `body1`; one of the two is needed",
     [](SpringDraft& d, const Value& v) { d.body2 = &v; }},
    {"point2", "as `point1`", [](SpringDraft& d, const Value& v) { d.spring.point2 = vector3(v); }},
    {"stiffness", "needed, > 0 [N/m]",
     [](SpringDraft& d, const Value& v) {
         d.stiffness = &v;
         d.spring.stiffness = positive(v, "a stiffness");
     }},
    {"damping", "along the spring, ≥ 0, default 0 [N s/m]",
     [](SpringDraft& d, const Value& v) { d.spring.damping = not_negative(v, "a damping"); }},
    {"rest_length", "≥ 0, default 0 [m]",
     [](SpringDraft& d, const Value& v) {
         d.spring.rest_length = not_negative(v, "a rest length");
     }},
    {"only_pulls", "true for a rope: slack while it is shorter than `rest_length`, default false",
     [](SpringDraft& d, const Value& v) { d.spring.only_pulls = boolean(v); }},
};

constexpr std::string_view frame_words[] = {"world", "body"};

struct ForceDraft {
    AppliedForce force;
    const Value *body = nullptr, *vector = nullptr, *torque = nullptr, *end = nullptr,
                *point = nullptr, *factor = nullptr, *world_point = nullptr, *frequency = nullptr,
                *phase = nullptr;
};

constexpr Key<ForceDraft> force_keys[] = {
    {"body", "needed: the name of a body", [](ForceDraft& d, const Value& v) { d.body = &v; }},
    {"force", "default [0, 0, 0]; this or `torque` is needed [N]",
     [](ForceDraft& d, const Value& v) {
         d.vector = &v;
         d.force.force = vector3(v);
     }},
    {"torque", "in addition, default [0, 0, 0] [N m]",
     [](ForceDraft& d, const Value& v) {
         d.torque = &v;
         d.force.torque = vector3(v);
     }},
    {"frame",
     "in which force and torque are given: \"world\", or \"body\" if they turn with it, default "
     "the first",
     [](ForceDraft& d, const Value& v) { d.force.turns_with_body = one_of(v, frame_words) == 1; }},
    {"point", "where it acts, in the frame of the body, default [0, 0, 0] [m]",
     [](ForceDraft& d, const Value& v) {
         d.point = &v;
         d.force.point = vector3(v);
     }},
    {"world_point", "instead of `point`: where it acts at the start, in world space [m]",
     [](ForceDraft& d, const Value& v) {
         d.world_point = &v;
         d.force.point = vector3(v);
     }},
    {"start", "≥ 0, default 0 [s]",
     [](ForceDraft& d, const Value& v) { d.force.start = not_negative(v, "a start"); }},
    {"end", "later than `start`, default never [s]",
     [](ForceDraft& d, const Value& v) {
         d.end = &v;
         d.force.end = number(v, "an end");
     }},
    {"frequency", "> 0: force and torque oscillate as the sine of the time, default never [Hz]",
     [](ForceDraft& d, const Value& v) {
         d.frequency = &v;
         d.force.frequency = positive(v, "a frequency");
     }},
    {"phase_degrees", "with `frequency`: of the sine at 0 s, default 0 [degrees]",
     [](ForceDraft& d, const Value& v) {
         d.phase = &v;
         d.force.phase = number(v, "a phase") * std::numbers::pi / 180;
     }},
    {"factor",
     "an expression of the time t in seconds that force and torque are multiplied by, such as "
     "\"exp(-t/2)\", default 1",
     [](ForceDraft& d, const Value& v) { d.factor = &v; }},
};

// Reads the factor of a force. Refuses a factor that is not finite at the start of the force.
void read_factor(ForceDraft& draft)
{
    if (!draft.factor) return;
    const Expression factor = expression(*draft.factor);
    if (!std::isfinite(factor(draft.force.start)))
        expected(fmt::format("a factor that is finite at t = {}", draft.force.start),
                 *draft.factor);
    draft.force.factor = factor;
}

struct PairDraft {
    PairLaw law;
    const Value *body1 = nullptr, *body2 = nullptr, *collide = nullptr;
};

constexpr Key<PairDraft> pair_keys[] = {
    {"body1", "needed: the name of a body", [](PairDraft& d, const Value& v) { d.body1 = &v; }},
    {"body2", "needed: the name of another one",
     [](PairDraft& d, const Value& v) { d.body2 = &v; }},
    {"restitution", "ε from 0 to 1 between the two, default by their own values",
     [](PairDraft& d, const Value& v) { d.law.restitution = in_range(v, "a restitution", 0, 1); }},
    {"friction", "μ ≥ 0 between the two, default by their own values",
     [](PairDraft& d, const Value& v) { d.law.friction = not_negative(v, "a friction"); }},
    {"collide", "false if they pass through each other, default true",
     [](PairDraft& d, const Value& v) {
         d.law.collides = boolean(v);
         d.collide = &v;
     }},
};

} // namespace

std::vector<Spring> read_springs(const Value& value, const std::vector<BodyDescription>& bodies)
{
    std::vector<Spring> springs;
    for (const Value& item : array(value, "a list of springs")) {
        SpringDraft draft;
        read_object<SpringDraft>(item, "a spring {\"body1\": …, \"stiffness\": …}", spring_keys,
                                 draft);
        if (!draft.body1 && !draft.body2) expected("\"body1\" or \"body2\" in the spring", item);
        if (!draft.stiffness) expected("a \"stiffness\" in the spring", item);
        if (draft.body1) draft.spring.body1 = body_index(*draft.body1, bodies);
        if (draft.body2) draft.spring.body2 = body_index(*draft.body2, bodies);
        if (draft.spring.body1 == draft.spring.body2)
            expected("two different bodies", *draft.body2);
        const auto moves = [&](const Value* body, int i) { return body && can_move(bodies[i]); };
        const Value& last = draft.body2 ? *draft.body2 : *draft.body1;
        need_motion(moves(draft.body1, draft.spring.body1) ||
                        moves(draft.body2, draft.spring.body2),
                    last, line_of_text(last, "the name of a body"));
        springs.push_back(draft.spring);
    }
    return springs;
}

ForcesRead read_forces(const Value& value, const std::vector<BodyDescription>& bodies)
{
    ForcesRead read;
    for (const Value& item : array(value, "a list of forces")) {
        ForceDraft draft;
        read_object<ForceDraft>(item, "a force {\"body\": …, \"force\": …}", force_keys, draft);
        if (!draft.body) expected("a \"body\" in the force", item);
        if (!draft.vector && !draft.torque) expected("a \"force\" or a \"torque\" in it", item);
        if (draft.phase && !draft.frequency)
            throw Mistake{draft.phase->line,
                          "expected \"frequency\" beside \"phase_degrees\", found none"};
        if (draft.point && draft.world_point)
            throw Mistake{draft.world_point->line,
                          "expected either \"point\" or \"world_point\", found both"};
        draft.force.body = body_index(*draft.body, bodies);
        need_motion(can_move(bodies[draft.force.body]), *draft.body, bodies[draft.force.body].name);
        if (draft.force.end <= draft.force.start)
            expected(fmt::format("an end > {}", draft.force.start), *draft.end);
        read_factor(draft);
        if (draft.world_point) read.in_world.push_back(static_cast<int>(read.forces.size()));
        read.forces.push_back(draft.force);
    }
    return read;
}

std::vector<PairLaw> read_pairs(const Value& value, const std::vector<BodyDescription>& bodies)
{
    std::vector<PairLaw> laws;
    std::set<std::pair<int, int>> seen;
    for (const Value& item : array(value, "a list of pairs")) {
        PairDraft draft;
        read_object<PairDraft>(item, "a pair {\"body1\": …, \"body2\": …}", pair_keys, draft);
        if (!draft.body1 || !draft.body2) expected("\"body1\" and \"body2\" in the pair", item);
        PairLaw& law = draft.law;
        law.body1 = body_index(*draft.body1, bodies);
        law.body2 = body_index(*draft.body2, bodies);
        if (law.body1 == law.body2) expected("two different bodies", *draft.body2);
        need_motion(can_move(bodies[law.body1]) || can_move(bodies[law.body2]), *draft.body2,
                    bodies[law.body2].name);
        if (!law.restitution && !law.friction && !draft.collide)
            expected("\"restitution\", \"friction\" or \"collide\" in the pair", item);
        if (!seen.insert(std::minmax(law.body1, law.body2)).second)
            throw Mistake{item.line, fmt::format("expected each pair once, found {} and {} again",
                                                 in_quotes(bodies[law.body1].name),
                                                 in_quotes(bodies[law.body2].name))};
        laws.push_back(law);
    }
    sort_by_pair(laws);
    return laws;
}

void force_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<SpringDraft>("spring", spring_keys, meanings);
    add_meanings<ForceDraft>("force", force_keys, meanings);
    add_meanings<PairDraft>("pair", pair_keys, meanings);
}

} // namespace rigor
