// SPDX-License-Identifier: MIT
#include "scene/keys/force_keys.hpp"

#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

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
};

struct ForceDraft {
    AppliedForce force;
    const Value *body = nullptr, *vector = nullptr, *end = nullptr, *point = nullptr,
                *world_point = nullptr;
};

constexpr Key<ForceDraft> force_keys[] = {
    {"body", "needed: the name of a body", [](ForceDraft& d, const Value& v) { d.body = &v; }},
    {"force", "needed, in world space [N]",
     [](ForceDraft& d, const Value& v) {
         d.vector = &v;
         d.force.force = vector3(v);
     }},
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
        if (!draft.vector) expected("a \"force\" in it", item);
        if (draft.point && draft.world_point)
            throw Mistake{draft.world_point->line,
                          "expected either \"point\" or \"world_point\", found both"};
        draft.force.body = body_index(*draft.body, bodies);
        if (draft.force.end <= draft.force.start)
            expected(fmt::format("an end > {}", draft.force.start), *draft.end);
        if (draft.world_point) read.in_world.push_back(static_cast<int>(read.forces.size()));
        read.forces.push_back(draft.force);
    }
    return read;
}

void force_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<SpringDraft>("spring", spring_keys, meanings);
    add_meanings<ForceDraft>("force", force_keys, meanings);
}

} // namespace rigor
