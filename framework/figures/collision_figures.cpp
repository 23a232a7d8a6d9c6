// SPDX-License-Identifier: MIT
// Figures of A4: a level set and one of its cells, K as an ellipse at the tip of a rod, the
// friction cone, a jam, and deepest against first point.
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

// The distance to a disc of radius 1, sampled with cells of edge h; it does not depend on z.
LevelSet disc(double h, int nodes)
{
    LevelSet grid;
    grid.cell_size = h;
    grid.size = {nodes, nodes, 2};
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < nodes; ++j)
            for (int i = 0; i < nodes; ++i)
                grid.distances.push_back(h * std::hypot(i, j) - 1);
    return grid;
}

Drawing level_set()
{
    Drawing drawing(
        "A level set stores distances at nodes; between them the surface it describes is "
        "a little inside the true one.",
        660, 380);
    const double h = 0.5;
    const int nodes = 4;
    const LevelSet grid = disc(h, nodes);
    drawing.place({120, 330}, 195);
    for (int i = 0; i < nodes; ++i) {
        drawing.line({i * h, 0}, {i * h, (nodes - 1) * h}, "grey thin");
        drawing.line({0, i * h}, {(nodes - 1) * h, i * h}, "grey thin");
        for (int j = 0; j < nodes; ++j) {
            std::string text = fmt::format("{:.2f}", h * std::hypot(i, j) - 1);
            drawing.label({i * h + 0.02, j * h + 0.07}, text, Side::right, "grey");
        }
    }
    drawing.curve(Drawing::sampled(0, pi / 2, 90,
                                   [](double t) { return Vector2d(std::cos(t), std::sin(t)); }),
                  "ink dashed");
    // the zero of the interpolated distance along each ray, by bisection
    drawing.curve(Drawing::sampled(0, pi / 2, 90,
                                   [&](double t) {
                                       const Vector3d ray(std::cos(t), std::sin(t), 0);
                                       double low = 0.5, high = 1.4;
                                       for (int i = 0; i < 40; ++i) {
                                           const double middle = (low + high) / 2;
                                           (sample_level_set(grid, middle * ray) < 0 ? low : high) =
                                               middle;
                                       }
                                       return flat(low * ray);
                                   }),
                  "blue thick");
    const Vector3d p(0.8, 0.36, 0);
    const Vector3d n = level_set_normal(grid, p);
    drawing.dot(flat(p), "orange");
    drawing.arrow(flat(p), flat(p + 0.35 * n), "orange");
    drawing.label(flat(p + 0.35 * n), "n", Side::right, "orange");
    drawing.place({0, 0}, 1);
    drawing.label({470, -60}, "true surface", Side::right, "ink");
    drawing.label({470, -90}, "φ = 0 of the grid", Side::right, "blue");
    return drawing;
}

// The corner of the unit cell with these three numbers, 0 or 1 each.
Vector3d corner(int i, int j, int k)
{
    return Vector3d(i, j, k);
}

// The signed distance to a ball of radius 1.2 around the corner (0, 0, 0), at the nodes of one cell
// with an edge of 1 m.
LevelSet cell_of_a_ball()
{
    LevelSet grid;
    grid.size = {2, 2, 2};
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i)
                grid.distances.push_back(corner(i, j, k).norm() - 1.2);
    return grid;
}

Drawing trilinear_cell()
{
    Drawing drawing(
        "A cell of a level set: from eight corners four values along x, from these two along y, "
        "and from these one along z.",
        660, 400);
    const LevelSet grid = cell_of_a_ball();
    const View view(25, 20);
    const Vector3d p(0.4, 0.6, 0.5);
    const auto value = [&](const Vector3d& x) {
        return fmt::format("{:.2f}", sample_level_set(grid, x));
    };
    drawing.place({190, 275}, 215);
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 4; ++i) {
            Vector3d a = Vector3d::Zero();
            a[(axis + 1) % 3] = i & 1;
            a[(axis + 2) % 3] = i >> 1;
            drawing.line(view(a), view(a + Vector3d::Unit(axis)), "grey thin");
        }
    for (int k = 0; k < 2; ++k) {
        const Vector3d low(p.x(), 0, k), high(p.x(), 1, k), between(p.x(), p.y(), k);
        for (const Vector3d& x : {low, high}) {
            drawing.dot(view(x), "blue");
            drawing.label(view(x), value(x), x.y() > 0 ? Side::above : Side::below, "blue");
        }
        drawing.line(view(low), view(high), "blue thin dashed");
        drawing.dot(view(between), "orange");
        const Vector2d above_an_edge(0, k == 0 ? 0.1 : 0); // the dot lies on an edge of the cell
        drawing.label(view(between) + above_an_edge, value(between), Side::left, "orange");
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const Vector3d x = corner(i, j, k);
                drawing.dot(view(x), "ink");
                drawing.label(view(x), value(x), i > 0 ? Side::right : Side::left);
            }
    }
    drawing.line(view({p.x(), p.y(), 0}), view({p.x(), p.y(), 1}), "orange thin dashed");
    drawing.dot(view(p), "green");
    drawing.label(view(p), "φ(p) = " + value(p), Side::below, "green");
    const char* steps[] = {"8 nodes", "4 values along x", "2 along y", "1 along z"};
    const char* colors[] = {"ink", "blue", "orange", "green"};
    drawing.place({500, 120}, 1);
    for (int i = 0; i < 4; ++i)
        drawing.label({0, -28.0 * i}, steps[i], Side::right, colors[i]);
    return drawing;
}

// K of a rod of 1 kg and 1 m at its tip, which is at the origin.
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
    std::string text = fmt::format("along the rod: 1/M = {:.0f}", along.dot(K * along));
    drawing.label({430, -260}, text, Side::right, "blue");
    const Vector3d across(-along.y(), along.x(), 0);
    text = fmt::format("across it: {:.0f}/M", across.dot(K * across));
    drawing.label({430, -290}, text, Side::right, "blue");
    return drawing;
}

void draw_cone(Drawing& drawing, const Vector3d& v, double mu, const std::string& text)
{
    const Matrix3d K = Vector3d(3.5, 1, 3.5).asDiagonal(); // a ball
    const Vector3d sticks = static_friction_impulse(K, v, up, 0.5);
    const Vector3d j = collision_impulse(K, v, up, 0.5, mu);
    const double top = 3.4;
    drawing.polygon({{0, 0}, {-mu * top, top}, {mu * top, top}}, "grey filled thin");
    drawing.line({-2, 0}, {2, 0}, "ink thick");
    drawing.arrow({-0.6 * v.x() - 0.2, 1.2}, {-0.2, 0.4}, "green");
    drawing.label({-0.6 * v.x() - 0.2, 1.2}, "v", Side::left, "green");
    if (!inside_friction_cone(sticks, up, mu)) {
        drawing.arrow({0, 0}, flat(sticks), "red dashed");
        drawing.label(flat(sticks), "static", Side::left, "red");
    }
    drawing.arrow({0, 0}, flat(j), "blue thick");
    drawing.label(flat(j), "j", Side::right, "blue");
    drawing.label({0, -0.15}, text, Side::below);
}

Drawing friction_cone()
{
    Drawing drawing(
        "The static impulse of a ball lies inside the cone of μ = 0.5 and outside that of "
        "μ = 0.1, where the sliding impulse on its edge takes its place.",
        660, 350);
    const Vector3d v(3, -2, 0);
    drawing.place({180, 300}, 76);
    draw_cone(drawing, v, 0.5, "μ = 0.5: the ball sticks");
    drawing.place({490, 300}, 76);
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
    drawing.label({0.05, 1.6}, "nᵀK(n − μT)", Side::right);
    const Vector3d T(1, 0, 0);
    const char* colors[] = {"green", "blue", "orange"};
    const double angles[] = {30, std::atan(2.0) * 180 / pi, 80};
    for (int i = 0; i < 3; ++i) {
        const double a = angles[i] * pi / 180;
        const Matrix3d K = rod_at_tip(Vector3d(-std::cos(a), std::sin(a), 0));
        const double nKn = up.dot(K * up), nKT = up.dot(K * T);
        const double end = std::min(3.3, (nKn + 0.9) / nKT);
        const auto at = [&](double mu) { return Vector2d(mu, (nKn - mu * nKT) * 0.42); };
        drawing.line(at(0), at(end), colors[i]);
        std::string text = fmt::format("{:.0f}°: from {:.2f}", angles[i], nKn / nKT);
        drawing.label({2.3, 1.4 - 0.2 * i}, text, Side::right, colors[i]);
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
    drawing.arrow({plate, 0.13}, {speed * h, 0.13}, "grey dashed");
    drawing.label({plate / 2, -0.08}, "t = 0", Side::below, "blue");
    drawing.label({speed * h + plate / 2, -0.08}, "t = 1/60 s", Side::below, "red");
    std::string text = fmt::format("impact after {:.4f} s", impact);
    drawing.label({speed * impact - 0.1, -0.08}, text, Side::below, "green");
    return drawing;
}

} // namespace

std::span<const Figure> collision_figures()
{
    static constexpr Figure all[] = {{"a4-collision", "level_set", level_set},
                                     {"a4-collision", "trilinear_cell", trilinear_cell},
                                     {"a4-collision", "first_point", first_point},
                                     {"a4-collision", "impulse_ellipse", impulse_ellipse},
                                     {"a4-collision", "friction_cone", friction_cone},
                                     {"a4-collision", "jam", jam}};
    return all;
}

} // namespace rigor::figures
