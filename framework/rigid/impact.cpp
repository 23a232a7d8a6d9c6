// SPDX-License-Identifier: MIT
#include "rigid/impact.hpp"

#include "geometry/shapes/pose.hpp"
#include "rigid/collisions.hpp"
#include "rigid/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr int most_tries = 8;
constexpr double touching = 1e-10; // a gap, of the radius

// The two bodies alone, at some moment of the step.
struct Meeting {
    World world;
    double time = 0, gap = 0; // since the step's start; the smallest
    std::vector<Contact> contacts;
};

// v·n and its rate, of the contact of the pair that closes first, and its gap.
struct Approach {
    double gap = 0, speed = 0, rate = 0;

    // When the gap closes, gap + speed t + ½ rate t² = 0.
    double closes() const
    {
        if (gap <= 0) return 0;
        const double root = speed * speed - 2 * rate * gap;
        if (root < 0) return std::numeric_limits<double>::infinity();
        const double divisor = -speed + std::sqrt(root);
        return divisor > 0 ? 2 * gap / divisor : std::numeric_limits<double>::infinity();
    }
};

Approach first_to_close(const World& world, const ContactProblem& problem, const ContactPair& pair)
{
    Approach first;
    double earliest = std::numeric_limits<double>::infinity();
    for (int i = pair.first; i < pair.last; ++i) {
        const SolvedContact& c = problem.contacts[i];
        const auto velocity = [&](int body) -> Vector3d {
            const RigidBody& b = world.bodies[body];
            if (b.is_static) return Vector3d::Zero();
            const Vector3d w =
                inverse_inertia(world.integrator, b, b.state) * b.state.angular_momentum;
            return b.state.velocity + w.cross(c.point - b.state.position);
        };
        const double speed = (velocity(c.body1) - velocity(c.body2)).dot(c.normal);
        const Approach approach{c.gap, speed, c.force_speed / problem.time_step};
        const double time = approach.closes();
        if (time >= earliest) continue;
        earliest = time;
        first = approach;
    }
    return first;
}

Meeting meeting_at(const World& world, const SolvedContact& c, double time, double reach)
{
    Meeting meeting;
    meeting.world.gravity = world.gravity;
    meeting.world.integrator = world.integrator;
    meeting.world.contact_method = world.contact_method;
    meeting.world.formulas_are_reference = world.formulas_are_reference;
    meeting.world.skips = world.skips;
    meeting.world.skips.warm_start = false;
    meeting.time = time;
    std::vector<Pose> poses;
    Counters uncounted;
    for (int i : {c.body1, c.body2}) {
        RigidBody& body = meeting.world.bodies.emplace_back(world.bodies[i]);
        if (!body.is_static && time > 0) body.state = fly(world, body, body.state, time, uncounted);
        poses.push_back(pose_of(body.state));
    }
    find_contacts(meeting.world, poses, 0, 1, reach, meeting.contacts);
    meeting.gap = reach;
    for (const Contact& contact : meeting.contacts)
        meeting.gap = std::min(meeting.gap, contact.gap);
    return meeting;
}

} // namespace

std::optional<std::vector<ContactRecord>> bounce_at_impact(const World& world,
                                                           const ContactProblem& problem,
                                                           const ContactPair& pair,
                                                           std::vector<RigidState>& states)
{
    const double h = problem.time_step;
    const SolvedContact& c = problem.contacts[pair.first];
    const Approach approach = first_to_close(world, problem, pair);
    const double predicted = approach.closes();
    if (!(predicted > 0)) return std::nullopt;
    if (predicted >=
        h) { // it falls more slowly than at the step's last speed: they do not meet yet
        Counters uncounted;
        for (int i : {c.body1, c.body2})
            if (const RigidBody& body = world.bodies[i]; !body.is_static)
                states[i] = fly(world, body, body.state, h, uncounted);
        return std::vector<ContactRecord>();
    }

    // secant steps towards gap = 0
    const double reach = 2 * std::abs(approach.gap) + c.radius;
    double time = predicted, before = 0, gap_before = approach.gap;
    Meeting meeting = meeting_at(world, c, time, reach);
    for (int i = 0; i < most_tries && std::abs(meeting.gap) > touching * c.radius; ++i) {
        const double slope = (meeting.gap - gap_before) / (time - before);
        if (!(slope < 0)) return std::nullopt;
        before = time;
        gap_before = meeting.gap;
        time = std::clamp(time - meeting.gap / slope, 0.0, h);
        if (time == before) break;
        meeting = meeting_at(world, c, time, reach);
    }
    if (std::abs(meeting.gap) > 1e-6 * c.radius) return std::nullopt;

    // the collision there, of the points that close within the rest of the step
    World& pair_world = meeting.world;
    const double rest = h - time;
    Counters uncounted; // the bounce was counted already
    std::vector<RigidState> flown;
    Neighbourhood near;
    near.contacts = std::move(meeting.contacts);
    near.margins.assign(2, std::numeric_limits<double>::infinity());
    near.radii.assign(2, c.radius);
    for (std::size_t k = 0; k < 2; ++k) {
        const RigidBody& body = pair_world.bodies[k];
        near.poses.push_back(pose_of(body.state));
        if (body.is_static) near.radii[k] = 0;
        flown.push_back(body.is_static ? body.state
                                       : fly(pair_world, body, body.state, rest, uncounted));
    }
    Team alone;
    ContactProblem impact = contact_problem(pair_world, flown, near, rest, uncounted, alone);
    if (impact.islands.size() != 1) return std::nullopt;
    process_collisions(impact, impact.islands[0]);

    std::vector<ContactRecord> records;
    for (const SolvedContact& hit : impact.contacts) {
        const double v_n = impact.velocity_at(hit, hit.point).dot(hit.normal) + hit.force_speed;
        if (impact.predicted_gap(hit, v_n) < -touching * c.radius)
            return std::nullopt; // meets again
        if (!hit.bounce.isZero(0))
            records.push_back({c.body1, c.body2, hit.point, hit.normal, -hit.gap, hit.bounce});
    }
    if (records.empty()) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) {
        const RigidBody& body = pair_world.bodies[k];
        if (body.is_static) continue;
        RigidState state = body.state;
        state.velocity = impact.bodies[k].velocity;
        state.angular_momentum = impact.bodies[k].angular_momentum;
        states[k == 0 ? c.body1 : c.body2] = fly(pair_world, body, state, rest, uncounted);
    }
    return records;
}

} // namespace rigor
