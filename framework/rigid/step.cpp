// SPDX-License-Identifier: MIT
#include "rigid/broad_phase.hpp"
#include "rigid/collisions.hpp"
#include "rigid/contact_problem.hpp"
#include "rigid/flight.hpp"
#include "rigid/forces.hpp"
#include "rigid/groups.hpp"
#include "rigid/non_finite.hpp"
#include "rigid/resting_contact.hpp"
#include "rigid/world.hpp"

#include <algorithm>

namespace rigor {

namespace {

double body_radius(const RigidBody& body)
{
    double radius = 0;
    for (const Part& part : body.parts)
        radius = std::max(radius, bounding_radius(part));
    return radius;
}

Bounds body_bounds(const RigidBody& body, const Pose& pose)
{
    Bounds bounds;
    for (const Part& part : body.parts)
        bounds.include(bounds_of(part.shape, part_pose(pose, part)));
    return bounds;
}

Pose pose_of(const RigidState& state)
{
    return {rotation_matrix(state.orientation), state.position};
}

// How far the points of a body move at most in the step, along its path or with its last velocity [m].
// An angle α is |Δq| ≈ α/2; a quarter more for the chord and for an axis that tumbles.
double travel(const RigidState& from, const RigidState& to, double radius, double time_step)
{
    const Quaternion &p = from.orientation, &q = to.orientation;
    const double same = (p.s - q.s) * (p.s - q.s) + (p.v - q.v).squaredNorm();
    const double opposite = (p.s + q.s) * (p.s + q.s) + (p.v + q.v).squaredNorm();
    const double moved = (to.position - from.position).norm();
    return std::max(moved, time_step * to.velocity.norm()) +
           2.5 * std::sqrt(std::min(same, opposite)) * radius;
}

// Contacts to look at, none if no bodies are near enough to meet in this step, and how far apart bodies may be predicted to stay and still matter [m].
struct Neighbourhood {
    std::vector<Contact> contacts;
    std::vector<double> margins; // of each body
};

// A body at rest may be hit in this step, and then move as fast as whatever moves fastest among those
// it could be hit by, hand to hand; but looking farther than half its radius is never needed.
std::vector<double> margins_of(const World& world, const std::vector<BodyPair>& pairs,
                               const std::vector<double>& travels, const std::vector<double>& radii)
{
    Groups groups(world.bodies.size());
    for (const auto& [i, j] : pairs)
        if (!world.bodies[i].is_static && !world.bodies[j].is_static) groups.join(i, j);
    std::vector<double> farthest(world.bodies.size(), 0.0), margins;
    for (std::size_t i = 0; i < farthest.size(); ++i) {
        double& travelled = farthest[groups.of(static_cast<int>(i))];
        travelled = std::max(travelled, travels[i]);
    }
    for (std::size_t i = 0; i < farthest.size(); ++i)
        margins.push_back(std::min(farthest[groups.of(static_cast<int>(i))], radii[i] / 2));
    return margins;
}

Neighbourhood neighbourhood(const World& world, std::span<const RigidState> flown, double time_step,
                            Counters& counters)
{
    std::vector<Pose> poses;
    std::vector<Bounds> bounds, wide;
    std::vector<double> travels, radii;
    for (std::size_t i = 0; i < flown.size(); ++i) {
        const RigidBody& body = world.bodies[i];
        poses.push_back(pose_of(body.state));
        bounds.push_back(body_bounds(body, poses.back()));
        if (!body.is_static) bounds.back().include(body_bounds(body, pose_of(flown[i])));
        radii.push_back(body.is_static ? 0 : body_radius(body));
        travels.push_back(travel(body.state, flown[i], radii.back(), time_step));
        wide.push_back(bounds.back());
        wide.back().grow(radii.back() / 2);
    }
    const std::vector<BodyPair> pairs = near_pairs(world, poses, wide, counters);
    Neighbourhood near;
    near.margins = margins_of(world, pairs, travels, radii);
    bool any_may_meet = false;
    for (const auto& [i, j] : pairs) {
        const double margin = near.margins[i] + near.margins[j];
        Bounds reach = bounds[i];
        reach.grow(margin);
        if (!reach.overlaps(bounds[j])) continue;
        ++counters.pairs_tested;
        const double path = travels[i] + travels[j];
        const std::size_t first = near.contacts.size();
        find_contacts(world, poses, i, j, path + margin, near.contacts);
        for (std::size_t k = first; k < near.contacts.size(); ++k)
            any_may_meet |= near.contacts[k].gap < path;
    }
    if (!any_may_meet) near.contacts.clear(); // then no formula of collisions is needed
    return near;
}

// Which stages gave a body an impulse.
struct Impulses {
    std::vector<bool> bounced, held;
};

Impulses impulses_of(const ContactProblem& problem)
{
    const std::size_t n = problem.bodies.size();
    Impulses impulses{std::vector<bool>(n, false), std::vector<bool>(n, false)};
    for (const SolvedContact& c : problem.contacts)
        for (int i : {c.body1, c.body2}) {
            if (!c.bounce.isZero(0)) impulses.bounced[i] = true;
            if (!c.holding.isZero(0)) impulses.held[i] = true;
        }
    return impulses;
}

// Velocities: what the forces did to the momentum of a body in flight, they do to it here.
void add_forces(ContactProblem& problem, const Island& island, const World& world,
                std::span<const RigidState> flown)
{
    for (int i : island.bodies) {
        Body& body = problem.bodies[i];
        const RigidState& start = world.bodies[i].state;
        const Vector3d dL = flown[i].angular_momentum - start.angular_momentum;
        body.velocity += flown[i].velocity - start.velocity;
        body.angular_momentum += dL;
        body.angular_velocity += body.inverse_inertia * dL;
    }
}

// Positions. A body that only bounced flies on from there, with gravity in its integrator; a body
// that is held drifts with the velocity it has.
void move(const World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
          const std::vector<Body>& bounced, std::vector<RigidState>& states, Counters& counters)
{
    const Impulses impulses = impulses_of(problem);
    for (const Island& island : problem.islands)
        for (int i : island.bodies) {
            if (!impulses.bounced[i] && !impulses.held[i]) continue; // its flight was its motion
            --counters.free_flights;
            const bool flies = !impulses.held[i] && !pulled[i];
            const Body& body = flies ? bounced[i] : problem.bodies[i];
            RigidState state = world.bodies[i].state;
            state.velocity = body.velocity;
            state.angular_momentum = body.angular_momentum;
            require_finite(world.bodies[i], state, world.time + problem.time_step);
            states[i] = fly(world, world.bodies[i], state, problem.time_step, counters, !flies);
        }
}

std::vector<ContactRecord> records_of(const ContactProblem& problem)
{
    std::vector<ContactRecord> records;
    for (const SolvedContact& c : problem.contacts) {
        const Vector3d impulse = c.bounce + c.holding;
        if (impulse.isZero(0)) continue;
        records.push_back({c.body1, c.body2, c.point, c.normal, -c.gap, impulse});
    }
    return records;
}

} // namespace

std::vector<ContactRecord> step(World& world, double time_step)
{
    Counters& counters = world.counters;
    const double end = world.time + time_step;
    const std::vector<bool> pulled = pulled_bodies(world, time_step);
    std::vector<RigidState> states = fly_all(world, pulled, time_step, counters);
    for (std::size_t i = 0; i < states.size(); ++i) {
        require_finite(world.bodies[i], states[i], end);
        if (!world.bodies[i].is_static) ++counters.free_flights;
    }

    std::vector<ContactRecord> records;
    if (world.bodies.size() > 1) {
        const Neighbourhood near = neighbourhood(world, states, time_step, counters);
        if (!near.contacts.empty()) {
            ContactProblem problem =
                contact_problem(world, states, near.margins, near.contacts, time_step, counters);
            for (const Island& island : problem.islands)
                process_collisions(problem, island);
            const std::vector<Body> bounced = problem.bodies;
            for (const Island& island : problem.islands) {
                add_forces(problem, island, world, states);
                process_contact(problem, island);
            }
            move(world, problem, pulled, bounced, states, counters);
            records = records_of(problem);
            counters.contacts += records.size();
        }
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
        require_finite(world.bodies[i], states[i], end);
        world.bodies[i].state = states[i];
    }
    world.time = end;
    ++counters.steps;
    return records;
}

} // namespace rigor
