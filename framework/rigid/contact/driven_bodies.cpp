// SPDX-License-Identifier: MIT
// Chooses the frame in which an island is solved, then sets the velocities of the static and driven
// bodies that the island touches, for each stage. The change to an accelerated frame follows
// d'Alembert (1743, "Traité de dynamique").
#include "rigid/contact/driven_bodies.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace rigor {

namespace {

// The frame of a driven body; that of the world if its velocity changes only by rounding errors.
MovingFrame frame_of(const DrivenBody& driven)
{
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    const Vector3d &first = driven.first.linear, &mean = driven.mean.linear,
                   &last = driven.last.linear;
    const double most = rounding * (first.norm() + mean.norm() + last.norm());
    if ((mean - first).norm() <= most && (last - mean).norm() <= most) return {};
    return {mean - first, last - mean};
}

// The static and driven bodies that the island touches, in the order of their indices. Without a
// drive, all velocities of a body are zero.
std::vector<DrivenBody> touched_grounds(const ContactProblem& problem, const Island& island)
{
    std::set<int> touched;
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& c = problem.contacts[pair.first];
        for (const int i : {c.body1, c.body2})
            if (problem.bodies[i].is_static()) touched.insert(i);
    }
    std::vector<DrivenBody> grounds;
    for (const int i : touched) {
        const DrivenBody* driven = problem.drive_of(i);
        grounds.push_back(driven ? *driven : DrivenBody{i, {}, {}, {}});
    }
    return grounds;
}

// The normals of the contacts of the island with a static or driven body, without those that are
// open now and stay open if there are no impulses.
std::vector<Vector3d> closed_normals(const ContactProblem& problem, const Island& island,
                                     int ground)
{
    std::vector<Vector3d> normals;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            if (c.body1 != ground && c.body2 != ground) continue;
            const double gap = std::min(c.gap, problem.predicted_gap(c, c.free_speed));
            if (gap <= nearly_touching_gap * c.radius) normals.push_back(c.normal);
        }
    return normals;
}

// Whether the velocity of the body `ground` along the normals of its contacts with the island, as
// seen from the frame, stays the same during the step.
bool has_steady_normals(const ContactProblem& problem, const Island& island,
                        const MovingFrame& frame, const DrivenBody& ground)
{
    constexpr double rounding = 1e-9; // relative to the changes of the velocity of the frame
    const MovingFrame own = frame_of(ground);
    const Vector3d first = own.mean_minus_first - frame.mean_minus_first,
                   last = own.last_minus_mean - frame.last_minus_mean;
    const double most = rounding * (frame.mean_minus_first.norm() + frame.last_minus_mean.norm());
    const std::vector<Vector3d> normals = closed_normals(problem, island, ground.body);
    return std::all_of(normals.begin(), normals.end(), [&](const Vector3d& n) {
        return std::max(std::abs(n.dot(first)), std::abs(n.dot(last))) <= most;
    });
}

MovingFrame choose_frame(const ContactProblem& problem, const Island& island)
{
    const std::vector<DrivenBody> grounds = touched_grounds(problem, island);
    for (const DrivenBody& driven : grounds) {
        const MovingFrame frame = frame_of(driven);
        if (frame.is_world()) continue;
        const bool is_steady =
            std::all_of(grounds.begin(), grounds.end(), [&](const DrivenBody& ground) {
                return has_steady_normals(problem, island, frame, ground);
            });
        if (is_steady) return frame;
    }
    return {};
}

// For contacts with static and driven bodies, adds to `force_speed` the mean change of v·n over the
// step by the fictitious force of the island's frame.
// @param sign  1, or -1 to subtract it again
void add_fictitious_force(ContactProblem& problem, const Island& island, double sign)
{
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            ContactConstraint& c = problem.contacts[i];
            const bool is_static1 = problem.bodies[c.body1].is_static();
            if (!is_static1 && !problem.bodies[c.body2].is_static()) continue;
            const Vector3d n = is_static1 ? Vector3d(-c.normal) : c.normal;
            c.force_speed -= sign * n.dot(island.frame.mean_minus_first);
        }
}

void enter_frame(ContactProblem& problem, const Island& island)
{
    for (const int i : island.bodies)
        problem.bodies[i].velocity += island.frame.mean_minus_first;
    add_fictitious_force(problem, island, 1);
}

// Gives bodies and contacts their velocities in the world again.
// @param before_forces  the bodies before the forces
void leave_frame(ContactProblem& problem, std::vector<Body>& before_forces, Island& island)
{
    for (const int i : island.bodies) {
        before_forces[i].velocity -= island.frame.mean_minus_first;
        problem.bodies[i].velocity += island.frame.last_minus_mean;
    }
    add_fictitious_force(problem, island, -1);
    island.frame = {};
}

// The bodies of an island that touch a static or driven body: their mean velocity, and the mean
// normal of their contacts. A body with several contacts counts once for each of its contacts.
struct Touching {
    Vector3d velocity = Vector3d::Zero(); // without the part of v₁ - v₂ along the normal [m/s]
    Vector3d normal = Vector3d::Zero();   // unit, away from the static or driven body; or zero
};

Touching touching(const ContactProblem& problem, std::span<const Body> before_forces,
                  const Island& island, int ground)
{
    Touching mean;
    int count = 0;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            if (c.body1 != ground && c.body2 != ground) continue;
            const bool is_first = c.body1 == ground;
            const double v_n = problem.velocity_between(before_forces, c, c.point).dot(c.normal);
            const Vector3d n = is_first ? Vector3d(-c.normal) : c.normal;
            mean.velocity += before_forces[is_first ? c.body2 : c.body1].velocity - v_n * n;
            mean.normal += n;
            ++count;
        }
    if (count > 0) mean.velocity /= count;
    const double length = mean.normal.norm();
    if (length > 0) mean.normal /= length;
    return mean;
}

// Whether a driven body gave the island an impulse.
bool is_held(const ContactProblem& problem, const Island& island)
{
    for (const ContactPair& pair : island.pairs) {
        const ContactConstraint& lowest = problem.contacts[pair.first];
        if (!problem.drive_of(lowest.body1) && !problem.drive_of(lowest.body2)) continue;
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            if (!c.collision_impulse.isZero(0) || problem.holds(c)) return true;
        }
    }
    return false;
}

// The static and driven bodies that the island touches and that do not move with their mean
// velocities along the surface: in the world the driven ones, in a moving frame all of them.
std::vector<DrivenBody> moving_grounds(const ContactProblem& problem, const Island& island)
{
    std::vector<DrivenBody> grounds;
    if (problem.driven.empty()) return grounds;
    grounds = touched_grounds(problem, island);
    if (island.frame.is_world())
        std::erase_if(grounds,
                      [&](const DrivenBody& ground) { return !problem.drive_of(ground.body); });
    return grounds;
}

// Sets the velocity of a static or driven body: along the unit vector n its mean velocity, and
// perpendicular to n the velocity V.
void set_velocity(ContactProblem& problem, const DrivenBody& ground, const Vector3d& n,
                  const Vector3d& V)
{
    const Vector3d more = V - ground.mean.linear;
    problem.bodies[ground.body].velocity = ground.mean.linear + more - n.dot(more) * n;
}

} // namespace

void enter_moving_frames(ContactProblem& problem)
{
    if (problem.driven.empty()) return;
    for (Island& island : problem.islands) {
        island.frame = choose_frame(problem, island);
        if (!island.frame.is_world()) enter_frame(problem, island);
    }
}

bool is_steady_in_frame(const ContactProblem& problem, const Island& island, int body)
{
    constexpr double rounding = 1e-9; // relative to the changes of the velocity of the body
    const DrivenBody* driven = problem.drive_of(body);
    const MovingFrame own = driven ? frame_of(*driven) : MovingFrame{}, &frame = island.frame;
    const double most = rounding * (own.mean_minus_first.norm() + own.last_minus_mean.norm());
    return (own.mean_minus_first - frame.mean_minus_first).norm() <= most &&
           (own.last_minus_mean - frame.last_minus_mean).norm() <= most;
}

void leave_unheld_frames(ContactProblem& problem, std::vector<Body>& before_forces)
{
    for (Island& island : problem.islands)
        if (!island.frame.is_world() && !is_held(problem, island))
            leave_frame(problem, before_forces, island);
}

void leave_moving_frames(ContactProblem& problem, std::vector<Body>& before_forces)
{
    for (Island& island : problem.islands)
        if (!island.frame.is_world()) leave_frame(problem, before_forces, island);
}

void set_velocities_at_start(ContactProblem& problem, const Island& island)
{
    for (const DrivenBody& ground : moving_grounds(problem, island)) {
        const Vector3d n = touching(problem, problem.bodies, island, ground.body).normal;
        if (n.isZero(0)) continue;
        set_velocity(problem, ground, n, ground.first.linear + island.frame.mean_minus_first);
    }
}

void set_velocities_at_end(ContactProblem& problem, const Island& island,
                           std::span<const Body> before_forces)
{
    for (const DrivenBody& ground : moving_grounds(problem, island)) {
        const auto [V, n] = touching(problem, before_forces, island, ground.body);
        if (n.isZero(0)) continue;
        const Vector3d V_d = ground.last.linear - island.frame.last_minus_mean;
        const Vector3d carried = problem.time_step * ground.mean.angular.cross(V - V_d);
        set_velocity(problem, ground, n, V_d + carried);
    }
}

void reset_velocities(ContactProblem& problem, const Island& island)
{
    for (const DrivenBody& ground : moving_grounds(problem, island))
        problem.bodies[ground.body].velocity = ground.mean.linear;
}

} // namespace rigor
