// SPDX-License-Identifier: MIT
// A ball on a rope goes round in a circle under its hook (Huygens 1673, "Horologium
// oscillatorium"): at the height H below the hook it takes 2π √(H/g), whatever the rope stretches.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

// A rope of the stretched length L at the angle θ: k (L - l) cos θ = M g and ω² = g/(L cos θ).
TEST_CASE("classics: a conical pendulum takes the time of its height", "[classics]")
{
    const double M = 12, L = 1, k = 2000;
    for (const double degrees : {10., 45., 75.}) {
        const double a = degrees * pi / 180, H = L * std::cos(a), w = std::sqrt(g / H);
        const double T = 2 * pi / w;
        std::vector<double> errors;
        for (const int steps : {100, 200, 400}) {
            World world = solved({free_box()});
            RigidState& s = world.bodies[0].state;
            const Vector3d X(L * std::sin(a), -H, 0);
            s.position = X;
            s.velocity = Vector3d(0, w, 0).cross(X);
            Spring rope{-1, 0, {0, 0, 0}, {0, 0, 0}, k, 0, L - M * g / (k * std::cos(a))};
            rope.only_pulls = true;
            world.springs = {rope};
            run(world, steps, T / steps);
            errors.push_back((s.position - X).norm());
        }
        CAPTURE(degrees, errors);
        check_order(errors, 4);
    }
}
