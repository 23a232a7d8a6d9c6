// SPDX-License-Identifier: MIT
// A ball on a turntable that is tilted does not roll down: it drifts level, with
// 5 g sin α/(2 Ω), while it goes round with 2/7 Ω (Gersten, Soodak and Tiersten 1992, "Ball moving
// on stationary or rotating horizontal surface", Am. J. Phys. 60):
// V̇ = 2/7 Ω × V + 5/7 g along the table, and V = 5/2 Ω × g/Ω² is steady.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball on a tilted turntable drifts level", "[classics]")
{
    const double R = 0.1, Omega = 6, angle = 0.1, rate = 2. / 7 * Omega, T = 2 * pi / rate;
    const Material rough{0, 100};
    std::vector<double> errors;
    for (const int steps : {500, 1000, 2000}) {
        RigidBody ball = body_of(Sphere{R}, {0, R, 0}, rough); // at rest at the middle of the table
        World world =
            solved({driven(Box{{40, 1, 40}}, rough, {0, -0.5, 0}, turning({0, Omega, 0})), ball},
                   gravity_on_slope(angle));
        spin(world.bodies[1], {0, 0, 0});
        run(world, steps, T / steps); // once round: only the drift is left
        const double drift = 5 * g * std::sin(angle) / (2 * Omega);
        errors.push_back((world.bodies[1].state.position - Vector3d(0, R, -drift * T)).norm());
    }
    CAPTURE(errors);
    check_at_most(errors.back(), 1e-2, "distance from the place of the drift [m]");
    check_at_most(errors[2], 0.6 * errors[0], "error by a quarter of the step [m]");
}
