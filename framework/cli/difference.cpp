// SPDX-License-Identifier: MIT
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

// Angle of the rotation from a to b; q and -q are the same orientation.
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

} // namespace

Comparison::Comparison(Trajectory expected) : expected_(std::move(expected))
{
    for (const Frame& frame : expected_.frames)
        for (const RigidState& state : frame.bodies) {
            length_ = std::max(length_, state.position.norm());
            speed_ = std::max(speed_, state.velocity.norm());
            spin_ = std::max(spin_, state.angular_momentum.norm());
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
    return result;
}

} // namespace rigor
