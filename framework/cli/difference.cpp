// SPDX-License-Identifier: MIT
// The differences between two runs of a scene. A difference is reported if it exceeds a tolerance
// times the scale of the quantity. The scale is
// - for orientations 1 rad,
// - for other states, stresses and strains the largest value in the expected run,
// - for mass and inertia the body's own value,
// - for the center of mass its distance from the origin, but at least 1 m.
//
// Rigid bodies are compared first by their mass properties, then by their states in each frame.
// Deformable solids are compared by their meshes, then by the nodes and the elements that differ
// most.
#include "cli/difference.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rigor {

namespace {

std::string text(const Vector3d& v)
{
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x(), v.y(), v.z());
}

std::string text(const Quaternion& q)
{
    return fmt::format("({:.9g}; {:.9g}, {:.9g}, {:.9g})", q.s, q.v.x(), q.v.y(), q.v.z());
}

// Angle of the rotation from a to b [rad]; q and -q are the same orientation.
double angle(const Quaternion& a, const Quaternion& b)
{
    const double s = a.s * b.s + a.v.dot(b.v);
    const Vector3d v = a.s * b.v - b.s * a.v - a.v.cross(b.v);
    return 2 * std::atan2(v.norm(), std::abs(s));
}

void add(std::vector<Difference>& differences, Difference difference)
{
    if (!(difference.size <= difference.allowed)) differences.push_back(std::move(difference));
}

// Relative tolerance for stresses and strains, which are recorded as floats.
constexpr double same_float = 1e-6;

// Index at which two lists of the same size differ most.
template <class T, class Distance>
std::size_t farthest(const std::vector<T>& a, const std::vector<T>& b, const Distance& distance)
{
    std::size_t at = 0;
    for (std::size_t i = 1; i < a.size(); ++i)
        if (distance(a[i], b[i]) > distance(a[at], b[at])) at = i;
    return at;
}

double distance(const Vector3d& a, const Vector3d& b)
{
    return (a - b).norm();
}

double gap(float a, float b)
{
    return std::abs(static_cast<double>(a) - static_cast<double>(b));
}

std::string mesh_text(const SolidFrame& solid)
{
    return fmt::format("{} nodes, {} elements in {} pieces", solid.topology->nodes,
                       solid.topology->elements.size(), solid.topology->pieces);
}

} // namespace

Comparison::Comparison(Trajectory expected) : expected_(std::move(expected))
{
    for (const Frame& frame : expected_.frames)
        for (const RigidState& state : frame.bodies) {
            length_ = std::max(length_, state.position.norm());
            speed_ = std::max(speed_, state.velocity.norm());
            spin_ = std::max(spin_, state.angular_momentum.norm());
        }
    for (const Frame& frame : expected_.frames)
        for (const SolidFrame& solid : frame.solids) {
            for (std::size_t i = 0; i < solid.positions.size(); ++i) {
                length_ = std::max(length_, solid.positions[i].norm());
                speed_ = std::max(speed_, solid.velocities[i].norm());
            }
            for (std::size_t i = 0; i < solid.stresses.size(); ++i) {
                stress_ = std::max<double>(stress_, solid.stresses[i]);
                plastic_strain_ = std::max<double>(plastic_strain_, solid.plastic_strains[i]);
            }
        }
}

std::vector<Difference> Comparison::bodies(const std::vector<RecordedBody>& actual) const
{
    std::vector<Difference> result;
    for (std::size_t i = 0; i < expected_.bodies.size() && i < actual.size(); ++i) {
        const RecordedBody &a = expected_.bodies[i], &b = actual[i];
        const std::string& name = expected_.scene.bodies[i].name;
        add(result,
            {name, "mass [kg]", fmt::format("{:.9g}", a.mass), fmt::format("{:.9g}", b.mass),
             std::abs(a.mass - b.mass), same_within * a.mass});
        add(result, {name, "center of mass [m]", text(a.center_of_mass), text(b.center_of_mass),
                     (a.center_of_mass - b.center_of_mass).norm(),
                     same_within * std::max(1.0, a.center_of_mass.norm())});
        add(result, {name, "diagonal of I [kg m²]", text(Vector3d(a.inertia.diagonal())),
                     text(Vector3d(b.inertia.diagonal())), (a.inertia - b.inertia).norm(),
                     same_within * a.inertia.norm()});
    }
    return result;
}

void Comparison::compare_solid(std::vector<Difference>& differences, const std::string& name,
                               const SolidFrame& a, const SolidFrame& b) const
{
    if (a.topology->elements != b.topology->elements || a.topology->nodes != b.topology->nodes) {
        const double apart = std::abs(static_cast<double>(a.topology->elements.size()) -
                                      static_cast<double>(b.topology->elements.size()));
        differences.push_back(
            {name, "mesh, cracked otherwise", mesh_text(a), mesh_text(b), apart, 0});
        return; // different meshes have no common nodes and elements to compare
    }
    const auto compare = [&](const char* quantity, const std::vector<Vector3d>& x,
                             const std::vector<Vector3d>& y, double scale) {
        const std::size_t i = farthest(x, y, distance);
        add(differences, {fmt::format("{}, node {}", name, i), quantity, text(x[i]), text(y[i]),
                          distance(x[i], y[i]), same_within * scale});
    };
    const auto compare_elements = [&](const char* quantity, const std::vector<float>& x,
                                      const std::vector<float>& y, double scale) {
        const std::size_t i = farthest(x, y, gap);
        add(differences,
            {fmt::format("{}, element {}", name, i), quantity, fmt::format("{:.7g}", x[i]),
             fmt::format("{:.7g}", y[i]), gap(x[i], y[i]), same_float * scale});
    };
    compare("x [m]", a.positions, b.positions, length_);
    compare("v [m/s]", a.velocities, b.velocities, speed_);
    compare_elements("σ [Pa]", a.stresses, b.stresses, stress_);
    compare_elements("ε_p", a.plastic_strains, b.plastic_strains, plastic_strain_);
}

std::vector<Difference> Comparison::frame(const Frame& actual) const
{
    std::vector<Difference> result;
    const auto same_step = [&](const Frame& frame) { return frame.step == actual.step; };
    const auto found = std::find_if(expected_.frames.begin(), expected_.frames.end(), same_step);
    if (found == expected_.frames.end()) return result;
    for (std::size_t i = 0; i < found->bodies.size() && i < actual.bodies.size(); ++i) {
        const RigidState &a = found->bodies[i], &b = actual.bodies[i];
        const std::string& name = expected_.scene.bodies[i].name;
        const auto compare = [&](const char* quantity, const Vector3d& x, const Vector3d& y,
                                 double scale) {
            add(result, {name, quantity, text(x), text(y), (x - y).norm(), same_within * scale});
        };
        compare("X [m]", a.position, b.position, length_);
        add(result, {name, "q [rad]", text(a.orientation), text(b.orientation),
                     angle(a.orientation, b.orientation), same_within});
        compare("V [m/s]", a.velocity, b.velocity, speed_);
        compare("L [kg m²/s]", a.angular_momentum, b.angular_momentum, spin_);
    }
    for (std::size_t i = 0; i < found->solids.size() && i < actual.solids.size(); ++i)
        compare_solid(result, expected_.scene.solids[i].name, found->solids[i], actual.solids[i]);
    return result;
}

} // namespace rigor
