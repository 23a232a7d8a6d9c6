// SPDX-License-Identifier: MIT
// A damped oscillator under a force F sin Ω t settles to B sin(Ω t - δ) with
// B = F/M / √((ω² - Ω²)² + 4 λ² Ω²) and tan δ = 2 λ Ω/(ω² - Ω²) (Landau and Lifshitz, § 26).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a forced vibration lags behind its force", "[classics]")
{
    const double M = 12, w = 6, l = 0.8, F = 20;
    for (const double share : {0.4, 1., 2.}) { // Ω/ω
        const double W = share * w, T = 2.3;
        const double B = F / M / std::hypot(w * w - W * W, 2 * l * W);
        const double delta = std::atan2(2 * l * W, w * w - W * W);
        std::vector<double> errors;
        for (const int steps : {200, 400, 800}) {
            World world = solved({free_box()}, {0, 0, 0});
            RigidState& s = world.bodies[0].state; // as if it had swung for ever
            s.position = {2 - B * std::sin(delta), 0, 0};
            s.velocity = {B * W * std::cos(delta), 0, 0};
            world.springs = {{-1, 0, {0, 0, 0}, {0, 0, 0}, M * w * w, 2 * M * l, 2}};
            AppliedForce force;
            force.force = {F, 0, 0};
            force.frequency = W / (2 * pi);
            world.forces = {force};
            run(world, steps, T / steps);
            const double x = B * std::sin(W * T - delta);
            errors.push_back(std::abs(world.bodies[0].state.position.x() - 2 - x) / B);
        }
        CAPTURE(share, errors);
        check_order(errors, 4);
    }
}
