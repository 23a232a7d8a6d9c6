// SPDX-License-Identifier: MIT
// Numbers that a handout quotes of a scene's theory, or of what the tests of a task compare with.
#include "formulas/inertia.hpp"
#include "geometry/meshes/generators.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::handouts;

namespace {

// The time [s] after which the angular velocity of a free body, along its axes, has turned around
// once: 4 K(k)/p. (Landau and Lifshitz 1960, § 37) @param I  its moments in descending order
double period(const Vector3d& I, const Vector3d& w)
{
    Vector3d M = I; // the moments so that L² > 2 E M(1): w goes around the axis of M(0)
    const double twice_E = w.dot(I.cwiseProduct(w)), L2 = I.cwiseProduct(w).squaredNorm();
    if (L2 < twice_E * I(1)) std::swap(M(0), M(2));
    const double p2 = (M(0) - M(1)) * (L2 - twice_E * M(2)) / (M(0) * M(1) * M(2));
    const double m =
        (M(1) - M(2)) * (twice_E * M(0) - L2) / ((M(0) - M(1)) * (L2 - twice_E * M(2)));
    return 4 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(p2);
}

} // namespace

TEST_CASE("A2: how much of a sphere an icosphere fills", "[numbers]")
{
    std::vector<double> parts;
    for (int levels = 0; levels < 4; ++levels)
        parts.push_back(mesh_mass_properties(icosphere(1, levels), 1).mass /
                        (4 * std::numbers::pi / 3));
    check_shown("A2", "such bodies fill 0.6055, 0.8735, 0.9662 and 0.9914 of their sphere", parts);
}

TEST_CASE("A3: the box that tumbles, and a top", "[numbers]")
{
    const Vector3d I(13, 10, 5);
    const auto growth = [&](const Vector3d& w) { // from E to the most that L allows
        return I.cwiseProduct(w).squaredNorm() / I.minCoeff() / w.dot(I.cwiseProduct(w));
    };
    check_shown("A3", "it grows to 1.62 times its first value", {growth({1, 2, 3})});
    check_shown("A3", "ends at 1.62 times its first value", {growth({1, 2, 3})});
    check_shown("A3", "its period of 3.672 s", {period(I, {1, 2, 3})});
    check_shown("A3", "like a tennis racket every 9.410 s", {period(I, {0.1, 2, 0.1}) / 2});

    // A cone of 1 kg on its apex: |w × L| = m g c sin θ of a steady precession w. J is its moment
    // about its axis, I1 the one across it at the apex.
    const double height = 0.1, radius = 0.05, c = 0.75 * height, spin = 500;
    const double J = 0.3 * radius * radius;
    const double I1 = 0.6 * (radius * radius / 4 + height * height);
    const double a = I1 * std::cos(std::numbers::pi / 6), b = J * spin;
    check_shown("A3", "precesses at 2.022 rad/s",
                {(b - std::sqrt(b * b - 4 * a * 9.81 * c)) / (2 * a)});
}

TEST_CASE("A4: a block that slides down", "[numbers]")
{
    const double slope = std::numbers::pi / 6;
    check_shown("A4", "which gains 3.20585815777493 m/s²",
                {9.81 * (std::sin(slope) - 0.2 * std::cos(slope))});
}

TEST_CASE("A6: what a stretched piece keeps", "[numbers]")
{
    check_shown("A6", "854166.6667 J/m³ have become heat", {562500 + 291666 + 2.0 / 3});
    check_shown("A6", "springs back by 0.00125, and 0.00375 remain",
                {250e6 / 200e9, 0.005 - 250e6 / 200e9});
}

TEST_CASE("A7: how the stress at a notch grows", "[numbers]")
{
    const auto power = [](double coarse, double fine, double ratio_of_cells) {
        return std::log(fine / coarse) / std::log(ratio_of_cells);
    };
    check_shown("A7", "shows 470157, 548437 and 578756 Pa", {470157, 548437, 578756});
    check_shown("A7", "as the power 0.22 of the number of cells", {power(470157, 548437, 2)});
    check_shown("A7", "as the power 0.13", {power(548437, 578756, 1.5)});
    // The exponent λ - 1 at a corner of 3π/2: sin(λ 3π/2) = λ, the mode that opens. (Williams 1952)
    double low = 0.5, high = 0.6;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (std::sin(1.5 * std::numbers::pi * middle) > middle ? low : high) = middle;
    }
    check_shown("A7", "$-0.456$ of the distance", {low - 1});
    check_shown("A7", "as the power 0.456 of their number", {1 - low});
}
