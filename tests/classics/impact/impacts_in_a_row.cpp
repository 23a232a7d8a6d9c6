// SPDX-License-Identifier: MIT
// Impacts one after the other: a row of balls of different masses, a light ball on a heavy one, a
// cube that trips over a sill, and a cue ball that follows or draws back.
#include "balls_on_a_line.hpp"
#include "framework/rigid/worlds.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace impacts_in_a_row {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double radius = 0.1, gap = 0.013; // [m]

RigidBody ball_of_mass(double mass, const Vector3d& X)
{
    RigidBody ball = body_of(Sphere{radius}, X, {1, 0});
    const double density = mass / ball.mass;
    set_mass(ball, mass, density * ball.inertia);
    return ball;
}

} // namespace

TEST_CASE("classics: a row of balls hands on what their masses allow", "[classics]")
{
    const std::vector<std::vector<double>> rows = {{1, 1, 1},   {1, 2, 3},   {3, 2, 1},
                                                   {1, 0.1, 1}, {1, 100, 1}, {4, 2, 1, 0.5, 0.25}};
    for (const std::vector<double>& masses : rows)
        for (const double v : {0.5, 2.})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(masses, v, h);
                std::vector<RigidBody> bodies;
                BallsOnALine line;
                line.radius = radius;
                for (std::size_t i = 0; i < masses.size(); ++i) {
                    const double x = static_cast<double>(i) * (2 * radius + gap);
                    bodies.push_back(ball_of_mass(masses[i], {x, 0, 0}));
                    line.balls.push_back({x, 0, masses[i]});
                }
                bodies[0].state.velocity = {v, 0, 0};
                line.balls[0].v = v;
                World world = world_of(bodies, {0, 0, 0});
                world.settings.formulas_are_reference = true;
                const int steps = static_cast<int>(std::lround(1 / h));
                run(world, steps, h);
                line.advance(steps * h);
                for (std::size_t i = 0; i < masses.size(); ++i)
                    CHECK_THAT(world.bodies[i].state.velocity.x(),
                               IsClose(line.balls[i].v, Rounding(1e3, v)));
            }
}

// A small ball dropped on top of a large one leaves with (3 M - m)/(M + m) times the speed of the
// fall (Harter 1971, "Velocity amplification in collision experiments", Am. J. Phys. 39).
TEST_CASE("classics: a light ball on a heavy one bounces up to three times as fast", "[classics]")
{
    const double height = 1, apart = 0.02;
    for (const double ratio : {3., 10., 1000.}) {
        CAPTURE(ratio);
        World world =
            world_of({fixed(Plane{}, {1, 0}), ball_of_mass(ratio, {0, height + radius, 0}),
                      ball_of_mass(1, {0, height + 3 * radius + apart, 0})});
        world.settings.formulas_are_reference = true;
        const double h = 1 / 1000., T = 0.55;
        run(world, static_cast<int>(std::lround(T / h)), h);
        const double v = std::sqrt(2 * g * height), meets = apart / (2 * v);
        const double down = v + g * meets, up = v - g * meets;
        const double center = (ratio * up - down) / (ratio + 1);
        const double flies = T - v / g - meets;
        CHECK_THAT(world.bodies[2].state.velocity.y(),
                   IsClose(2 * center + down - g * flies, Order(1e-6)));
    }
}

// A cube of edge 2a that slides against a low sill turns over it if v² > 16/3 (√2 - 1) g a: the
// impact keeps the moment of momentum about the sill, the rest is a matter of energy.
TEST_CASE("classics: a cube trips over a sill at its critical speed", "[classics]")
{
    const double a = 0.5, sill = 0.02, critical = std::sqrt(16. / 3 * g * a * (std::sqrt(2.) - 1));
    for (const double share : {0.9, 0.95, 1.05, 1.1})
        for (const double h : {1 / 60., 1 / 240.}) {
            CAPTURE(share, h);
            RigidBody cube = body_of(Box{{2 * a, 2 * a, 2 * a}}, {0, a, 0}, {0, 0});
            cube.state.velocity = {share * critical, 0, 0};
            World world = world_of({fixed(Plane{}, {0, 0}), cube,
                                    fixed(Box{{0.5, 2 * sill, 4}}, {0, 0}, {a + 0.55, 0, 0})});
            world.settings.formulas_are_reference = true;
            run(world, static_cast<int>(std::lround(2.5 / h)), h);
            const Matrix3d R = rotation_matrix(world.bodies[1].state.orientation);
            if (share < 1)
                check_at_least(R(1, 1), 0.99, "cosine of the tilt");
            else
                check_at_most(R(1, 1), 0.1, "cosine of the tilt");
        }
}

// Coriolis (1835): after a full impact on an equal ball only the spin is left to the cue ball. The
// cloth turns it into 2/7 R ω: forwards if it rolled (follow), backwards if it spun back (draw).
TEST_CASE("classics: a cue ball follows or draws by two sevenths of its spin", "[classics]")
{
    const double R = 0.03, v = 1, mu = 0.2, way = 0.1 - 2 * R;
    for (const double spins : {-2., -1., 0., 0.5, 1., 2.}) { // R ω / v, forwards if positive
        std::vector<double> errors;
        for (const int rate : {120, 480, 1920}) {
            RigidBody cue = body_of(Sphere{R}, {-0.1, R, 0}, {1, 1});
            RigidBody object = body_of(Sphere{R}, {0, R, 0}, {1, 1});
            cue.state.velocity = {v, 0, 0};
            spin(cue, {0, 0, -spins * v / R});
            World world = world_of({fixed(Plane{}, {0, 1}), cue, object});
            world.settings.formulas_are_reference = true;
            world.pair_laws = {{0, 1, {}, mu, true}, {0, 2, {}, mu, true}, {1, 2, 1., 0., true}};
            run(world, rate, 1. / rate);
            // Until the impact the cloth accelerates the ball and slows its spin, or it rolls.
            const double a = spins > 1 ? mu * g : -mu * g;
            const double slides = std::abs(1 - spins) * v / (3.5 * mu * g);
            const bool rolls = v * slides + a * slides * slides / 2 < way;
            const double t = (-v + std::sqrt(v * v + 2 * a * way)) / a;
            const double turns = rolls ? (5 + 2 * spins) / 7 * v : spins * v - 2.5 * a * t;
            errors.push_back(std::abs(world.bodies[1].state.velocity.x() - 2. / 7 * turns));
        }
        CAPTURE(spins, errors);
        check_at_most(errors.back(), 1e-3 * v, "error of the speed [m/s]");
        check_at_most(errors.front(), 1e-2 * v, "error of the speed [m/s]");
    }
}

} // namespace impacts_in_a_row
