// SPDX-License-Identifier: MIT
// Computes the prescribed velocities of held nodes from the paths of their handles, and the
// forces of gravity and loads on nodes. A path is interpolated linearly between its moments.
#include "deformable/solid/handles.hpp"

#include <algorithm>

namespace rigor {

namespace {

// The displacement and rotation of a path at a time: interpolated linearly between two of the times
// that the path lists, and constant before the first and after the last of them. The path is not
// empty.
HandleMoment moment_at(const std::vector<HandleMoment>& path, double time)
{
    const auto after = std::upper_bound(path.begin(), path.end(), time,
                                        [](double t, const HandleMoment& m) { return t < m.time; });
    if (after == path.begin()) return path.front();
    if (after == path.end()) return path.back();
    const HandleMoment &a = after[-1], &b = *after;
    const double s = (time - a.time) / (b.time - a.time);
    return {time, a.displacement + s * (b.displacement - a.displacement),
            a.rotation + s * (b.rotation - a.rotation)};
}

Matrix3d rotation_by(const Vector3d& axis_times_angle)
{
    const double angle = axis_times_angle.norm();
    if (angle == 0) return Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, axis_times_angle / angle).toRotationMatrix();
}

} // namespace

void remember_first_places(Deformable& solid)
{
    for (Handle& handle : solid.handles) {
        if (handle.first_places.size() == handle.nodes.size()) continue;
        handle.first_places.clear();
        for (const int node : handle.nodes)
            handle.first_places.push_back(solid.positions[node]);
    }
}

void hold_nodes(const Deformable& solid, double time, double time_step, std::vector<HeldNode>& held,
                std::vector<int>& entries)
{
    held.clear();
    entries.assign(solid.positions.size(), -1); // for each node, its index in `held`
    for (const Handle& handle : solid.handles) {
        if (time > handle.release) continue;
        HandleMoment moment;
        if (!handle.path.empty()) moment = moment_at(handle.path, time);
        const Matrix3d R = rotation_by(moment.rotation);
        for (std::size_t k = 0; k < handle.nodes.size(); ++k) {
            const int node = handle.nodes[k];
            const Vector3d place =
                handle.path.empty() ? handle.first_places[k]
                                    : handle.pivot + R * (handle.first_places[k] - handle.pivot) +
                                          moment.displacement;
            if (entries[node] < 0) {
                entries[node] = static_cast<int>(held.size());
                held.push_back({node, {}, Vector3d::Zero()});
            }
            HeldNode& entry = held[entries[node]];
            for (int axis = 0; axis < 3; ++axis) {
                if (!handle.axes[axis]) continue;
                entry.axes[axis] = true;
                entry.velocity[axis] = (place[axis] - solid.positions[node][axis]) / time_step;
            }
        }
    }
}

void move_held(const std::vector<HeldNode>& held, std::vector<Vector3d>& velocities)
{
    for (const HeldNode& h : held)
        for (int axis = 0; axis < 3; ++axis)
            if (h.axes[axis]) velocities[h.node][axis] = h.velocity[axis];
}

void add_loads(const Deformable& solid, const Vector3d& gravity, double time,
               std::vector<Vector3d>& forces)
{
    for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] += solid.masses[i] * gravity;
    for (const NodeLoad& load : solid.loads)
        if (time >= load.start && time < load.end)
            for (const int node : load.nodes)
                forces[node] += load.force / static_cast<double>(load.nodes.size());
}

} // namespace rigor
