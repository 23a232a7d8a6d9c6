// SPDX-License-Identifier: MIT
// A plank on two rollers that turn against each other (Timoshenko 1937, "Vibration problems in
// engineering"): the roller that bears more weight pushes the plank harder. If the tops of the
// rollers move towards each other, the plank swings; if they move apart, it runs away.
//
// The rollers are at ±d, and c is half of the plank's thickness. The loads N₁ and N₂ balance weight
// and friction, F = ±μ (N₁ - N₂), about the center of mass:
//     d (N₂ - N₁) - x M g + c F = 0,   so   x'' = ∓ μ g/(d ∓ μ c) x
#include "classics/problems.hpp"

#include <cmath>

namespace plank_on_driven_rollers {

using namespace rigor;
using namespace rigor::testing;

namespace {

struct Rollers {
    double d = 0.5;     // half of the distance between the rollers [m]
    double mu = 0.3;    // friction
    double width = 0.4; // width of the plank [m]
    double spin = 40;   // angular speed; where it is > 0, the tops of the rollers approach [rad/s]
    double heading = 0; // direction of the plank's length, an angle about y [rad]
};

// @return largest distance from the exact path, relative to the largest exact |x|
double error_of(const Rollers& rollers, double first, double T, int steps)
{
    const auto& [d, mu, width, spin, heading] = rollers;
    const double r = 0.15, c = 0.05, side = spin > 0 ? 1 : -1;
    const Material rough{0, mu};
    const Quaternion ahead = turn({0, 1, 0}, heading);
    const Matrix3d R = rotation_matrix(ahead);
    const Quaternion lying = turn(R.col(0), pi / 2); // axis along z of the plank
    const auto roller = [&](double x, double omega) {
        const Vector3d X = R * Vector3d(x, r, 0), axis = R.col(2);
        return driven(Cylinder{r, 1}, rough, X, turning(omega * axis), lying);
    };
    const Vector3d X = R * Vector3d(first, 2 * r + c, 0);
    World world = solved(
        {roller(-d, -spin), roller(d, spin), body_of(Box{{6, 2 * c, width}}, X, rough, ahead)});
    const double rate = std::sqrt(mu * g / (d - side * mu * c));
    double off = 0, most = 0;
    for (int i = 1; i <= steps; ++i) {
        step(world, T / steps);
        const double t = rate * T * i / steps;
        const double x = first * (side > 0 ? std::cos(t) : std::cosh(t));
        const Vector3d exact = R * Vector3d(x, 2 * r + c, 0);
        off = std::max(off, (world.bodies[2].state.position - exact).norm());
        most = std::max(most, std::abs(x));
    }
    return off / most;
}

} // namespace

TEST_CASE("classics: a plank on rollers that turn against each other swings",
          "[classics][.long][unsanitized]")
{
    Sweep sweep;
    for (const double d : {0.3, 0.5, 1.0})
        for (const double mu : {0.1, 0.3, 0.8})
            for (const double width : {0.1, 0.4})
                for (const double heading : {0., 0.6}) {
                    if (!sweep.takes_next()) continue;
                    CAPTURE(d, mu, width, heading);
                    const Rollers rollers{d, mu, width, 40, heading};
                    const double T = 2 * 2 * pi / std::sqrt(mu * g / (d - mu * 0.05));
                    const double coarse = error_of(rollers, 0.1, T, 400),
                                 fine = error_of(rollers, 0.1, T, 800);
                    check_at_most(fine, 0.3 * coarse, "error by half of the step");
                    check_at_most(fine, 1e-3, "error of the path");
                }
}

TEST_CASE("classics: a plank on rollers that turn apart runs away", "[classics]")
{
    for (const double mu : {0.1, 0.4}) {
        CAPTURE(mu);
        const Rollers rollers{0.5, mu, 0.4, -40, 0};
        const double T = 2 / std::sqrt(mu * g / (0.5 + mu * 0.05));
        const double coarse = error_of(rollers, 0.1, T, 100), fine = error_of(rollers, 0.1, T, 200);
        check_at_most(fine, 0.3 * coarse, "error by half of the step");
        check_at_most(fine, 1e-3, "error of the path");
    }
}

} // namespace plank_on_driven_rollers
