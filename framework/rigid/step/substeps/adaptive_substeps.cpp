// SPDX-License-Identifier: MIT
// Adaptive substeps of single islands. "New overlap" is the increase of the overlap of two bodies
// in this step. For each pair of bodies, the code first computes a bound of the new overlap, from
// the bodies' rotation and from the remaining approach speed. The code searches for contacts again
// only where this bound is too large. An island whose step is repeated is copied into a separate
// world, with the static bodies near it, and takes two steps there: of half the length, up to an
// impact and after it, or up to the time at which a single body stops sliding and after it. The
// header lists the cases.
#include "rigid/step/substeps/adaptive_substeps.hpp"

#include "rigid/detection/overlap_depth.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/impact.hpp"
#include "rigid/step/substeps/end_of_sliding.hpp"
#include "rigid/step/substeps/island_world.hpp"
#include "rigid/step/substeps/passed_contact.hpp"
#include "rigid/step/substeps/rim_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rigor {

namespace {

// Allowed increase of the overlap in a step, as a fraction of the thinner body's thickness. The
// first value applies where bodies rotate into each other, the second where the solver left some
// approach speed. With smaller values more steps are repeated; with larger values more penetration
// remains. Chosen by trial; tests/stress shows the depth.
constexpr double overlap_by_turn = 0.005, overlap_by_speed = 0.05;

// The largest distance by which the rotation of a body in this step may move its points out of the
// tangent planes of its contacts [m].
double deviation_by_rotation(const World& world, const ContactProblem& problem, int i,
                             double radius)
{
    const RigidBody& body = world.bodies[i];
    if (body.is_still() || body.is_ball()) return 0;
    const double angle = problem.time_step * problem.bodies[i].angular_velocity.norm();
    return angle * angle / 2 * radius;
}

// Checks whether the overlap of the two bodies of a pair has grown in the step by more than is
// allowed.
class OverlapCheck {
public:
    OverlapCheck(const World& world, const ContactProblem& problem,
                 const ContactCandidates& candidates, const std::vector<RigidState>& states)
        : world_(world), problem_(problem), candidates_(candidates), overlap_(world, states)
    {
    }

    bool operator()(const ContactPair& pair)
    {
        const ContactConstraint& first = problem_.contacts[pair.first];
        const int i = first.body1, j = first.body2;
        const double thinner = std::min(thickness(world_.bodies[i]), thickness(world_.bodies[j]));
        double before = 0, predicted = 0; // largest depths [m]
        for (int k = pair.first; k < pair.last; ++k) {
            const ContactConstraint& c = problem_.contacts[k];
            const double v_n = problem_.velocity_at(c, c.point).dot(c.normal);
            before = std::max(before, -c.gap);
            predicted = std::max(predicted, -problem_.predicted_gap(c, v_n));
        }
        const double turned = deviation_by_rotation(world_, problem_, i, candidates_.radii[i]) +
                              deviation_by_rotation(world_, problem_, j, candidates_.radii[j]);
        const bool may_turn_in = turned > overlap_by_turn * thinner;
        if (!may_turn_in && !(predicted > before + overlap_by_speed * thinner)) return false;
        const double allowed = may_turn_in ? overlap_by_turn : overlap_by_speed;
        return overlap_.depth(i, j) > before + allowed * thinner;
    }

private:
    const World& world_;
    const ContactProblem& problem_;
    const ContactCandidates& candidates_;
    Overlap overlap_; // after the step
};

// Whether all bodies of the pair that can move are balls.
bool moves_only_balls(const World& world, const ContactConstraint& c)
{
    const RigidBody &body1 = world.bodies[c.body1], &body2 = world.bodies[c.body2];
    return (body1.is_static || body1.is_ball()) && (body2.is_static || body2.is_ball());
}

// Whether other bodies pushed the two bodies of a pair towards each other again after their bounce,
// so that the contact stage stopped them, although they should bounce again.
bool is_hit_again(const ContactProblem& problem, const ContactPair& pair)
{
    constexpr double noticeable = 1e-3; // smaller shares are errors of the sweeps and rounding
    double bounce = 0, stop = 0;        // [N s]
    for (int k = pair.first; k < pair.last; ++k) {
        bounce += problem.contacts[k].collision_impulse.norm();
        stop += problem.contacts[k].contact_impulse.norm();
    }
    return stop > noticeable * bounce && bounce > 0;
}

// Whether a pair that should bounce was stopped by the contact stage, since springs, applied forces
// or drag pushed the two bodies together within the step: again after a bounce, or for the first
// time, so that the collision stage found no hit.
bool is_pushed_together(const ContactProblem& problem, const ContactPair& pair)
{
    if (problem.contacts[pair.first].restitution == 0) return false;
    if (bounced(problem, pair)) return is_hit_again(problem, pair);
    return std::any_of(problem.contacts.begin() + pair.first, problem.contacts.begin() + pair.last,
                       [&](const ContactConstraint& c) {
                           return problem.holds(c) && c.gap > nearly_touching_gap * c.radius;
                       });
}

// Whether no other pair of an island of few bodies got an impulse.
bool is_lone(const ContactProblem& problem, const Island& island, const ContactPair& pair)
{
    return island.bodies.size() <= few_bodies &&
           std::all_of(island.pairs.begin(), island.pairs.end(), [&](const ContactPair& other) {
               return other.first == pair.first ||
                      (!bounced(problem, other) && !carries_load(problem, other));
           });
}

// Whether a pair bounced with ε > 0 while all contacts that were hit were open: the bounce was not
// moved to its time of impact. Bodies that hit a driven body that turns do not count.
bool bounced_in_air(const World& world, const ContactProblem& problem, const ContactPair& pair)
{
    const ContactConstraint& first = problem.contacts[pair.first];
    const auto is_turning = [&](int i) {
        return world.bodies[i].changes_place() && !problem.bodies[i].angular_velocity.isZero(0);
    };
    if (is_turning(first.body1) || is_turning(first.body2) || !bounced(problem, pair)) return false;
    return std::all_of(problem.contacts.begin() + pair.first, problem.contacts.begin() + pair.last,
                       [](const ContactConstraint& c) {
                           return c.collision_impulse.isZero(0) ||
                                  (c.restitution > 0 && c.gap > nearly_touching_gap * c.radius);
                       });
}

// Whether the contacts of a pair bounced with ε > 0, some of them closed now and some of them open,
// such as the two ends of a rod.
bool bounced_twice(const ContactProblem& problem, const ContactPair& pair)
{
    bool now = false, later = false;
    for (int i = pair.first; i < pair.last; ++i) {
        const ContactConstraint& c = problem.contacts[i];
        if (c.collision_impulse.isZero(0) || c.restitution == 0) continue;
        (c.gap <= nearly_touching_gap * c.radius ? now : later) = true;
    }
    return now && later;
}

// Where the step of an island is divided in two parts.
struct Division {
    enum class At { event, middle, start }; // `start`: just after a bounce at the start of the step
    double time = 0; // since the start of the step; 0 if the step is not divided [s]
    At at = At::event;
    bool is_free = false;     // whether the bodies are in free flight until `time`
    bool is_apart = true;     // whether `time` is not nearly 0, see `apart` in `first_impact`
    bool has_several = false; // whether other bounces follow that at `time`
};

constexpr double just_before = 1 - 1e-9; // so that the bounce lies in the later part
// If a bounce is nearer to the start than this share of the step, it counts as a bounce at the
// start. An earlier division has already predicted it, and this division only corrects the time.
constexpr double apart = 1e-6;

// The first bounce that divides the step, or the end of the step if the bounces come later. Bounces
// with ε > 0 of these pairs count:
// 1. Two moving balls.
// 2. A ball and a static body, in an island of at most `few_bodies` bodies where several pairs
//    bounce and no contact carries a load. The load of a contact that bounced does not count: it
//    stops bodies that were pushed together again. (For any other load, the next step starts from
//    its mean force in the later part of this step, so this part must not be very short.)
// 3. The only pair that bounces in such an island, if one end of a body hits before the other.
//
// A bounce that `bounce_at_impacts` has moved to its time of impact does not count. The exact time
// matters, as in billiards: balls separate along the line of centers that they have at the impact.
// The later part of the step predicts the time again and may be divided again. This iteration
// converges quadratically.
Division first_impact(const World& world, const ContactProblem& problem, const Island& island)
{
    const auto count = [&](bool (*holds)(const ContactProblem&, const ContactPair&)) {
        return std::count_if(island.pairs.begin(), island.pairs.end(),
                             [&](const ContactPair& pair) { return holds(problem, pair); });
    };
    const std::ptrdiff_t bounces = count(bounced);
    const bool is_loaded = count([](const ContactProblem& in, const ContactPair& pair) {
                               return carries_load(in, pair) && !bounced(in, pair);
                           }) > 0;
    const bool is_small = island.bodies.size() <= few_bodies && bounces > 1 && !is_loaded;

    const double h = problem.time_step;
    if (std::any_of(island.pairs.begin(), island.pairs.end(), [&](const ContactPair& pair) {
            return is_lone(problem, island, pair) && bounced_twice(problem, pair);
        }))
        return {alone_in_step * h, Division::At::start};
    double first = h, last_at_start = 0;
    std::ptrdiff_t at_start = 0, later = 0, in_flight = 0; // numbers of bounces
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& c = problem.contacts[pair.first];
        if (!bounced(problem, pair) || c.restitution == 0 || !moves_only_balls(world, c)) continue;
        const bool has_static = world.bodies[c.body1].is_static || world.bodies[c.body2].is_static;
        if (has_static && !is_small) continue;
        const double time = just_before * time_of_impact(world, problem, pair);
        ++(time > apart * h ? later : at_start);
        if (time <= apart * h) last_at_start = std::max(last_at_start, time);
        if (time == 0) continue;
        ++in_flight;
        first = std::min(first, time);
    }
    // A bounce at the start of the step changes the times of the other bounces, so the first part
    // ends just after it.
    if (at_start > 0 && later > 0 && !is_loaded)
        return {last_at_start + alone_in_step * h, Division::At::start};
    // Gravity bends the paths, so it may be that no impact is within the step. Then all fly freely.
    const bool is_free = bounces > 0 && in_flight == bounces && !is_loaded;
    if (first < h || is_free)
        return {first, Division::At::event, is_free, first > apart * h, bounces > 1};
    return {};
}

// The first hit in an island that springs, applied forces or drag act on, whatever its shapes and
// restitutions; the end of the step if its bodies do not meet in free flight. The time is predicted
// with the mean acceleration of the step, and predicted again in the later part. The step is not
// divided if a contact is hit at its start, or if a contact without a hit carries a load.
Division first_impact_under_forces(const World& world, const ContactProblem& problem,
                                   const Island& island)
{
    if (island.bodies.size() > few_bodies) return {};
    double first = problem.time_step;
    for (const ContactPair& pair : island.pairs)
        if (bounced(problem, pair))
            first = std::min(first, time_of_impact(world, problem, pair));
        else if (carries_load(problem, pair))
            return {};
    if (first <= apart * problem.time_step) return {};
    return {std::min(just_before * first, problem.time_step), Division::At::event, true};
}

// Moves the bodies of a world by free flight.
void fly_freely(World& world, double time)
{
    ThreadPool alone;
    const std::vector<bool> pulled = with_dragged_bodies(pulled_bodies(world, time), world);
    const std::vector<RigidState> flown = fly_all(world, pulled, time, alone);
    for (std::size_t i = 0; i < flown.size(); ++i)
        world.bodies[i].state = flown[i];
    world.time += time;
}

void take_substep(IslandWorld& part, const StepOfPart& step, const Divisions& divisions,
                  double time, Refinement& refined)
{
    for (ContactRecord record : step(part.world, time, divisions)) {
        record.body1 = part.bodies[record.body1];
        record.body2 = part.bodies[record.body2];
        refined.records.push_back(record);
    }
}

void keep_warm_contacts(const IslandWorld& part, Refinement& refined)
{
    for (WarmContact contact : part.world.memory.warm_contacts) {
        contact.body1 = part.bodies[contact.body1];
        contact.body2 = part.bodies[contact.body2];
        refined.warm_contacts.push_back(contact);
    }
}

// Where the step of an island is divided, by the cases of the header.
Division division_of(const World& world, const ContactProblem& problem, const Island& island,
                     const std::vector<Body>& before_forces, const std::vector<bool>& pulled,
                     const Divisions& divisions, const std::vector<RigidState>& states,
                     OverlapCheck& overlaps_anew)
{
    const bool is_at_limit = divisions.all() >= most_divisions;
    const bool is_large = island.bodies.size() > (is_at_limit ? few_bodies : most_refined);
    if (is_large || divisions.all() >= most_divisions_of_few) return {};
    const double h = problem.time_step;
    const bool is_pulled =
        std::any_of(island.bodies.begin(), island.bodies.end(), [&](int i) { return pulled[i]; });
    const auto is_any = [&](const auto& condition) {
        return std::any_of(island.pairs.begin(), island.pairs.end(), condition);
    };
    // A contact that forces press together must not lose its load to a very short part.
    const auto is_pressed = [&](const ContactPair& pair) {
        return is_pulled && carries_load(problem, pair) && !bounced(problem, pair);
    };
    const bool may_pass = island.bodies.size() <= few_bodies && !is_any(is_pressed);
    const double passed = may_pass ? closing_of_passed_contact(world, problem, island) : h;
    Division division;
    if (passed < h)
        division = {passed + alone_in_step * h, Division::At::event, false, passed > apart * h};
    else if (is_pulled)
        division = first_impact_under_forces(world, problem, island);
    else if (island.lands_at > apart * h)
        division = {just_before * island.lands_at, Division::At::event, true};
    else
        division = first_impact(world, problem, island);
    division.is_free &= island.moved_bounces.empty();
    // Beyond the limit, a division is allowed only if it resolves a new bounce. A bounce at the
    // time of the one before is not new: for a body that rests, there would be no end of them.
    const bool is_again = division.at == Division::At::start && divisions.is_after_bounce;
    if (is_at_limit) return division.is_apart && !is_again ? division : Division();
    if (division.time > 0) return division;

    const auto in_air = [&](const ContactPair& pair) {
        return is_lone(problem, island, pair) && bounced_in_air(world, problem, pair);
    };
    const auto pushed = [&](const ContactPair& pair) { return is_pushed_together(problem, pair); };
    const auto runs = [&](const ContactPair& pair) {
        return island.bodies.size() == 1 && runs_round_rim(world, problem, states, pair);
    };
    if (is_pulled ? is_any(pushed)
                  : is_any(std::ref(overlaps_anew)) || is_any(runs) || is_any(in_air))
        division = {h / 2, Division::At::middle};
    else if (divisions.all() < most_divisions_of_sliding)
        division.time = end_of_sliding(problem, island, before_forces);
    return division;
}

// The parts do not count as steps of the world. If the step was divided at an impact, both the
// first attempt and the parts counted its bounces, so one bounce is subtracted for each pair that
// bounced, at its time of impact or not. If the step was halved, the counters include the work of
// the first attempt and of the halves.
void count_parts(const World& parts, const ContactProblem& problem, const Island& island,
                 bool is_halved, Counters& counters)
{
    const std::uint64_t steps = counters.steps;
    counters = parts.counters;
    counters.steps = steps;
    if (is_halved) return;
    const auto& moved = island.moved_bounces;
    counters.collision_impulses -=
        std::count_if(island.pairs.begin(), island.pairs.end(), [&](const ContactPair& pair) {
            const ContactConstraint& c = problem.contacts[pair.first];
            return bounced(problem, pair) ||
                   std::any_of(moved.begin(), moved.end(), [&](const ContactRecord& record) {
                       return record.body1 == c.body1 && record.body2 == c.body2;
                   });
        });
}

} // namespace

Refinement refine_by_substeps(World& world, ContactProblem& problem,
                              const std::vector<Body>& before_forces,
                              const std::vector<bool>& pulled, const ContactCandidates& candidates,
                              std::vector<RigidState>& states, const Divisions& divisions,
                              const StepOfPart& step)
{
    Refinement refined;
    OverlapCheck overlaps_anew(world, problem, candidates, states);
    for (Island& island : problem.islands) {
        const Division division = division_of(world, problem, island, before_forces, pulled,
                                              divisions, states, overlaps_anew);
        if (division.time == 0) continue;
        const std::optional<std::vector<int>> moved =
            bodies_moved_together(world, problem, island, candidates.contacts);
        if (!moved) continue;
        IslandWorld part = island_world(world, *moved, candidates.contacts);
        const double h = problem.time_step;
        constexpr Divisions at_limit = {0, most_divisions_of_few};
        const bool is_halved = division.at == Division::At::middle;
        Divisions of_parts = divisions.with(is_halved);
        of_parts.is_after_bounce = division.at == Division::At::start;
        double rest = h - division.time;
        if (!division.is_free) {
            // From `most_divisions` on, only the later part is divided again. So the number of
            // parts grows in proportion to the number of bounces, and not exponentially.
            const bool is_final = divisions.all() >= most_divisions;
            take_substep(part, step, is_final ? at_limit : of_parts, division.time, refined);
        } else {
            fly_freely(part.world, division.time);
            // The bounce changes the times of the others, so it is alone in a part of the step.
            const double alone = alone_in_step * h;
            if (division.has_several && rest > alone) {
                take_substep(part, step, at_limit, alone, refined);
                rest -= alone;
            }
        }
        if (rest > 0) take_substep(part, step, of_parts, rest, refined);
        keep_warm_contacts(part, refined);
        for (std::size_t k = 0; k < part.bodies.size(); ++k)
            if (!part.world.bodies[k].is_static)
                states[part.bodies[k]] = part.world.bodies[k].state;
        count_parts(part.world, problem, island, is_halved, world.counters);
        island.moved_bounces.clear();
        for (const ContactPair& pair : island.pairs)
            for (int i = pair.first; i < pair.last; ++i) {
                problem.contacts[i].collision_impulse.setZero();
                problem.contacts[i].contact_impulse.setZero();
            }
    }
    return refined;
}

} // namespace rigor
