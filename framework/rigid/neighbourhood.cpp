// SPDX-License-Identifier: MIT
#include "rigid/neighbourhood.hpp"

#include "rigid/broad_phase.hpp"
#include "rigid/groups.hpp"

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

// A body at rest may be hit in this step, and then move as fast as whatever moves fastest among those
// it could be hit by, hand to hand; but looking farther than half its radius is never needed.
std::vector<double> margins_of(const World& world, const std::vector<BodyPair>& pairs,
                               const std::vector<double>& travels, const std::vector<double>& radii)
{
    Groups groups(world.bodies.size());
    for (const auto& [i, j] : pairs)
        if (!world.bodies[i].is_still() && !world.bodies[j].is_still()) groups.join(i, j);
    std::vector<double> farthest(world.bodies.size(), 0.0), margins;
    for (std::size_t i = 0; i < farthest.size(); ++i) {
        double& travelled = farthest[groups.of(static_cast<int>(i))];
        travelled = std::max(travelled, travels[i]);
    }
    for (std::size_t i = 0; i < farthest.size(); ++i)
        margins.push_back(std::min(farthest[groups.of(static_cast<int>(i))], radii[i] / 2));
    return margins;
}

} // namespace

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
        if (!body.is_still()) bounds.back().include(body_bounds(body, pose_of(flown[i])));
        radii.push_back(body.is_static ? 0 : body_radius(body));
        travels.push_back(body.is_still() ? 0
                                          : travel(body.state, flown[i], radii.back(), time_step));
        wide.push_back(bounds.back());
        wide.back().grow(radii.back() / 2);
    }
    const std::vector<BodyPair> pairs = near_pairs(world, poses, wide, counters);
    Neighbourhood near;
    near.margins = margins_of(world, pairs, travels, radii);
    near.radii = radii;
    bool any_may_meet = false;
    for (const auto& [i, j] : pairs) {
        const double margin = near.margins[i] + near.margins[j];
        Bounds reach = bounds[i];
        reach.grow(margin);
        if (!reach.overlaps(bounds[j])) continue;
        ++counters.pairs_tested;
        const double path = travels[i] + travels[j];
        const std::size_t first = near.contacts.size();
        find_contacts(world, poses, i, j, path + margin, near.contacts, counters);
        bool may_meet = false;
        for (std::size_t k = first; k < near.contacts.size(); ++k)
            may_meet |= near.contacts[k].gap < path;
        any_may_meet |= may_meet;
        for (int sleeping : {i, j}) {
            if (!world.bodies[sleeping].rest.is_asleep()) continue;
            if (may_meet) near.disturbed.push_back(sleeping);
            near.contacts.resize(first);
        }
    }
    if (!any_may_meet) near.contacts.clear(); // then no formula of collisions is needed
    return near;
}

} // namespace rigor
