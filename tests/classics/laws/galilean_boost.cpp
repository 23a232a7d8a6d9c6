// SPDX-License-Identifier: MIT
// No experiment tells whether a ship stands or moves evenly (Galilei 1632, "Dialogo"): bodies that
// collide, slide and swing on springs do the same if all of them, ground and anchors included, have
// an additional velocity.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: all happens in a moving ship as on land", "[classics]")
{
    const auto ship = [](const Vector3d& V) {
        const Material material{0.6, 0.3};
        RigidBody box = body_of(Box{{0.4, 0.3, 0.5}}, {0, 0.15, 0}, material);
        RigidBody ball = body_of(Sphere{0.15}, {-0.9, 0.5, 0.05}, material);
        box.state.velocity = V;
        ball.state.velocity = V + Vector3d(3, 0, 0);
        World world =
            solved({V.isZero() ? fixed(Box{{9, 1, 9}}, material, {0, -0.5, 0})
                               : driven(Box{{9, 1, 9}}, material, {0, -0.5, 0}, moving(V)),
                    box, ball});
        world.springs = {{0, 1, {2, 0.5, 0}, {0.2, 0, 0}, 200, 0, 1}};
        return world;
    };
    for (const int steps : {10, 60}) {
        const double h = 0.01;
        World land = ship({0, 0, 0}), slow = ship({0, 0.1, 0});
        run(land, steps, h);
        run(slow, steps, h);
        for (const Vector3d& V : {Vector3d(0, 5, 0), Vector3d(2, 0, -7)}) {
            CAPTURE(V, steps);
            World fast = ship(V);
            run(fast, steps, h);
            for (int i = 1; i < 3; ++i) {
                const Vector3d &a = land.bodies[i].state.position,
                               &b = slow.bodies[i].state.position,
                               &c = fast.bodies[i].state.position;
                const Vector3d way = steps * h * V, slow_way(0, steps * h * 0.1, 0);
                CHECK_THAT(Vector3d(c - way), IsClose(Vector3d(b - slow_way), Order(1e-9)));
                CHECK_THAT(Vector3d(c - way), IsClose(a, Order(h * h)));
            }
        }
    }
}
