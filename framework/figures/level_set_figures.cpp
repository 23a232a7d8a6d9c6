// SPDX-License-Identifier: MIT
// The figures of assignment A4 that are about level sets: the level set of a disc with the surface
// between its nodes, and a single cell of the level set of a ball.
#include "figures/level_set_figures.hpp"

#include "formulas/collision.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rigor::figures {

namespace {

constexpr double pi = std::numbers::pi;

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
        "here a little inside the true one.",
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
                const std::string name = i + j + k == 0   ? "φ₀₀₀ = "
                                         : i + j + k == 3 ? "φ₁₁₁ = "
                                                          : "";
                drawing.label(view(x), name + value(x), i > 0 ? Side::right : Side::left);
            }
    }
    drawing.line(view({p.x(), p.y(), 0}), view({p.x(), p.y(), 1}), "orange thin dashed");
    drawing.dot(view(p), "green");
    drawing.label(view(p) - Vector2d(0, 0.02), "p", Side::below, "green");
    drawing.place({560, 330}, 50);
    for (int axis = 0; axis < 3; ++axis) {
        drawing.arrow({0, 0}, view(Vector3d::Unit(axis)), "ink thin");
        drawing.label(view(Vector3d::Unit(axis)), std::string(1, "xyz"[axis]),
                      axis == 0   ? Side::right
                      : axis == 1 ? Side::above
                                  : Side::left);
    }
    const std::string steps[] = {"8 nodes", "4 values along x", "2 along y",
                                 "1 along z: φ(p) = " + value(p)};
    const char* colors[] = {"ink", "blue", "orange", "green"};
    drawing.place({460, 60}, 1);
    for (int i = 0; i < 4; ++i)
        drawing.label({0, -28.0 * i}, steps[i], Side::right, colors[i]);
    return drawing;
}

} // namespace

std::span<const Figure> level_set_figures()
{
    static constexpr Figure all[] = {{"a4-collision", "level_set", level_set},
                                     {"a4-collision", "trilinear_cell", trilinear_cell}};
    return all;
}

} // namespace rigor::figures
