// SPDX-License-Identifier: MIT
// The figures of assignment A6, about plasticity: the deviatoric plane with the radial return, the
// yield surface in the plane of two principal stresses, and a bar that is stretched and let go.
#include "figures/plasticity_figures.hpp"

#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rigor::figures {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 200e9, nu = 0.3, sigma_Y = 250e6;
constexpr double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));

// The three principal stresses s projected onto the deviatoric plane, in units of σ_Y.
Vector2d in_plane(const Vector3d& s)
{
    const Vector3d right = Vector3d(1, -1, 0).normalized(),
                   above = Vector3d(-1, -1, 2).normalized();
    return Vector2d(right.dot(s), above.dot(s)) / sigma_Y;
}

Drawing radial_return()
{
    Drawing drawing("The plane of deviators: a trial stress outside the circle returns straight to "
                    "it.",
                    660, 400);
    drawing.place({215, 215}, 150);
    const double radius = std::sqrt(2.0 / 3);
    drawing.circle({0, 0}, radius, "blue filled");
    for (int i = 0; i < 3; ++i) {
        const Vector2d axis = in_plane(sigma_Y * 1.35 * Vector3d::Unit(i));
        drawing.arrow({0, 0}, axis, "grey thin");
        drawing.label(axis,
                      i == 0   ? "σ₁"
                      : i == 1 ? "σ₂"
                               : "σ₃",
                      i == 1 ? Side::left : Side::right, "grey");
    }
    const Vector3d start = sigma_Y * Vector3d(0.35, -0.4, 0.1);
    for (const Vector3d& by : {Vector3d(0.9, -0.35, 0.15), Vector3d(0.25, -0.5, 0.8)}) {
        const Matrix3d trial = Vector3d(start + sigma_Y * by).asDiagonal();
        const Matrix3d flow = plastic_flow(Matrix3d::Zero(), trial, sigma_Y, G);
        const Vector3d after = (trial - 2 * G * flow).diagonal();
        drawing.arrow(in_plane(start), in_plane(trial.diagonal()), "ink");
        drawing.arrow(in_plane(trial.diagonal()), in_plane(after), "orange thick");
        drawing.dot(in_plane(after), "orange");
        drawing.dot(in_plane(trial.diagonal()), "ink");
        drawing.label(in_plane(trial.diagonal()), "trial stress", Side::right);
    }
    drawing.dot(in_plane(start), "ink");
    drawing.place({0, 0}, 1);
    drawing.label({400, -40}, "elastic step to the trial stress", Side::right, "ink");
    drawing.label({380, -320}, "stress returns: −2G times the flow", Side::right, "orange");
    drawing.label({380, -350}, "f(σ) ≤ 0", Side::right, "blue");
    return drawing;
}

Drawing yield_surface()
{
    Drawing drawing("Where a plate yields: the ellipse of von Mises in the plane of two principal "
                    "stresses, with the third one 0.",
                    660, 400);
    drawing.place({270, 205}, 140);
    drawing.arrow({-1.45, 0}, {1.6, 0}, "ink thin");
    drawing.label({1.6, 0}, "σ₁/σ_{Y}", Side::right);
    drawing.arrow({0, -1.35}, {0, 1.35}, "ink thin");
    drawing.label({0, 1.35}, "σ₂/σ_{Y}", Side::right);
    const auto on_surface = [](double t) {
        const double c = std::cos(t), s = std::sin(t);
        return Vector2d(Vector2d(c, s) / von_mises_principal(c, s, 0));
    };
    Points points = Drawing::sampled(0, 2 * pi, 180, on_surface);
    drawing.polygon(points, "blue filled");
    const auto mark = [&](double degrees, const std::string& text, Side side) {
        const Vector2d at = on_surface(degrees * pi / 180);
        drawing.dot(at, "orange");
        drawing.label(at, text, side, "orange");
    };
    mark(0, "pull: 1", Side::below);
    mark(45, "pull both ways: 1", Side::right);
    mark(-45, "shear: 1/√3", Side::right);
    mark(std::atan(0.5) * 180 / pi, "largest σ₁: 2/√3", Side::right);
    return drawing;
}

Drawing stretched()
{
    Drawing drawing("Stress over stretch of steel whose width is free and of steel whose width is "
                    "held, out to 0.5 % and back.",
                    660, 380);
    drawing.place({110, 265}, 1);
    const auto at = [](double e, double stress) { return Vector2d(e * 90000, stress / 1e6 * 0.2); };
    drawing.arrow(at(-0.0003, 0), at(0.0056, 0), "ink thin");
    drawing.label(at(0.0056, 0), "e", Side::below);
    drawing.arrow(at(0, -320e6), at(0, 1100e6), "ink thin");
    drawing.label(at(0, 1100e6), "σ_{xx} [MPa]", Side::right);
    for (const int stress : {250, 500, 1000}) {
        drawing.line(at(0, stress * 1e6) - Vector2d(4, 0), at(0, stress * 1e6), "ink thin");
        drawing.label(at(0, stress * 1e6), std::to_string(stress), Side::left, "grey");
    }
    for (const double e : {0.001, 0.002, 0.003, 0.004, 0.005}) {
        drawing.line(at(e, 0), at(e, 0) - Vector2d(0, 4), "ink thin");
        drawing.label(at(e, 0), fmt::format("{:g}", e), Side::below, "grey");
    }
    Matrix3d plastic = Matrix3d::Zero();
    double free_plastic = 0;
    Points held, free_width;
    for (int i = 0; i <= 200; ++i) {
        const double e = 0.005 * (i <= 100 ? i : 200 - i) / 100;
        Matrix3d total = Matrix3d::Zero();
        total(0, 0) = e;
        plastic = plastic_flow(plastic, isotropic_stress(total - plastic, lambda, G), sigma_Y, G);
        held.push_back(at(e, isotropic_stress(total - plastic, lambda, G)(0, 0)));
        // in one dimension the stress is E times the elastic strain, and at most σ_Y in size
        free_plastic = std::clamp(free_plastic, e - sigma_Y / E, e + sigma_Y / E);
        free_width.push_back(at(e, E * (e - free_plastic)));
    }
    drawing.curve(held, "orange");
    drawing.curve(free_width, "blue");
    drawing.label(at(0.0034, 830e6), "width held", Side::left, "orange");
    drawing.label(at(0.0042, 250e6), "width free", Side::above, "blue");
    drawing.label(at(0.0034, -190e6), "0.00375 remain", Side::right, "blue");
    return drawing;
}

} // namespace

std::span<const Figure> plasticity_figures()
{
    static constexpr Figure all[] = {{"a6-plasticity", "radial_return", radial_return},
                                     {"a6-plasticity", "yield_surface", yield_surface},
                                     {"a6-plasticity", "stretched", stretched}};
    return all;
}

} // namespace rigor::figures
