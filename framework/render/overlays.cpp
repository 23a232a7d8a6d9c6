// SPDX-License-Identifier: MIT
// Overlays: arrows, dots, coils and texts that explain a frame. The length of an arrow for a
// rotation or an impulse of size x saturates as x / (x + h), which is ½ at x = h, so that small and
// large values can be seen together.
#include "render/overlays.hpp"

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "render/colors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rigor {
namespace {

/// A function that grows with `value`, is 1/2 at `half` and stays below 1.
double saturated(double value, double half)
{
    return value / (value + half);
}

/// The height of the top of a body [m].
double top(const std::vector<Part>& parts, const Pose& body)
{
    Bounds bounds;
    for (const Part& part : parts)
        bounds.include(bounds_of(part.shape, part_pose(body, part)));
    return bounds.high.y();
}

} // namespace

void add_arrows(Picture& picture, const DrawnBody& body, const RigidState& state,
                const Overlays& overlays, float thickness)
{
    if (body.is_static || !in_sight(state.position)) return;
    const Matrix3d R = rotation_matrix(state.orientation);
    const Vector3f center = state.position.cast<float>();
    const auto arrow = [&](const Vector3d& v, float factor, const Vector4f& color) {
        add_arrow(picture, center, (state.position + v).cast<float>(), factor * thickness, color);
    };
    if (overlays.axes) {
        const std::array<Vector4f, 3> color = {colors::axis_x, colors::axis_y, colors::axis_z};
        for (int i = 0; i < 3; ++i)
            arrow(1.2 * body.radius * R.col(i), 0.8F, color[i]);
    }
    // Lengths saturate, so that a slow rotation can be seen and a fast one stays in the picture.
    // The arrow of L shows |L| divided by the mean inertia, which is comparable with |ω|. It is
    // thinner and longer than an arrow of ω would be, so that both can be seen if they are
    // parallel.
    constexpr double half = 2; // |ω| or |L| / mean inertia at which `saturated` is ½ [rad/s]
    const Vector3d& L = state.angular_momentum;
    const Vector3d w = R * (body.inverse_inertia * (R.transpose() * L));
    if (overlays.angular_velocity && w.norm() > 0)
        arrow(w.normalized() * body.radius * (0.4 + 1.3 * saturated(w.norm(), half)), 1.25F,
              colors::angular_velocity);
    if (overlays.angular_momentum && L.norm() > 0)
        arrow(L.normalized() * body.radius *
                  (0.6 + 1.5 * saturated(L.norm() / body.mean_inertia, half)),
              0.8F, colors::angular_momentum);
}

void add_contacts(Picture& picture, const Frame& frame, const std::vector<DrawnBody>& bodies,
                  float thickness)
{
    const auto count = static_cast<int>(bodies.size());
    for (const ContactRecord& contact : frame.contacts) {
        if (!in_sight(contact.point)) continue;
        const Vector3f point = contact.point.cast<float>();
        picture.dots.push_back({1.4F * thickness * Matrix3f::Identity(), point, colors::touching});
        if (std::min(contact.body1, contact.body2) < 0 ||
            std::max(contact.body1, contact.body2) >= count)
            continue;
        const bool first = !bodies[contact.body1].is_static;
        const double mass = bodies[first ? contact.body1 : contact.body2].mass;
        const double j = contact.impulse.norm();
        if (!(mass > 0) || !(j > 0)) continue;
        // The length of the arrow shows the change of velocity |j|/m. It saturates, so that both
        // resting contacts and hits can be seen, and is half of its limit at 0.8 m/s.
        const double length = 50 * thickness * saturated(j / mass, 0.8);
        const Vector3d way = (first ? 1 : -1) * length / j * contact.impulse;
        add_arrow(picture, point, (contact.point + way).cast<float>(), 0.8F * thickness,
                  colors::impulse);
    }
}

void add_springs(Picture& picture, const Frame& frame, const std::vector<DrawnBody>& bodies,
                 const std::vector<Spring>& springs, float thickness)
{
    constexpr int turns = 9, corners = 10 * turns;
    const auto end = [&](int body, const Vector3d& point) -> Vector3d {
        if (body < 0 || body >= static_cast<int>(frame.bodies.size())) return point;
        const RigidState& state = frame.bodies[body];
        return state.position +
               rotation_matrix(state.orientation) * (point - bodies[body].center_of_mass);
    };
    for (const Spring& spring : springs) {
        const Vector3d from = end(spring.body1, spring.point1),
                       to = end(spring.body2, spring.point2);
        const Vector3d way = to - from;
        constexpr double shortest = 1e-9; // a spring that is shorter has no direction [m]
        if (!(way.norm() > shortest) || !in_sight(from) || !in_sight(to)) continue;
        const Vector3d u = way.unitOrthogonal(), v = way.normalized().cross(u);
        Vector3d last = from;
        for (int i = 1; i <= corners; ++i) {
            const double t = static_cast<double>(i) / corners;
            const double wide = std::min(1.0, 8 * std::min(t, 1 - t)) * 4 * thickness;
            const double angle = 2 * std::numbers::pi * turns * t;
            const Vector3d next =
                from + t * way + wide * (std::cos(angle) * u + std::sin(angle) * v);
            add_rod(picture, last.cast<float>(), next.cast<float>(), 0.6F * thickness,
                    colors::touching);
            last = next;
        }
    }
}

void add_title(Picture& picture, const std::string& scene, double time)
{
    picture.texts.push_back(
        {fmt::format("{}   t = {:.3f} s", scene, time), colors::dark, true, {}});
}

void add_legend(Picture& picture, const Overlays& overlays)
{
    const auto line = [&](const std::string& text, const Vector4f& color) {
        picture.texts.push_back({text, colors::opaque(color), false, {}});
    };
    if (overlays.axes) {
        line("→ x body axis", colors::axis_x);
        line("→ y body axis", colors::axis_y);
        line("→ z body axis", colors::axis_z);
    }
    if (overlays.angular_velocity) line("→ ω angular velocity", colors::angular_velocity);
    if (overlays.angular_momentum) line("→ L angular momentum", colors::angular_momentum);
    if (overlays.contacts) {
        line("● contact", colors::touching);
        line("→ impulse", colors::impulse);
    }
}

void add_names(Picture& picture, const Frame& frame, const std::vector<DrawnBody>& bodies,
               const std::vector<SolidDescription>& solids, float thickness)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const RigidState& state = frame.bodies[i];
        if (bodies[i].radius == 0 || !in_sight(state.position)) continue;
        Vector3d above = state.position;
        above.y() = top(bodies[i].parts, pose_of(state)) + 2.5 * thickness;
        // A static body, such as a wall or a table, has its name at its middle.
        if (bodies[i].is_static) above = state.position;
        if (in_sight(above))
            picture.texts.push_back({bodies[i].name, colors::dark, false, above.cast<float>()});
    }
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        Vector3d above = frame.solids[i].totals.center_of_mass;
        for (const Vector3d& x : frame.solids[i].positions)
            above.y() = std::max(above.y(), x.y() + 2.5 * thickness);
        if (in_sight(above))
            picture.texts.push_back({solids[i].name, colors::dark, false, above.cast<float>()});
    }
}

} // namespace rigor
