// SPDX-License-Identifier: MIT
// Finds the time of impact of two bodies that only bounce off each other, by the secant method on
// the gap. The method starts from a prediction: the time when the first contact closes, if its
// acceleration stays the same. The collision stage then runs at the time of impact, in a world of
// these two bodies alone.
#include "rigid/step/impact.hpp"

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/contact/collisions.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/detection/overlap_depth.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/approach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace rigor {

namespace {

constexpr int most_iterations = 8; // largest number of secant steps; usually 3 or 4 are enough

// A separate world of two bodies that bounce off each other, at a time during the step.
struct PairWorld {
    World world;
    double time = 0; // since the start of the step [s]
    double gap = 0;  // smallest gap of the contacts, at most the `reach` of `pair_at` [m]
    std::vector<Contact> contacts;
};

// The two bodies of the contact c after a flight of length `time` from the start of the step, with
// their contacts whose gap is below `reach`.
PairWorld pair_at(const World& world, const ContactConstraint& c, double time, double reach)
{
    PairWorld pair;
    pair.world.settings = world.settings;
    pair.world.settings.optimisations.warm_start = false;
    pair.world.pair_laws = laws_among(world.pair_laws, std::array{c.body1, c.body2});
    pair.world.time = world.time + time;
    pair.time = time;
    std::vector<Pose> poses;
    for (int i : {c.body1, c.body2}) {
        RigidBody& body = pair.world.bodies.emplace_back(world.bodies[i]);
        if (body.changes_place())
            body.state = driven_state(*body.drive, pair.world.time);
        else if (!body.is_static && time > 0)
            body.state = fly(world.settings, body, body.state, time, pair.world.counters);
        poses.push_back(pose_of(body.state));
    }
    find_contacts(pair.world, poses, 0, 1, reach, pair.contacts);
    pair.gap = reach;
    for (const Contact& contact : pair.contacts)
        pair.gap = std::min(pair.gap, contact.gap);
    return pair;
}

// Sets the states of the two bodies of the contact c to their states after free flight over the
// whole step, since the bodies do not meet in this step.
void fly_past(const World& world, const ContactConstraint& c, double time_step,
              std::vector<RigidState>& states)
{
    Counters uncounted;
    for (int i : {c.body1, c.body2})
        if (const RigidBody& body = world.bodies[i]; !body.is_static)
            states[i] = fly(world.settings, body, body.state, time_step, uncounted);
}

// A bound of the speed of the points of a body within `radius` of x [m/s].
double fastest_near(const World& world, const RigidBody& body, const Vector3d& x, double radius)
{
    const double arm = (x - body.state.position).norm() + radius;
    if (body.changes_place()) {
        const DriveVelocity now = drive_velocity(*body.drive, world.time);
        return now.linear.norm() + now.angular.norm() * arm;
    }
    if (body.is_static) return 0;
    const Vector3d w = angular_velocity(world.settings.integrator, body, body.state);
    return body.state.velocity.norm() + w.norm() * arm;
}

// The two bodies of the contact c at the time when their gap closes, by the secant method from the
// predicted time, with the contacts that may close in one step.
// @return nothing if the iteration does not converge; the bodies at the end of the step if they do
//         not meet before
std::optional<PairWorld> pair_at_impact(const World& world, const ContactConstraint& c,
                                        const Approach& approach, double time_step)
{
    const double reach = 2 * std::abs(approach.gap) + c.radius;
    double time = approach.closes(), before = 0, gap_before = approach.gap;
    bool opens = false;
    PairWorld pair = pair_at(world, c, time, reach);
    for (int i = 0; i < most_iterations && std::abs(pair.gap) > touching_gap * c.radius; ++i) {
        const double slope = (pair.gap - gap_before) / (time - before);
        opens = !(slope < 0); // they pass each other, or the gap is nothing but rounding
        if (opens) break;
        before = time;
        gap_before = pair.gap;
        time = std::clamp(time - pair.gap / slope, 0.0, time_step);
        if (time == before) break;
        pair = pair_at(world, c, time, reach);
    }
    // A gap that is still open at the end is much smaller than at the start, unless the bodies have
    // passed each other.
    const bool is_past_end =
        time == time_step && pair.gap > 0 && pair.gap < approach.gap / 2 && !opens;
    if (!is_past_end && std::abs(pair.gap) > nearly_touching_gap * c.radius) return std::nullopt;
    // A pair keeps only a few contacts. If the reach were larger than `near`, these contacts would
    // be spread over the whole bodies, and only one end of an edge that hits might be kept.
    double near = 2 * nearly_touching_gap * c.radius;
    for (const RigidBody& body : pair.world.bodies)
        near += time_step * fastest_near(pair.world, body, c.point, c.radius);
    return near < reach ? pair_at(world, c, time, near) : pair;
}

// The contact problem at the impact, for the rest of the step (`rest`: its length [s]). All
// contacts of `pair` are moved into the problem. The counters of the pair's world are not added to
// those of the whole world, since the bounce was counted there already.
ContactProblem problem_at_impact(PairWorld& pair, double radius, double rest)
{
    std::vector<RigidState> flown;
    ContactCandidates near;
    near.contacts = std::move(pair.contacts);
    near.margins.assign(2, std::numeric_limits<double>::infinity());
    near.radii.assign(2, radius);
    for (std::size_t k = 0; k < 2; ++k) {
        const RigidBody& body = pair.world.bodies[k];
        near.poses.push_back(pose_of(body.state));
        if (body.is_static) near.radii[k] = 0;
        if (body.changes_place())
            flown.push_back(driven_state(*body.drive, pair.world.time + rest));
        else if (body.is_static)
            flown.push_back(body.state);
        else
            flown.push_back(fly(pair.world.settings, body, body.state, rest, pair.world.counters));
    }
    ContactProblem problem = make_problem(pair.world, flown, near, rest, pair.world.pool);
    // A driven body hits with its velocity at the impact, not with its mean velocity in `rest`.
    for (std::size_t k = 0; k < 2; ++k)
        if (const RigidBody& body = pair.world.bodies[k]; body.changes_place()) {
            const DriveVelocity now = drive_velocity(*body.drive, pair.world.time);
            problem.bodies[k].velocity = now.linear;
            problem.bodies[k].angular_velocity = now.angular;
        }
    return problem;
}

// The contacts of the bounce with their impulses and with the body indices of the whole world. The
// list is empty if there is no impulse or if the bodies would meet again in the rest of the step.
std::vector<ContactRecord> records_of_bounce(const ContactProblem& impact,
                                             const ContactConstraint& c)
{
    std::vector<ContactRecord> records;
    for (const ContactConstraint& hit : impact.contacts) {
        const double v_n = impact.velocity_at(hit, hit.point).dot(hit.normal) + hit.force_speed;
        if (impact.predicted_gap(hit, v_n) < -touching_gap * c.radius) return {}; // they meet again
        if (!hit.collision_impulse.isZero(0))
            records.push_back(
                {c.body1, c.body2, hit.point, hit.normal, -hit.gap, hit.collision_impulse});
    }
    return records;
}

// Whether a contact that is still open at the time of impact got an impulse because it closes later
// in the step, such as the other end of a rod.
bool has_later_hit(const ContactProblem& impact, double radius)
{
    return std::any_of(impact.contacts.begin(), impact.contacts.end(),
                       [&](const ContactConstraint& c) {
                           return c.restitution > 0 && !c.collision_impulse.isZero(0) &&
                                  c.gap > nearly_touching_gap * radius;
                       });
}

// The states at the end of the step: the bodies fly on with their velocities after the bounce.
void fly_on(PairWorld& pair, const ContactProblem& impact, const ContactConstraint& c, double rest,
            std::vector<RigidState>& states)
{
    for (std::size_t k = 0; k < 2; ++k) {
        const RigidBody& body = pair.world.bodies[k];
        if (body.is_static) continue;
        RigidState state = body.state;
        state.velocity = impact.bodies[k].velocity;
        state.angular_momentum = impact.bodies[k].angular_momentum;
        states[k == 0 ? c.body1 : c.body2] =
            fly(pair.world.settings, body, state, rest, pair.world.counters);
    }
}

// Whether contacts on different sides (`are_on_one_side`) got an impulse in the collision stage, as
// for a ball in the corner of a room that is a single body. These impacts have different times.
bool bounced_on_two_sides(const ContactProblem& problem, const ContactPair& pair)
{
    std::vector<Vector3d> normals;
    for (int i = pair.first; i < pair.last; ++i)
        if (const ContactConstraint& c = problem.contacts[i]; !c.collision_impulse.isZero(0))
            normals.push_back(c.normal);
    return std::any_of(normals.begin(), normals.end(),
                       [&](const Vector3d& n) { return !are_on_one_side(n, normals.front()); });
}

// Lets the pair bounce at its time of impact. Changes the states of the pair unless it returns
// nothing.
// @param is_alone  whether the step can be divided where one end hits before the other: no other
//                  pair of an island of few bodies got an impulse
// @param overlap   measures the overlap in `states`
// @param time      is set to the time of impact if it is before the end of this step [s]
// @return the contacts with their impulses; an empty list if the computed time of impact is not
//         before the end of this step; or nothing if no single bounce within the step was found
std::optional<std::vector<ContactRecord>>
bounce_at_impact(const World& world, const ContactProblem& problem, const ContactPair& contacts,
                 bool is_alone, std::vector<RigidState>& states, Overlap& overlap, double& time)
{
    if (bounced_on_two_sides(problem, contacts)) return std::nullopt;
    const double h = problem.time_step;
    const ContactConstraint& c = problem.contacts[contacts.first];
    const std::optional<Approach> approach = first_to_close(world, problem, contacts);
    if (!approach) return std::nullopt;
    if (approach->gap <= touching_gap * c.radius) return std::nullopt; // they hit at the start
    const double predicted = approach->closes();
    if (predicted >= h) { // in free flight, the bodies do not meet in this step
        fly_past(world, c, h, states);
        return std::vector<ContactRecord>();
    }

    std::optional<PairWorld> pair = pair_at_impact(world, c, *approach, h);
    if (!pair) return std::nullopt;
    const double rest = h - pair->time;
    if (rest * std::abs(approach->speed) <= touching_gap * c.radius) {
        fly_past(world, c, h, states); // the bodies meet at the end and bounce in the next step
        return std::vector<ContactRecord>();
    }
    ContactProblem impact = problem_at_impact(*pair, c.radius, rest);
    if (impact.islands.size() != 1) return std::nullopt;
    process_collisions(impact);
    std::vector<ContactRecord> records = records_of_bounce(impact, c);
    time = pair->time;
    if (records.empty()) return std::nullopt; // they would meet again in the rest of the step
    if (is_alone && has_later_hit(impact, c.radius)) return std::nullopt;
    const std::array before = {states[c.body1], states[c.body2]};
    fly_on(*pair, impact, c, rest, states);
    // The bounce may have turned the other end of a body into the other body.
    if (is_alone && overlap.depth(c.body1, c.body2) > nearly_touching_gap * c.radius) {
        states[c.body1] = before[0];
        states[c.body2] = before[1];
        time = 0;
        return std::nullopt;
    }
    return records;
}

// The pairs of an island that only bounced, and whose bodies that can move got no impulse from
// other bodies. If other pairs of the island got an impulse, a pair is kept only if its bodies that
// can move are balls. The reason: between bodies with corners, the contact at the impact magnifies
// the rounding errors that other bodies have caused in the states of the two bodies.
std::vector<const ContactPair*> lone_bounces(const World& world, const ContactProblem& problem,
                                             const Island& island)
{
    std::vector<const ContactPair*> lone;
    int pairs = 0; // how many pairs got an impulse
    for (const ContactPair& pair : island.pairs) {
        const bool is_loaded = carries_load(problem, pair);
        if (!is_loaded && !bounced(problem, pair)) continue;
        ++pairs;
        if (!is_loaded) lone.push_back(&pair);
    }
    if (pairs <= 1) return lone;
    const auto keep_if_both = [&](const auto& condition) { // static bodies need not satisfy it
        std::erase_if(lone, [&](const ContactPair* pair) {
            const ContactConstraint& c = problem.contacts[pair->first];
            const auto fails = [&](int i) {
                return !problem.bodies[i].is_static() && !condition(i);
            };
            return fails(c.body1) || fails(c.body2);
        });
    };
    keep_if_both([&](int i) { return world.bodies[i].is_ball(); });
    if (lone.empty()) return lone; // saves time in most piles
    std::map<int, int> pairs_of;   // for each body, how many pairs gave it an impulse
    for (const ContactPair& pair : island.pairs) {
        if (!bounced(problem, pair) && !carries_load(problem, pair)) continue;
        ++pairs_of[problem.contacts[pair.first].body1];
        ++pairs_of[problem.contacts[pair.first].body2];
    }
    keep_if_both([&](int i) { return pairs_of[i] == 1; });
    return lone;
}

} // namespace

bool bounced(const ContactProblem& problem, const ContactPair& pair)
{
    return std::any_of(problem.contacts.begin() + pair.first, problem.contacts.begin() + pair.last,
                       [](const ContactConstraint& c) { return !c.collision_impulse.isZero(0); });
}

bool carries_load(const ContactProblem& problem, const ContactPair& pair)
{
    return std::any_of(problem.contacts.begin() + pair.first, problem.contacts.begin() + pair.last,
                       [](const ContactConstraint& c) { return !c.contact_impulse.isZero(0); });
}

double time_of_impact(const World& world, const ContactProblem& problem, const ContactPair& pair)
{
    const std::optional<Approach> first = first_to_close(world, problem, pair);
    if (!first) return std::numeric_limits<double>::infinity();
    if (first->gap > touching_gap * problem.contacts[pair.first].radius) return first->closes();
    if (first->speed <= 0) return 0;
    // It opens, and closes again if v·n falls: speed t + ½ rate t² = 0.
    return first->rate < 0 ? 2 * first->speed / -first->rate
                           : std::numeric_limits<double>::infinity();
}

double first_bounce(const World& world, const ContactProblem& problem)
{
    double first = std::numeric_limits<double>::infinity();
    for (const Island& island : problem.islands) {
        first = std::min(first, island.first_moved);
        for (const ContactPair& pair : island.pairs)
            if (bounced(problem, pair))
                first = std::min(first, time_of_impact(world, problem, pair));
    }
    return first;
}

void bounce_at_impacts(const World& world, ContactProblem& problem, const std::vector<bool>& pulled,
                       const std::vector<Displacement>& displacements,
                       std::vector<RigidState>& states)
{
    Overlap overlap(world, states);
    for (Island& island : problem.islands) {
        if (std::none_of(island.pairs.begin(), island.pairs.end(),
                         [&](const ContactPair& pair) { return bounced(problem, pair); }))
            continue;
        const auto has_impulse = [&](const ContactPair& pair) {
            return bounced(problem, pair) || carries_load(problem, pair);
        };
        const bool is_only_pair =
            std::count_if(island.pairs.begin(), island.pairs.end(), has_impulse) == 1;
        for (const ContactPair* pair : lone_bounces(world, problem, island)) {
            const ContactConstraint& c = problem.contacts[pair->first];
            const auto moves_otherwise = [&](int i) {
                return pulled[i] || (!displacements.empty() && !displacements[i].is_zero());
            };
            if (moves_otherwise(c.body1) || moves_otherwise(c.body2)) continue;
            double time = 0;
            const bool is_alone = is_only_pair && island.bodies.size() <= few_bodies;
            const auto found =
                bounce_at_impact(world, problem, *pair, is_alone, states, overlap, time);
            if (!found && is_only_pair) island.lands_at = time;
            if (!found) continue;
            if (!found->empty()) island.first_moved = std::min(island.first_moved, time);
            island.moved_bounces.insert(island.moved_bounces.end(), found->begin(), found->end());
            for (int i = pair->first; i < pair->last; ++i)
                problem.contacts[i].collision_impulse.setZero();
        }
    }
}

} // namespace rigor
