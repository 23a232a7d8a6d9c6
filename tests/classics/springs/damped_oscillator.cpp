// SPDX-License-Identifier: MIT
// A damped oscillator from rest at x₀ (Landau and Lifshitz, "Mechanics", § 25): with λ = c/2M and
// ω² = k/M it swings if λ < ω, creeps back if λ > ω, and returns fastest in between.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace damped_oscillator {

namespace {

struct Phase {
    double x = 0, v = 0;
};

// With ν² = |ω² - λ²|: x = x₀ e^-λt (cos ν t + λ/ν sin ν t) and v = -x₀ ω²/ν e^-λt sin ν t.
Phase closed_form(double x0, double w, double l, double t)
{
    const double fall = x0 * std::exp(-l * t), nu = std::sqrt(std::abs(w * w - l * l));
    if (l == w) return {fall * (1 + w * t), -fall * w * w * t};
    const double c = l < w ? std::cos(nu * t) : std::cosh(nu * t);
    const double s = (l < w ? std::sin(nu * t) : std::sinh(nu * t)) / nu;
    return {fall * (c + l * s), -fall * w * w * s};
}

} // namespace

TEST_CASE("classics: a damped oscillator swings or creeps back by its damping", "[classics]")
{
    const double M = 12, w = 4, x0 = 0.3, T = 1.5;
    for (const double share : {0.1, 0.7, 1., 1.6}) { // λ/ω
        std::vector<double> errors;
        for (const int steps : {60, 120, 240}) {
            World world = solved({free_box()}, {0, 0, 0});
            world.bodies[0].state.position = {1 + x0, 0, 0};
            world.springs = {{-1, 0, {0, 0, 0}, {0, 0, 0}, M * w * w, 2 * M * share * w, 1}};
            run(world, steps, T / steps);
            const Phase phase = closed_form(x0, w, share * w, T);
            const RigidState& body = world.bodies[0].state;
            errors.push_back(std::abs(body.position.x() - 1 - phase.x) +
                             std::abs(body.velocity.x() - phase.v) / w);
        }
        CAPTURE(share, errors);
        check_order(errors, 4);
    }
}

} // namespace damped_oscillator
