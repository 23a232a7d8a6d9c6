// SPDX-License-Identifier: MIT
#include "rigid/broad_phase.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

int widest_axis(const std::vector<int>& bodies, const std::vector<Bounds>& bounds)
{
    Vector3d sum = Vector3d::Zero(), squares = Vector3d::Zero();
    for (int i : bodies) {
        const Vector3d center = (bounds[i].low + bounds[i].high) / 2;
        sum += center;
        squares += center.cwiseAbs2();
    }
    int axis = 0;
    (squares - sum.cwiseAbs2() / std::max<double>(1, static_cast<double>(bodies.size())))
        .maxCoeff(&axis);
    return axis;
}

void sweep(const World& world, std::vector<int>& bodies, const std::vector<Bounds>& bounds,
           std::vector<BodyPair>& pairs)
{
    const int axis = widest_axis(bodies, bounds);
    std::sort(bodies.begin(), bodies.end(), [&](int i, int j) {
        const double a = bounds[i].low[axis], b = bounds[j].low[axis];
        return a < b || (a == b && i < j);
    });
    std::vector<int> open; // those whose bounds the sweep is inside of
    for (int i : bodies) {
        const double low = bounds[i].low[axis];
        std::erase_if(open, [&](int j) { return bounds[j].high[axis] < low; });
        for (int j : open)
            if (!(world.bodies[i].is_static && world.bodies[j].is_static) &&
                bounds[i].overlaps(bounds[j]))
                pairs.push_back({std::min(i, j), std::max(i, j)});
        open.push_back(i);
    }
}

// Whether anything of a body without bounds comes near `bounds`.
bool reaches(const RigidBody& endless, const Pose& pose, const Bounds& bounds)
{
    const Vector3d center = (bounds.low + bounds.high) / 2;
    const Vector3d extent = (bounds.high - bounds.low) / 2;
    return std::any_of(endless.parts.begin(), endless.parts.end(), [&](const Part& part) {
        const Pose placed = part_pose(pose, part);
        if (!is_plane(part)) return bounds.overlaps(bounds_of(part.shape, placed));
        const Vector3d n = placed.R.col(1);
        return n.dot(center - placed.X) - n.cwiseAbs().dot(extent) <= 0;
    });
}

} // namespace

std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds, Counters& counters)
{
    std::vector<int> bounded, endless;
    std::uint64_t fixed = 0;
    const int n = static_cast<int>(world.bodies.size());
    for (int i = 0; i < n; ++i) {
        (bounds[i].high.allFinite() ? bounded : endless).push_back(i);
        fixed += world.bodies[i].is_static;
    }
    const auto pairs_among = [](std::uint64_t bodies) {
        return bodies < 2 ? 0 : bodies * (bodies - 1) / 2;
    };
    counters.pairs_possible += pairs_among(world.bodies.size()) - pairs_among(fixed);

    std::vector<BodyPair> pairs;
    sweep(world, bounded, bounds, pairs);
    for (int i : endless)
        for (int j : bounded)
            if (!world.bodies[j].is_static && reaches(world.bodies[i], poses[i], bounds[j]))
                pairs.push_back({std::min(i, j), std::max(i, j)});
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace rigor
