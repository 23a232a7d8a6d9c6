// SPDX-License-Identifier: MIT
// The figures of assignment A2, about inertia: a hammer with its bounding box and the ellipsoids of
// the same inertia, the ellipsoid of inertia, and the parallel shift for a union of bodies. Last
// comes a figure of assignment A3: the polhodes of a free box.
#include "figures/inertia_figures.hpp"

#include "formulas/inertia.hpp"

#include <cmath>
#include <numbers>

namespace rigor::figures {

namespace {

constexpr double pi = std::numbers::pi;

Points rectangle(const Vector2d& center, const Vector2d& size)
{
    const Vector2d h = size / 2;
    return {center + Vector2d(-h.x(), -h.y()), center + Vector2d(h.x(), -h.y()),
            center + Vector2d(h.x(), h.y()), center + Vector2d(-h.x(), h.y())};
}

const Vector3d handle_size(0.12, 1.4, 0.12), head_size(0.7, 0.28, 0.28), head_center(0, 0.84, 0);

MassProperties hammer()
{
    MassProperties head = solid_box(750, head_size);
    head.center_of_mass = head_center;
    return combine(solid_box(750, handle_size), head);
}

void draw_hammer(Drawing& drawing, const std::string& style)
{
    drawing.polygon(rectangle({0, 0}, handle_size.head<2>()), style);
    drawing.polygon(rectangle(head_center.head<2>(), head_size.head<2>()), style);
}

// The section in the plane x y of the uniform ellipsoid that has this mass and inertia.
Points equal_ellipse(const MassProperties& of)
{
    const Vector3d J = of.inertia.diagonal();
    // J_x = M/5 (b² + c²): a² = 5/2 (J_y + J_z - J_x)/M
    const double a = std::sqrt(2.5 * (J.y() + J.z() - J.x()) / of.mass);
    const double b = std::sqrt(2.5 * (J.x() + J.z() - J.y()) / of.mass);
    const Vector2d X = of.center_of_mass.head<2>();
    return Drawing::sampled(0, 2 * pi, 96, [&](double t) {
        return Vector2d(X + Vector2d(a * std::cos(t), b * std::sin(t)));
    });
}

Drawing simpler_figure()
{
    Drawing drawing("A hammer, the box that bounds it, and the ellipsoids of the same inertia.",
                    660, 380);
    const MassProperties exact = hammer();
    std::vector<Vector3d> corners = {-handle_size / 2, handle_size / 2, head_center - head_size / 2,
                                     head_center + head_size / 2};
    const MassProperties box = bounding_box_mass_properties(corners, exact.mass);
    drawing.place({190, 220}, 125);
    draw_hammer(drawing, "grey filled");
    drawing.curve(equal_ellipse(exact), "blue");
    drawing.dot(exact.center_of_mass.head<2>(), "blue");
    drawing.label({0, -1}, "exact", Side::below, "blue");
    drawing.place({470, 220}, 125);
    draw_hammer(drawing, "grey filled");
    drawing.polygon(rectangle({0, 0.14}, {0.7, 1.68}), "orange dashed");
    drawing.curve(equal_ellipse(box), "orange");
    drawing.dot(box.center_of_mass.head<2>(), "orange");
    drawing.label({0, -1}, "bounding box", Side::below, "orange");
    return drawing;
}

Drawing shifted()
{
    Drawing drawing(
        "The tensors of two bodies are moved to the common center before they are added.", 660,
        330);
    const MassProperties whole = hammer();
    drawing.place({290, 205}, 150);
    // the hammer lies on its side: its y axis goes to the right
    const auto at = [](double y, double x) { return Vector2d(y - 0.2, x); };
    const auto box = [&](double y, double length, double width) {
        return rectangle(at(y, 0), {length, width});
    };
    drawing.polygon(box(0, 1.4, 0.12), "blue filled");
    drawing.polygon(box(0.84, 0.28, 0.7), "orange filled");
    const double X = whole.center_of_mass.y();
    drawing.dot(at(0, 0), "blue");
    drawing.label(at(0, 0), "X₁", Side::below, "blue");
    drawing.dot(at(0.84, 0), "orange");
    drawing.label(at(0.84, 0), "X₂", Side::right, "orange");
    drawing.dot(at(X, 0), "ink");
    drawing.line(at(X, -0.55), at(X, 1.1), "ink dashed");
    drawing.label(at(X, -0.55), "axis through X", Side::below);
    drawing.arrow(at(0, 0.5), at(X, 0.5), "blue");
    drawing.label(at(X / 2, 0.5), "M₁ |X₁ − X|²", Side::above, "blue");
    drawing.arrow(at(0.84, 0.75), at(X, 0.75), "orange");
    drawing.label(at(0.84, 0.75), "M₂ |X₂ − X|²", Side::right, "orange");
    return drawing;
}

// The principal moments of a free box [kg m²]. In its body frame, L moves on the sphere
// |L| = 1 kg m²/s and keeps the energy ½ Σ L_i²/J_i.
constexpr double J1 = 5, J2 = 10, J3 = 13;

// A polhode: the path of L on the sphere, around the axis with the largest or the smallest moment.
// `share` sets the energy, from 0 at this axis to 1 on the separatrix, the curve between the paths
// around the two axes.
std::vector<Vector3d> polhode(double share, bool about_largest)
{
    // Σ L_i² = 1 and Σ L_i²/J_i = 2E, with 2E between 1/J3 and 1/J2, or between 1/J2 and 1/J1
    const double twice =
        about_largest ? 1 / J3 + share * (1 / J2 - 1 / J3) : 1 / J1 - share * (1 / J1 - 1 / J2);
    std::vector<Vector3d> points;
    constexpr int steps = 480;
    for (int i = 0; i <= steps; ++i) {
        const double t = 2 * pi * i / steps;
        if (about_largest) {
            // L_2² (1/J2 - 1/J3) + L_1² (1/J1 - 1/J3) = 2E - 1/J3
            const double rest = twice - 1 / J3;
            const double b = std::sqrt(rest / (1 / J2 - 1 / J3)) * std::cos(t);
            const double c = std::sqrt(rest / (1 / J1 - 1 / J3)) * std::sin(t);
            points.emplace_back(std::sqrt(std::max(0.0, 1 - b * b - c * c)), b, c);
        } else {
            const double rest = 1 / J1 - twice;
            const double a = std::sqrt(rest / (1 / J1 - 1 / J3)) * std::cos(t);
            const double b = std::sqrt(rest / (1 / J1 - 1 / J2)) * std::sin(t);
            points.emplace_back(a, b, std::sqrt(std::max(0.0, 1 - a * a - b * b)));
        }
    }
    return points;
}

// Draws the parts of a curve on a sphere that the eye sees.
void draw_visible(Drawing& drawing, const View& view, const std::vector<Vector3d>& curve,
                  std::string_view style)
{
    Points part;
    const auto end_part = [&] {
        if (part.size() > 1) drawing.curve(part, style);
        part.clear();
    };
    for (const Vector3d& x : curve) {
        if (view.nearness(x) >= 0)
            part.push_back(view(x));
        else
            end_part();
    }
    end_part();
}

Drawing polhodes()
{
    Drawing drawing(
        "The paths of L on its sphere, seen from a free box: closed curves go around the axes of "
        "the largest and the smallest moment, and two paths cross at the middle axis.",
        660, 400);
    const View view(38, 28);
    drawing.place({330, 205}, 170);
    drawing.circle({0, 0}, 1, "grey thin");
    // the axis with the middle moment points up
    for (const double share : {0.08, 0.25, 0.5, 0.75, 0.9999}) {
        for (const bool about_largest : {true, false}) {
            const bool is_separatrix = share > 0.99;
            draw_visible(drawing, view, polhode(share, about_largest),
                         is_separatrix   ? "red"
                         : about_largest ? "blue thin"
                                         : "green thin");
        }
    }
    drawing.dot(view({1, 0, 0}), "blue");
    drawing.label({1.03, -0.3}, "largest, 13", Side::right, "blue");
    drawing.dot(view({0, 0, 1}), "green");
    drawing.label({-1.03, -0.3}, "smallest, 5", Side::left, "green");
    drawing.dot(view({0, 1, 0}), "red");
    drawing.label(view({0, 1, 0}) + Vector2d(0, 0.11), "middle, 10: unstable", Side::above, "red");
    return drawing;
}

Drawing ellipsoid()
{
    Drawing drawing(
        "The ellipsoid of inertia of a box of 1 × 2 × 3 m: ω on it has the same energy in "
        "every direction.",
        660, 340);
    const View view(35, 22);
    drawing.place({330, 175}, 62);
    const MassProperties box = solid_box(2, {1, 2, 3});
    const Vector3d half(0.5, 1, 1.5);
    const auto corner = [&](int c) {
        const Vector3d side((c & 1) ? 1 : -1, (c & 2) ? 1 : -1, (c & 4) ? 1 : -1);
        return view(half.cwiseProduct(side));
    };
    for (int a = 0; a < 8; ++a)
        for (const int bit : {1, 2, 4})
            if (!(a & bit)) drawing.line(corner(a), corner(a | bit), "grey");
    // the ellipsoid ω·Iω = 49, drawn at 0.8 of its size
    const Vector3d J = box.inertia.diagonal();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const Points ring = Drawing::sampled(0, 2 * pi, 96, [&](double t) {
            const Vector3d w = std::cos(t) * std::sqrt(49 / J[i]) * Vector3d::Unit(i) +
                               std::sin(t) * std::sqrt(49 / J[j]) * Vector3d::Unit(j);
            return view(0.8 * w);
        });
        drawing.curve(ring, "blue");
    }
    for (int i = 0; i < 3; ++i) {
        const Vector3d end = (0.8 * std::sqrt(49 / J[i]) + 0.5) * Vector3d::Unit(i);
        drawing.arrow({0, 0}, view(end), "ink thin");
        drawing.label(view(end), std::string(1, "xyz"[i]),
                      i == 0   ? Side::right
                      : i == 1 ? Side::above
                               : Side::left);
    }
    drawing.label({2.1, 2.3}, "slow about x: J₃ = 13", Side::right, "blue");
    drawing.label({2.1, 1.9}, "fast about z: J₁ = 5", Side::right, "blue");
    return drawing;
}

} // namespace

std::span<const Figure> inertia_figures()
{
    static constexpr Figure all[] = {{"a2-inertia", "simpler_figure", simpler_figure},
                                     {"a2-inertia", "union", shifted},
                                     {"a2-inertia", "ellipsoid", ellipsoid},
                                     {"a3-rotation", "polhodes", polhodes}};
    return all;
}

} // namespace rigor::figures
