// SPDX-License-Identifier: MIT
#include "stress/watch.hpp"

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/step/step.hpp"
#include "support/bench/bench.hpp"
#include "support/shapes/depth.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::stress {

namespace {

// A slab of triangles is measured as a box about the middle of its bounds.
Part measured(const Part& part)
{
    const Mesh* mesh = std::get_if<Mesh>(&part.shape);
    if (!mesh) return part;
    const Bounds& bounds = mesh->solid->bounds();
    Part box = part;
    box.shape = Box{bounds.high - bounds.low};
    box.position += rotation_matrix(part.orientation) * (bounds.high + bounds.low) / 2;
    return box;
}

double depth_of(const RigidBody& body1, const RigidBody& body2)
{
    const Pose pose1 = pose_of(body1.state);
    const Pose pose2 = pose_of(body2.state);
    double depth = 0;
    for (const Part& part1 : body1.parts)
        for (const Part& part2 : body2.parts) {
            const Part a = measured(part1), b = measured(part2);
            depth = std::max(depth, testing::overlap_depth(a.shape, part_pose(pose1, a), b.shape,
                                                           part_pose(pose2, b)));
        }
    return depth;
}

double radius_of(const RigidBody& body)
{
    double radius = 0;
    for (const Part& part : body.parts)
        radius = std::max(radius, bounding_radius(part));
    return radius;
}

} // namespace

bool Record::met() const
{
    return !checks.empty() && not_finite == 0 &&
           std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.met(); });
}

double kinetic_energy(const World& world)
{
    double energy = 0;
    for (const RigidBody& body : world.bodies) {
        const RigidState& s = body.state;
        const Vector3d L = rotation_matrix(s.orientation).transpose() * s.angular_momentum;
        energy +=
            body.mass * s.velocity.squaredNorm() / 2 + L.dot(body.inverse.inverse_inertia * L) / 2;
    }
    return energy;
}

double total_energy(const World& world)
{
    double energy = kinetic_energy(world);
    for (const RigidBody& body : world.bodies)
        if (!body.is_static) energy -= body.mass * world.settings.gravity.dot(body.state.position);
    return energy;
}

double lifting_energy(const World& world, double height)
{
    double mass = 0;
    for (const RigidBody& body : world.bodies)
        if (!body.is_static) mass += body.mass;
    return mass * world.settings.gravity.norm() * height;
}

double deepest_overlap(const World& world)
{
    const std::size_t n = world.bodies.size();
    std::vector<double> radii;
    for (const RigidBody& body : world.bodies)
        radii.push_back(radius_of(body));
    double depth = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const RigidBody &a = world.bodies[i], &b = world.bodies[j];
            if (a.is_static || (!b.is_static && j <= i)) continue; // count each pair once
            const double distance = (a.state.position - b.state.position).norm();
            if (distance < radii[i] + radii[j]) depth = std::max(depth, depth_of(a, b));
        }
    return depth;
}

Watch::Watch(World world, Record& record, double energy_scale)
    : world_(std::move(world)), start_(world_), record_(record), energy_(total_energy(world_)),
      energy_scale_(energy_scale > 0 ? energy_scale : kinetic_energy(world_))
{
    record_.penetration = std::max(record_.penetration, deepest_overlap(world_));
}

bool Watch::step_once(double time_step)
{
    try {
        record_.seconds += seconds([&] { step(world_, time_step); });
    } catch (const NonFiniteState&) {
        ++record_.not_finite;
        return false;
    }
    ++record_.steps;
    return true;
}

void Watch::run(int steps, double time_step, int every, const std::function<void()>& each)
{
    for (int i = 1; i <= steps; ++i) {
        if (!step_once(time_step)) return;
        const double gain = (total_energy(world_) - energy_) / energy_scale_;
        if (!std::isfinite(gain)) {
            ++record_.not_finite;
            return;
        }
        record_.energy_gain = std::max(record_.energy_gain, gain);
        if (i % every == 0 || i == steps)
            record_.penetration = std::max(record_.penetration, deepest_overlap(world_));
        if (each) each();
    }
}

void Watch::limit_penetration(double most)
{
    record_.limit("penetration [m]", record_.penetration, most, 'I');
}

void Watch::limit_energy(double most, char tolerance_class)
{
    record_.limit("energy gained", record_.energy_gain, most, tolerance_class);
}

double Watch::farthest_moved() const
{
    double moved = 0;
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
        const Vector3d d = world_.bodies[i].state.position - start_.bodies[i].state.position;
        if (!world_.bodies[i].is_static) moved = std::max(moved, d.norm());
    }
    return moved;
}

} // namespace rigor::stress
