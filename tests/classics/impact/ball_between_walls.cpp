// SPDX-License-Identifier: MIT
// A ball flies to and fro between two walls: unfolded by mirrors, its path is a straight line. If a
// wall comes on slowly, speed times room stays constant (Fermi 1949; Ehrenfest's adiabatic
// invariant): each meeting with the wall adds twice the wall's speed.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a ball between walls goes along a straight line in the mirrors", "[classics]")
{
    const double R = 0.1, room = 1.37; // radius, and room of the center [m]
    const Material elastic{1, 0};
    const double wall = room / 2 + R + 0.5;
    for (const double v : {0.9, 7.3})
        for (const double h : {0.01, 1 / 240.}) {
            CAPTURE(v, h);
            RigidBody ball = body_of(Sphere{R}, {0, 0, 0}, elastic);
            ball.state.velocity = {v, 0, 0.2};
            World world = solved({fixed(Box{{1, 4, 9}}, elastic, {-wall, 0, 0}),
                                  fixed(Box{{1, 4, 9}}, elastic, {wall, 0, 0}), ball},
                                 {0, 0, 0});
            const double T = 5;
            run_until(world, T, h);
            const double way = std::fmod(room / 2 + v * world.time, 2 * room);
            const double x = (way < room ? way : 2 * room - way) - room / 2;
            CHECK_THAT(world.bodies[2].state.position.x(), IsClose(x, Order(1e-9)));
            CHECK_THAT(world.bodies[2].state.velocity.norm(),
                       IsClose(std::hypot(v, 0.2), Rounding(1e4)));
        }
}

TEST_CASE("classics: a ball before a wall that comes on gains twice its speed", "[classics]")
{
    const double R = 0.1, room = 1, u = 0.02, v = 3; // the room of the center [m]
    const Material elastic{1, 0};
    RigidBody ball = body_of(Sphere{R}, {0, 0, 0}, elastic);
    ball.state.velocity = {v, 0, 0};
    World world =
        solved({fixed(Box{{1, 4, 4}}, elastic, {-R - 0.5, 0, 0}),
                driven(Box{{1, 4, 4}}, elastic, {room + R + 0.5, 0, 0}, moving({-u, 0, 0})), ball},
               {0, 0, 0});
    const double T = 20, h = 0.005;
    run_until(world, T, h);
    double x = 0, t = 0, speed = v; // from one meeting with the still wall to the next
    while (true) {
        const double meets = (room - u * t) / (speed + u),
                     back = (room - u * (t + meets)) / (speed + 2 * u);
        if (t + meets + back > T) {
            x = t + meets > T ? speed * (T - t)
                              : room - u * (t + meets) - (speed + 2 * u) * (T - t - meets);
            if (t + meets < T) speed += 2 * u;
            break;
        }
        t += meets + back;
        speed += 2 * u;
    }
    CHECK_THAT(std::abs(world.bodies[2].state.velocity.x()), IsClose(speed, Order(1e-9)));
    CHECK_THAT(world.bodies[2].state.position.x(), IsClose(x, Order(1e-7)));
    CHECK_THAT(speed * (room - u * T), IsClose(v * room, Order(0.05 * v)));
}
