// SPDX-License-Identifier: MIT
// A round body rolls down a slope without slipping if μ ≥ tan α/(1 + 1/k), k = I/(M R²): 2/7 tan α
// for a ball, 1/3 tan α for a cylinder. With less friction it slides with g (sin α - μ cos α) and
// is turned by μ g cos α/(k R) (Sommerfeld, "Mechanics", § 11).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: what is round rolls if the slope is rough enough", "[classics]")
{
    const double R = 0.2, angle = 0.6, T = 0.8;
    for (const bool is_ball : {true, false})
        for (const double share : {0.3, 0.97, 1.03})
            for (const double h : {0.01, 0.0025}) {
                CAPTURE(is_ball, share, h);
                const double k = is_ball ? 0.4 : 0.5, mu = share * std::tan(angle) / (1 + 1 / k);
                const Shape shape = is_ball ? Shape(Sphere{R}) : Shape(Cylinder{R, 0.5});
                World world = solved({fixed(Plane{}, {0, mu}),
                                      body_of(shape, {0, R, 0}, {0, mu}, turn({1, 0, 0}, pi / 2))},
                                     gravity_on_slope(angle));
                run_until(world, T, h);
                const double v = world.bodies[1].state.velocity.x();
                const double w = -angular_velocity(world.bodies[1]).z();
                const double slides = g * (std::sin(angle) - mu * std::cos(angle));
                const double rolls = g * std::sin(angle) / (1 + k);
                CHECK_THAT(v, IsClose((share < 1 ? slides : rolls) * T, Order(1e-5)));
                const double turns = share < 1 ? mu * g * std::cos(angle) / (k * R) : rolls / R;
                CHECK_THAT(w, IsClose(turns * T, Order(1e-4)));
            }
}
