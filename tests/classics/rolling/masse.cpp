// SPDX-License-Identifier: MIT
// A ball that slips in any direction goes along a parabola until it rolls (Coriolis 1835): the slip
// u = V + ω × (-R y) keeps its direction, falls by 7/2 μ g, and leaves V - 2/7 u.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball with side spin goes along a parabola", "[classics]")
{
    const double R = 0.03, mu = 0.2;
    const Vector3d V(1, 0, 0.2), y(0, 1, 0);
    for (const Vector3d& w : {Vector3d(40, 7, 20), Vector3d(-30, 0, 60)}) {
        const Vector3d u = V + w.cross(-R * y);
        const double slips = 2 * u.norm() / (7 * mu * g);
        for (const double h : {0.01, 0.005, 0.0025}) {
            CAPTURE(w, h);
            RigidBody ball = body_of(Sphere{R}, {0, R, 0}, {0, mu});
            ball.state.velocity = V;
            spin(ball, w);
            World world = solved({fixed(Plane{}, {0, mu}), ball});
            run_until(world, std::floor(slips / 2 / h) * h, h);
            const double t = world.time;
            const Vector3d X = Vector3d(0, R, 0) + V * t - mu * g / 2 * t * t * u.normalized();
            CHECK_THAT(world.bodies[1].state.position, IsClose(X, Order(1e-6)));
            run_until(world, slips + 0.1 - t, h);
            CHECK_THAT(world.bodies[1].state.velocity,
                       IsClose(Vector3d(V - 2. / 7 * u), Order(1e-6)));
        }
    }
}
