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
    const double h = 0.01;
    for (const int steps : {10, 60}) {
        World land = ship({0, 0, 0});
        run(land, steps, h);
        for (const Vector3d& V : {Vector3d(0, 0.1, 0), Vector3d(0, 5, 0), Vector3d(2, 0, -7)}) {
            CAPTURE(V, steps);
            World sea = ship(V);
            run(sea, steps, h);
            for (int i = 1; i < 3; ++i) {
                const Vector3d &a = land.bodies[i].state.position, b = sea.bodies[i].state.position;
                CHECK_THAT(Vector3d(b - steps * h * V), IsClose(a, Order(h * h)));
            }
        }
    }
}
