// SPDX-License-Identifier: MIT
// A ball that rolls against a low step climbs it if it is fast enough: the impact keeps the
// moment of momentum about the edge, M v (R - s) + I v/R = (I + M R²) ω, and then ½ (I + M R²) ω²
// must exceed M g s (Irodov, "Problems in general physics").
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball climbs a step from its critical speed on", "[classics]")
{
    const double R = 0.3;
    const Material rough{0, 100};
    for (const double s : {0.03, 0.08})
        for (const double share : {0.95, 1.05})
            for (const double h : {0.005, 0.001}) {
                CAPTURE(s, share, h);
                RigidBody ball = body_of(Sphere{R}, {-0.8, R, 0}, rough);
                const double M = ball.mass, I = 0.4 * M * R * R, whole = I + M * R * R;
                const double critical = std::sqrt(2 * M * g * s * whole) / (M * (R - s) + I / R);
                ball.state.velocity = {share * critical, 0, 0};
                spin(ball, {0, 0, -share * critical / R});
                World world = solved(
                    {fixed(Plane{}, rough), fixed(Box{{4, 2, 4}}, rough, {2, s - 1, 0}), ball});
                run_until(world, 3, h);
                if (share < 1)
                    check_at_most(world.bodies[2].state.position.x(), 0, "place [m]");
                else
                    check_at_least(world.bodies[2].state.position.x(), 0.05, "place [m]");
            }
}
