// SPDX-License-Identifier: MIT
// A ball that meets a rough floor at a slant (Garwin 1969; Cross 2002, "Grip-slip behavior of a
// bouncing ball", Am. J. Phys. 70): if μ (1 + ε) v_n is at least 2/7 of the slip, the slip ends and
// v_t' = (5 v_t + 2 R ω)/7, else v_t falls by μ (1 + ε) v_n and R ω changes by 5/2 of that.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball that bounces on a rough floor grips or slips", "[classics]")
{
    const double R = 0.1, down = 2, ahead = 3;
    for (const double e : {0.5, 0.9})
        for (const double mu : {0.05, 0.2, 0.27, 0.29, 0.4, 2.})
            for (const double spins : {-4., 0., 3., 8.}) { // R ω, ahead if positive
                CAPTURE(e, mu, spins);
                RigidBody ball = body_of(Sphere{R}, {0, 0.213, 0}, {e, mu});
                ball.state.velocity = {ahead, -down, 0};
                spin(ball, {0, 0, -spins / R});
                World world = solved({fixed(Plane{}, {e, mu}), ball}, {0, 0, 0});
                run(world, 10, 0.01);
                const double slip = ahead - spins, most = mu * (1 + e) * down;
                const double change = std::copysign(std::min(most, 2 * std::abs(slip) / 7), slip);
                const RigidBody& after = world.bodies[1];
                CHECK_THAT(after.state.velocity,
                           IsClose(Vector3d(ahead - change, e * down, 0), Rounding(1e4, 4)));
                CHECK_THAT(-R * angular_velocity(after).z(),
                           IsClose(spins + 2.5 * change, Rounding(1e4, 10)));
            }
}
