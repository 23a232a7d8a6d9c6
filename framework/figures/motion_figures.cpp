// SPDX-License-Identifier: MIT
// The figures of assignment A1, about rigid motion: object space and world space, velocity modes,
// lever and torque, and the centripetal accelerations of particles, whose torques add up to
// ω × I ω.
#include "figures/motion_figures.hpp"

#include "formulas/kinematics.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace rigor::figures {

namespace {

Vector2d flat(const Vector3d& x)
{
    return x.head<2>();
}

// A body with a nose, so that one sees how it is turned.
const std::vector<Vector3d> outline = {
    {-1, -0.6, 0}, {0.7, -0.6, 0}, {1.2, 0, 0}, {0.7, 0.6, 0}, {-1, 0.6, 0}};

Drawing spaces()
{
    Drawing drawing("A point p of object space, and where it is in world space.", 660, 330);
    const double angle = 0.65;
    const Matrix3d R = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    const Vector3d X(3.3, 1.35, 0), p(0.75, 0.3, 0);
    Points object, world;
    for (const Vector3d& corner : outline) {
        object.push_back(flat(corner));
        world.push_back(flat(world_point(R, X, corner)));
    }
    drawing.place({130, 170}, 75);
    drawing.polygon(object, "grey filled");
    drawing.arrow({0, 0}, {1.6, 0}, "ink");
    drawing.arrow({0, 0}, {0, 1.4}, "ink");
    drawing.arrow({0, 0}, flat(p), "blue thick");
    drawing.label(flat(p), "p", Side::right, "blue");
    drawing.label({0, -1.5}, "object space", Side::below, "grey");
    drawing.place({320, 280}, 75);
    drawing.polygon(world, "grey filled");
    drawing.arrow({0, 0}, {1.3, 0}, "ink");
    drawing.arrow({0, 0}, {0, 1.3}, "ink");
    drawing.arrow({0, 0}, flat(X), "orange thick");
    drawing.label(flat(X) / 2, "X", Side::below, "orange");
    drawing.arrow(flat(X), flat(world_point(R, X, p)), "blue thick");
    drawing.label(flat(X + R * p / 2), "R p", Side::below, "blue");
    const Vector3d x = world_point(R, X, p);
    drawing.arrow({0, 0}, flat(x), "green");
    drawing.label(flat(x) / 2 + Vector2d(-0.05, 0.1), "x = R p + X", Side::left, "green");
    drawing.label({1.4, -0.05}, "world space", Side::below, "grey");
    return drawing;
}

// Draws a square with the velocities of nine of its points in one velocity mode.
void draw_mode(Drawing& drawing, const Vector2d& origin, int mode, const std::string& text)
{
    drawing.place(origin, 58);
    drawing.polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, "grey filled");
    const Vector3d X = Vector3d::Zero();
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
            const Vector3d x(i, j, 0);
            const Vector3d v = velocity_modes(X, x).col(mode) * 0.55;
            drawing.dot(flat(x), "ink");
            drawing.arrow(flat(x), flat(x + v), "blue");
        }
    drawing.label({0, -1.65}, text, Side::below);
}

Drawing modes()
{
    Drawing drawing("The three velocity modes of a plane body.", 660, 270);
    draw_mode(drawing, {110, 115}, 0, "V along x");
    draw_mode(drawing, {320, 115}, 1, "V along y");
    draw_mode(drawing, {540, 115}, 5, "ω along z");
    return drawing;
}

Drawing lever()
{
    Drawing drawing("The torque of a force is its lever arm times the force.", 660, 300);
    drawing.place({130, 215}, 90);
    const Vector3d X(0, 0, 0), x(2.4, 0.8, 0), f(-0.9, 1.2, 0);
    drawing.polygon({{-0.8, -0.5}, {2.0, -0.5}, {2.7, 0.7}, {2.3, 1.2}, {-0.6, 0.6}},
                    "grey filled");
    const Wrench wrench = net_wrench({{f, x}}, X);
    const Vector3d along = f.normalized(), foot = x - along * along.dot(x - X);
    drawing.line(flat(foot - 0.5 * along), flat(x + 1.6 * along), "grey dashed");
    drawing.arrow(flat(X), flat(x), "blue");
    drawing.label(flat(x) / 2, "x − X", Side::below, "blue");
    drawing.arrow(flat(x), flat(x + f), "orange thick");
    drawing.label(flat(x + 0.8 * f), fmt::format("f, {:.1f} N", f.norm()), Side::right, "orange");
    drawing.line(flat(X), flat(foot), "green thick");
    const double arm = (foot - X).norm();
    drawing.label(flat(foot) * 0.6 + Vector2d(-0.05, 0.1), fmt::format("lever arm, {:.1f} m", arm),
                  Side::left, "green");
    drawing.dot(flat(X), "ink");
    drawing.label(flat(X), "X", Side::left);
    std::string text = fmt::format("τ = {:.1f} m · {:.1f} N", arm, f.norm());
    drawing.label({3.2, 0.2}, text, Side::right);
    drawing.label({3.2, -0.05}, fmt::format("= {:.1f} N m", wrench.torque.z()), Side::right);
    return drawing;
}

std::string numbers(const Vector3d& v)
{
    return fmt::format("({:.0f}, {:.0f}, {:.0f})", v.x(), v.y(), v.z());
}

Drawing centripetal()
{
    Drawing drawing("The accelerations ω × (ω × x) of six particles, and the torque of each pair.",
                    660, 380);
    const View view(25, 20);
    const Vector3d w(1, 2, 3), X = Vector3d::Zero();
    drawing.place({190, 195}, 62);
    const auto at = [&](const Vector3d& x) { return view(Vector3d(x.x(), x.y(), x.z())); };
    const Vector3d axis = w.normalized() * 2.9;
    drawing.arrow({0, 0}, at(axis), "ink");
    drawing.label(at(axis), "ω", Side::above);
    constexpr std::array colors = {"blue", "orange", "green"};
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        const std::string color = colors[static_cast<std::size_t>(i)];
        std::vector<Particle> pair;
        for (const double side : {1.0, -1.0})
            pair.push_back({0.5, side * (i + 1) * Vector3d::Unit(i)});
        drawing.line(at(pair[0].position), at(pair[1].position), color + " thin");
        for (const Particle& particle : pair) {
            const Vector3d& x = particle.position;
            const Vector3d v = point_velocity(X, w, X, x);
            drawing.dot(at(x), color);
            drawing.arrow(at(x), at(x + w.cross(v) * 0.035), color);
        }
        const Vector3d torque = inertial_wrench(pair, X, X, w).torque;
        sum += torque;
        const std::string axis_name(1, "xyz"[i]);
        drawing.label(at(pair[0].position), axis_name, i == 1 ? Side::above : Side::right, color);
        drawing.label({2.8, 2.2 - 0.5 * i}, "torque of the pair on " + axis_name, Side::right,
                      color);
        drawing.label({7.3, 2.2 - 0.5 * i}, numbers(torque), Side::left, color);
    }
    drawing.line({2.9, 0.85}, {7.2, 0.85}, "ink thin");
    drawing.label({2.8, 0.55}, "sum: ω × L", Side::right);
    drawing.label({7.3, 0.55}, numbers(sum), Side::left);
    return drawing;
}

} // namespace

std::span<const Figure> motion_figures()
{
    static constexpr Figure all[] = {{"a1-kinematics", "spaces", spaces},
                                     {"a1-kinematics", "velocity_modes", modes},
                                     {"a1-kinematics", "lever", lever},
                                     {"a1-kinematics", "centripetal", centripetal}};
    return all;
}

} // namespace rigor::figures
