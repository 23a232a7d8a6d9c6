// SPDX-License-Identifier: MIT
// A thin square plate slides over a table and spins. Each corner bears a quarter of the weight, and
// friction brakes it against its own slip, which makes the plate slide farther and spin longer than
// friction against one of the two motions would (Voyenli and Eriksen 1985, "On the motion of an ice
// hockey puck", Am. J. Phys. 53). The equilibrium does not determine the loads on four corners. If
// they became uneven from step to step, the plate would leave its line.
#include "classics/problems.hpp"

namespace sliding_plate_that_spins {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double side = 0.6, thickness = 2e-4; // [m]
constexpr double mu = 0.2;

struct Motion {
    Vector3d velocity = Vector3d::Zero(); // in the plane y = 0 [m/s]
    double spin = 0, angle = 0;           // about y [rad/s], [rad]
};

// The rates of a plate with equal loads at its corners.
Motion rates(const Motion& now)
{
    Motion rate;
    rate.angle = now.spin;
    const double inertia = side * side / 6; // divided by the mass [m²]
    for (const double x : {-side / 2, side / 2})
        for (const double z : {-side / 2, side / 2}) {
            const Vector3d r = rotation_matrix(turn({0, 1, 0}, now.angle)) * Vector3d(x, 0, z);
            const Vector3d slip = now.velocity + Vector3d(0, now.spin, 0).cross(r);
            const Vector3d a = -mu * g / 4 * slip.normalized();
            rate.velocity += a;
            rate.spin += r.cross(a).y() / inertia;
        }
    return rate;
}

Motion exact_motion(double v, double spin, double T)
{
    const auto moved = [](Motion now, const Motion& rate, double h) {
        now.velocity += h * rate.velocity;
        now.spin += h * rate.spin;
        now.angle += h * rate.angle;
        return now;
    };
    const int steps = 20000;
    Motion now{{v, 0, 0}, spin, 0};
    for (int i = 0; i < steps; ++i)
        now = moved(now, rates(moved(now, rates(now), T / steps / 2)), T / steps);
    return now;
}

} // namespace

TEST_CASE("classics: a plate that slides and spins keeps its line", "[classics]")
{
    const double T = 0.6;
    for (const auto& [v, spin_rate] : {std::pair{2., 5.}, {2., 20.}, {1.5, -8.}}) {
        const Motion exact = exact_motion(v, spin_rate, T);
        for (const bool starts_warm : {true, false})
            for (const double h : {0.01, 0.005, 0.0025}) {
                CAPTURE(v, spin_rate, starts_warm, h);
                RigidBody plate =
                    body_of(Box{{side, thickness, side}}, {0, thickness / 2, 0}, {0, mu});
                plate.state.velocity = {v, 0, 0};
                spin(plate, {0, spin_rate, 0});
                World world = solved({fixed(Plane{}, {0, mu}), plate});
                world.settings.optimisations.warm_start = starts_warm;
                run_until(world, T, h);
                const RigidBody& body = world.bodies[1];
                CHECK_THAT(body.state.velocity, IsClose(exact.velocity, Order(2e-3 * v)));
                CHECK_THAT(angular_velocity(body).y(),
                           IsClose(exact.spin, Order(2e-3 * std::abs(spin_rate))));
            }
    }
}

} // namespace sliding_plate_that_spins
