// SPDX-License-Identifier: MIT
// Several hits within one time step, each at its own time: a ball that flies into a corner, balls
// that fall on the floor one above the other, and a bounce beside a body at rest. Between hits the
// bodies fly freely, so positions and velocities follow from one hit to the next in closed form.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

const Material elastic{1, 0};

// The coordinate of a point between mirrors at -room/2 and room/2 that starts in the middle.
double in_mirrors(double v, double t, double room)
{
    const double way = std::fmod(room / 2 + std::abs(v) * t, 2 * room);
    return std::copysign((way < room ? way : 2 * room - way) - room / 2, v);
}

} // namespace

TEST_CASE("classics: a ball that flies into a corner leaves it along the way that it came",
          "[classics]")
{
    const double w = 0.1, room = 1; // radius, and room of the center [m]
    for (const double h : {0.02, 0.01, 0.003})
        for (const double later : {0.0, 1e-9, 1e-4, 1e-3, 2.5e-3, 4e-3, 9e-3, 0.03}) {
            CAPTURE(h, later);
            const double t = 0.1037; // when the ball hits the first wall [s]
            RigidBody body = body_of(Sphere{w}, {0, 0, 0}, elastic);
            body.state.velocity = {room / 2 / t, 0, room / 2 / (t + later)};
            const Vector3d v = body.state.velocity;
            World world = solved({fixed(Box{{1, 9, 9}}, elastic, {room / 2 + w + 0.5, 0, 0}),
                                  fixed(Box{{9, 9, 1}}, elastic, {0, 0, room / 2 + w + 0.5}), body},
                                 {0, 0, 0});
            run_until(world, 0.2, h);
            const RigidState& end = world.bodies[2].state;
            CHECK_THAT(end.velocity, IsClose(Vector3d(-v), Rounding(1e4)));
            CHECK_THAT(end.position, IsClose(Vector3d(in_mirrors(v.x(), world.time, room), 0,
                                                      in_mirrors(v.z(), world.time, room)),
                                             Order(1e-8)));
            CHECK_THAT(end.angular_momentum, IsClose(Vector3d(0, 0, 0), Rounding(1e4, 1)));
        }
}

TEST_CASE("classics: two balls that fall one above the other meet where they should", "[classics]")
{
    const double R = 0.1;
    for (const double h : {0.02, 0.01, 0.003})
        for (const double gap : {1e-5, 1e-3, 2e-3, 0.01, 0.05})
            for (const double ratio : {0.02, 0.1, 0.2}) { // mass of the upper ball by the lower one
                CAPTURE(h, gap, ratio);
                const double drop = 0.8;
                RigidBody lower = body_of(Sphere{R}, {0, R + drop, 0}, elastic),
                          upper = body_of(Sphere{R}, {0, 3 * R + drop + gap, 0}, elastic);
                set_mass(upper, ratio * lower.mass, ratio * lower.inertia);
                World world = solved({fixed(Plane{}, elastic), lower, upper});

                // The lower ball reaches the floor with speed u. At the time t after that, the
                // balls are nearer by 2 u t: both fall with g.
                const double u = std::sqrt(2 * g * drop), t = gap / (2 * u);
                const double v1 = u - g * t, v2 = -u - g * t; // when they meet
                const double u1 = ((1 - ratio) * v1 + 2 * ratio * v2) / (1 + ratio),
                             u2 = ((ratio - 1) * v2 + 2 * v1) / (1 + ratio);
                const double met = u / g + t, y1 = R + u * t - g * t * t / 2;
                const double end = met + 0.15;
                const double fall = u1 + std::sqrt(u1 * u1 + 2 * g * (y1 - R));
                REQUIRE(fall / g > 0.15 + h); // it does not hit the floor once more
                run_until(world, end, h);
                const double s = world.time - met;
                CHECK_THAT(world.bodies[1].state.velocity.y(), IsClose(u1 - g * s, Order(1e-7)));
                CHECK_THAT(world.bodies[2].state.velocity.y(), IsClose(u2 - g * s, Order(1e-7)));
                CHECK_THAT(world.bodies[1].state.position.y(),
                           IsClose(y1 + u1 * s - g * s * s / 2, Order(1e-7)));
            }
}

TEST_CASE("classics: a body at rest takes no energy from a bounce beside it", "[classics]")
{
    const double R = 0.1;
    for (const double h : {0.01, 0.004})
        // The flight past the ball at rest is predicted only to a few times g h², the way of a
        // free fall in a step.
        for (const double gap : {4 * g * h * h, 5e-3, 0.02})
            for (int i = 0; i < 25; ++i) {
                const double fall = 0.5 + 0.02 * i;
                CAPTURE(h, gap, fall);
                World world =
                    solved({fixed(Plane{}, elastic), body_of(Sphere{R}, {0, R + fall, 0}, elastic),
                            body_of(Sphere{R}, {2 * R + gap, R, 0}, {0, 0})});
                const double energy = world.bodies[1].mass * g * (R + fall);
                run_until(world, 1.5 * std::sqrt(2 * fall / g), h);
                const RigidBody& ball = world.bodies[1];
                CHECK_THAT(ball.mass * (ball.state.velocity.squaredNorm() / 2 +
                                        g * ball.state.position.y()),
                           IsClose(energy, Order(1e-8 * energy)));
            }
}
