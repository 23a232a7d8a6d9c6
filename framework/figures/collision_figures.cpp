// SPDX-License-Identifier: MIT
// The figures of assignment A4, about collisions: the impulse matrix K as an ellipse at the tip of
// a rod, the friction cone, a contact that jams, and a fast plate that passes a wall within one
// step.
#include "figures/collision_figures.hpp"

#include "formulas/collision.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rigor::figures {

namespace {

constexpr double pi = std::numbers::pi;
const Vector3d up(0, 1, 0);

Vector2d flat(const Vector3d& x)
{
    return x.head<2>();
}

// The impulse matrix K of a rod of 1 kg and 1 m, for impulses at its tip, which is at the origin.
Matrix3d rod_at_tip(const Vector3d& along)
{
    const Matrix3d I_inverse = 12 * (Matrix3d::Identity() - along * along.transpose());
    return impulse_matrix(1, I_inverse, along / 2, Vector3d::Zero());
}

Drawing impulse_ellipse()
{
    Drawing drawing(
        "All impulses of 1 N s at the tip of a rod, and the velocities that they give the "
        "tip.",
        660, 360);
    const Vector3d along = Vector3d(1, 1, 0).normalized();
    const Matrix3d K = rod_at_tip(along);
    drawing.place({300, 215}, 42);
    drawing.line({0, 0}, flat(along * 4.2), "grey thick");
    drawing.curve(Drawing::sampled(0, 2 * pi, 96,
                                   [](double t) { return Vector2d(std::cos(t), std::sin(t)); }),
                  "orange");
    drawing.curve(
        Drawing::sampled(0, 2 * pi, 96,
                         [&](double t) { return flat(K * Vector3d(std::cos(t), std::sin(t), 0)); }),
        "blue");
    drawing.arrow({0, 0}, flat(up), "orange thick");
    drawing.label(flat(up), "j", Side::left, "orange");
    drawing.arrow({0, 0}, flat(K * up), "blue thick");
    drawing.label(flat(K * up), "K j", Side::left, "blue");
    drawing.label(flat(along * 4.2), "the rod", Side::right, "grey");
    drawing.place({0, 0}, 1);
    std::string text = fmt::format("along the rod: {:.0f}/M", along.dot(K * along));
    drawing.label({430, -260}, text, Side::right, "blue");
    const Vector3d across(-along.y(), along.x(), 0);
    text = fmt::format("across it: {:.0f}/M", across.dot(K * across));
    drawing.label({430, -290}, text, Side::right, "blue");
    return drawing;
}

void draw_cone(Drawing& drawing, const Vector3d& v, double mu, const std::string& text)
{
    const Matrix3d K = Vector3d(3.5, 1, 3.5).asDiagonal(); // K of a solid 1 kg ball, at the bottom
    const Vector3d sticks = static_friction_impulse(K, v, up, 0.5);
    const Vector3d j = collision_impulse(K, v, up, 0.5, mu);
    const double top = 3.4;
    drawing.polygon({{0, 0}, {-mu * top, top}, {mu * top, top}}, "grey filled thin");
    drawing.line({-2, 0}, {2, 0}, "ink thick");
    const Vector2d tip(-0.2, 0.4), tail = tip - 0.6 * flat(v);
    drawing.arrow(tail, tip, "green");
    drawing.label(tail, "v", Side::left, "green");
    const Vector2d corner(-1.75, 0); // where the arrows n and T start, beside the contact
    drawing.arrow(corner, corner + Vector2d(0, 0.7), "ink");
    drawing.label(corner + Vector2d(0, 0.6), "n", Side::right);
    drawing.arrow(corner, corner + Vector2d(0.7, 0), "ink");
    drawing.label(corner + Vector2d(0.7, 0), "T", Side::below);
    drawing.label({mu * 2.8, 2.8}, "cone", Side::right, "grey");
    if (!inside_friction_cone(sticks, up, mu)) {
        drawing.arrow({0, 0}, flat(sticks), "red dashed");
        drawing.label(flat(sticks), "sticking", Side::left, "red");
    }
    drawing.arrow({0, 0}, flat(j), "blue thick");
    drawing.label(flat(j), "j", Side::above, "blue");
    drawing.label({0, -0.3}, text, Side::below);
}

Drawing friction_cone()
{
    Drawing drawing(
        "The sticking impulse of a ball lies inside the cone of μ = 0.5 and outside that of "
        "μ = 0.1, where the sliding impulse on its edge takes its place.",
        660, 350);
    const Vector3d v(3, -2, 0);
    drawing.place({180, 290}, 76);
    draw_cone(drawing, v, 0.5, "μ = 0.5: the ball sticks");
    drawing.place({490, 290}, 76);
    draw_cone(drawing, v, 0.1, "μ = 0.1: it slides");
    return drawing;
}

Drawing jam()
{
    Drawing drawing(
        "nᵀK(n − μT) of a rod that drags its upper end behind its tip, for three angles: "
        "where it is negative the contact jams.",
        660, 380);
    drawing.place({80, 250}, 130);
    drawing.arrow({0, 0}, {3.6, 0}, "ink thin");
    drawing.label({3.6, 0}, "μ", Side::right);
    drawing.arrow({0, -0.6}, {0, 1.6}, "ink thin");
    constexpr double unit = 0.42; // length in the drawing of the value 1 on the vertical axis
    for (int tick = 0; tick <= 3; ++tick) {
        drawing.line({-0.04, tick * unit}, {0, tick * unit}, "ink thin");
        drawing.label({-0.04, tick * unit}, std::to_string(tick), Side::left, "grey");
    }
    drawing.label({0.05, 1.6}, "nᵀK(n − μT)", Side::right);
    const Vector3d T(1, 0, 0);
    const char* colors[] = {"green", "blue", "orange"};
    const double angles[] = {30, std::atan(2.0) * 180 / pi, 80};
    for (int i = 0; i < 3; ++i) {
        const double a = angles[i] * pi / 180;
        const Matrix3d K = rod_at_tip(Vector3d(-std::cos(a), std::sin(a), 0));
        const double nKn = up.dot(K * up), nKT = up.dot(K * T);
        const double end = std::min(3.3, (nKn + 0.9) / nKT);
        const auto at = [&](double mu) { return Vector2d(mu, (nKn - mu * nKT) * unit); };
        drawing.line(at(0), at(end), colors[i]);
        std::string text =
            fmt::format("rod at {:.0f}°: jams from μ = {:.2f}", angles[i], nKn / nKT);
        drawing.label({1.9, 1.4 - 0.2 * i}, text, Side::right, colors[i]);
        if (nKn / nKT < 3.3) drawing.dot({nKn / nKT, 0}, colors[i]);
    }
    for (int mu = 1; mu <= 3; ++mu)
        drawing.label({static_cast<double>(mu), 0}, std::to_string(mu), Side::below, "grey");
    return drawing;
}

Drawing first_point()
{
    Drawing drawing(
        "A fast plate and a wall: between two steps it has passed the wall. The time of "
        "impact lies in between.",
        660, 260);
    drawing.place({60, 150}, 620);
    const double h = 1.0 / 60, speed = 40, wall = 0.42, thickness = 0.1, plate = 0.04;
    drawing.polygon(
        {{wall, -0.12}, {wall + thickness, -0.12}, {wall + thickness, 0.16}, {wall, 0.16}},
        "grey filled");
    const auto draw_plate = [&](double x, const std::string& style) {
        drawing.polygon({{x, -0.07}, {x + plate, -0.07}, {x + plate, 0.1}, {x, 0.1}}, style);
    };
    const double impact = (wall - plate) / speed;
    draw_plate(0, "blue filled");
    draw_plate(speed * h, "red filled");
    draw_plate(speed * impact, "green filled");
    // from the right edge of the plate at t = 0 to its right edge after one step
    drawing.arrow({plate, 0.13}, {speed * h + plate, 0.13}, "grey dashed");
    drawing.label({0.21, 0.13}, fmt::format("{:.3f} m in one step", speed * h), Side::above,
                  "grey");
    drawing.label({plate / 2, -0.08}, "t = 0", Side::below, "blue");
    drawing.label({speed * h + plate / 2, -0.08}, "t = 1/60 s", Side::below, "red");
    std::string text = fmt::format("impact after {:.4f} s", impact);
    drawing.label({speed * impact - 0.1, -0.08}, text, Side::below, "green");
    return drawing;
}

} // namespace

std::span<const Figure> collision_figures()
{
    static constexpr Figure all[] = {{"a4-collision", "first_point", first_point},
                                     {"a4-collision", "impulse_ellipse", impulse_ellipse},
                                     {"a4-collision", "friction_cone", friction_cone},
                                     {"a4-collision", "jam", jam}};
    return all;
}

} // namespace rigor::figures
