// SPDX-License-Identifier: MIT
// Wheels that driven wheels turn by friction. Where neither slips, both rims move at one velocity:
// gears without teeth.
#include "classics/problems.hpp"

#include <cmath>

namespace wheels_on_driven_wheels {

using namespace rigor;
using namespace rigor::testing;

namespace {

const Material rough{0, 0.4};
const Quaternion along_z = turn({1, 0, 0}, pi / 2); // the axis of a lying cylinder

RigidBody lying(double radius, const Vector3d& X)
{
    return body_of(Cylinder{radius, 0.4}, X, rough, along_z);
}

} // namespace

// A wheel of radius R between a driven roller of radius r and a smooth wall, or between two
// rollers: its spin becomes -Ω r/R, whatever the step is.
TEST_CASE("classics: a roller turns a wheel by the ratio of their radii", "[classics]")
{
    for (const double r : {0.02, 0.1, 0.3})
        for (const double R : {0.02, 0.2})
            for (const double omega : {5., -30.})
                for (const bool has_wall : {true, false})
                    for (const double h : {0.01, 0.0025}) {
                        const double exact = -omega * r / R;
                        if (std::abs(exact) * h > pi / 5) continue; // a tenth of a turn
                        CAPTURE(r, R, omega, has_wall, h);
                        const double away = (R + r) / std::sqrt(2); // the contacts are at 45°
                        const Vector3d X(0, away, 0);
                        const RigidBody roller = driven(Cylinder{r, 1}, rough, {-away, 0, 0},
                                                        turning({0, 0, omega}), along_z);
                        RigidBody other = roller;
                        if (has_wall) {
                            const Vector3d n = Vector3d(-1, 1, 0).normalized();
                            other = fixed(Box{{4 * R, 0.1, 1}}, {0, 0}, X - (R + 0.05) * n,
                                          turn({0, 0, 1}, pi / 4));
                        } else {
                            other = driven(Cylinder{r, 1}, rough, {away, 0, 0},
                                           turning({0, 0, omega}), along_z);
                        }
                        RigidBody wheel = lying(R, X);
                        spin(wheel, {0, 0, 0.9 * exact});
                        World world = solved({roller, other, wheel});
                        run_until(world, 0.5, h);
                        const Vector3d w = angular_velocity(world.bodies[2]);
                        CHECK_THAT(w.z(), IsClose(exact, Order(1e-8 * std::abs(exact))));
                        CHECK_THAT(world.bodies[2].state.position, IsClose(X, Order(1e-6 * R)));
                    }
}

// A spring pulls a planet (a wheel of radius R and the moment of inertia k M R²) to the center of a
// sun (a roller of radius r). If the planet starts at rest, friction gives it the momentum M v and
// the spin -v/(k R) until its rim is as fast as that of the sun: v + v/k = Ω r.
TEST_CASE("classics: a planet that rolls round a driven sun keeps its speed",
          "[classics][unsanitized]")
{
    const double k = 0.5, r = 0.3, R = 0.1;
    for (const double omega : {12., -6., 2.})
        for (const bool starts_at_rest : {true, false}) {
            const double v = k / (1 + k) * omega * r, rate = v / (r + R), T = 2;
            std::vector<double> errors;
            for (const int steps : {400, 800, 1600}) {
                RigidBody planet = lying(R, {r + R, 0, 0});
                if (!starts_at_rest) {
                    planet.state.velocity = {0, v, 0};
                    spin(planet, {0, 0, -v / (k * R)});
                }
                World world = solved(
                    {driven(Cylinder{r, 1}, rough, {0, 0, 0}, turning({0, 0, omega}), along_z),
                     planet},
                    {0, 0, 0});
                const double stiffness =
                    200 * planet.mass; // pulls harder than the planet flies off
                world.springs.push_back({0, 1, {0, 0, 0}, {0, 0, 0}, stiffness, 0, 0});
                run(world, steps, T / steps);
                const RigidBody& last = world.bodies[1];
                const double speed = last.state.velocity.norm();
                errors.push_back(std::abs(speed / std::abs(v) - 1));
                CHECK_THAT(last.state.position.norm(), IsClose(r + R, Order(1e-3 * R)));
                if (starts_at_rest) continue;
                const Vector3d X(std::cos(rate * T), std::sin(rate * T), 0);
                errors.back() += (last.state.position - (r + R) * X).norm();
            }
            CAPTURE(omega, starts_at_rest, errors);
            check_at_most(errors[1], 0.3 * errors[0], "error by half of the step");
            check_at_most(errors[2], 0.3 * errors[1], "error by a quarter of the step");
            check_at_most(errors[2], 2e-3, "error of the last run");
        }
}

} // namespace wheels_on_driven_wheels
