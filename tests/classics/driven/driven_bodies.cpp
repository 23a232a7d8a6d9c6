// SPDX-License-Identifier: MIT
// Bodies on tables, belts and rollers whose motion is given: the answers are those of textbooks,
// and the carried bodies must neither creep nor gain energy.
#include "classics/problems.hpp"

#include <cmath>
#include <numbers>

namespace driven_bodies {

using namespace rigor;
using namespace rigor::testing;

namespace {

const Box table{{20, 1, 20}};
const Vector3d under(0, -0.5, 0); // center of a table whose top is at y = 0 [m]

} // namespace

// Weckesser (1997, "A ball rolling on a freely spinning turntable", Am. J. Phys. 65): on a table
// that turns with Ω a homogeneous ball rolls along a circle, which it goes round with 2/7 Ω.
TEST_CASE("classics: a ball on a turntable rolls in circles", "[classics]")
{
    const Material rough{0, 100};
    for (const double Omega : {1., 3., -5.})
        for (const double radius : {0.05, 0.2})
            for (const double v : {0., 0.3}) {
                CAPTURE(Omega, radius, v);
                const double rate = 2. / 7 * Omega, T = 2 * pi / std::abs(rate);
                std::vector<double> errors;
                for (const int steps : {1000, 2000, 4000}) {
                    const Vector3d start(0.4, radius, 0);
                    RigidBody ball = body_of(Sphere{radius}, start, rough);
                    ball.state.velocity = {0, 0, v};
                    // V + ω × (-r y) = Ω y × X
                    const Vector3d slip = Vector3d(0, Omega, 0).cross(start) - ball.state.velocity;
                    spin(ball, Vector3d::UnitY().cross(slip) / -radius);
                    World world =
                        solved({driven(table, rough, under, turning({0, Omega, 0})), ball});
                    double off = 0; // largest distance from the circle, over the whole path [m]
                    const Vector3d center =
                        start + Vector3d(0, 1, 0).cross(Vector3d(0, 0, v)) / rate;
                    for (int i = 1; i <= steps; ++i) {
                        step(world, T / steps);
                        const Vector3d r = rotation_matrix(turn({0, 1, 0}, rate * T * i / steps)) *
                                           (start - center);
                        off = std::max(off, (world.bodies[1].state.position - center - r).norm());
                    }
                    errors.push_back(off);
                }
                if (v == 0) {
                    check_at_most(errors.back(), 1e-9, "motion of a ball that stays [m]");
                } else {
                    CHECK(errors[1] < 0.3 * errors[0]);
                    check_at_most(errors.back(), 1e-3, "distance from the circle [m]");
                }
            }
}

TEST_CASE("classics: a block stays on a turntable up to the speed that friction allows",
          "[classics]")
{
    const double mu = 0.4, r = 0.5, critical = std::sqrt(mu * g / r);
    for (const double share : {0.3, 0.98, 1.02})
        for (const double h : {1 / 60., 1 / 240.})
            for (const double heading : {0., 0.6}) {
                CAPTURE(share, h, heading);
                const double Omega = share * critical;
                RigidBody block = body_of(Box{{0.2, 0.05, 0.2}}, {r, 0.025, 0}, {0, mu},
                                          turn({0, 1, 0}, heading));
                block.state.velocity = Vector3d(0, Omega, 0).cross(block.state.position);
                spin(block, {0, Omega, 0});
                World world =
                    solved({driven(table, {0, mu}, under, turning({0, Omega, 0})), block});
                run(world, static_cast<int>(std::lround(5 / h)), h);
                const Vector3d& X = world.bodies[1].state.position;
                const double distance = std::hypot(X.x(), X.z());
                if (share < 1)
                    check_at_most(std::abs(distance - r), 0.01 * r, "creep in five seconds [m]");
                else
                    check_at_least(distance, 2 * r, "distance [m]");
            }
}

TEST_CASE("classics: a parcel on a conveyor slides until it is as fast as the belt", "[classics]")
{
    for (const double mu : {0.1, 0.5})
        for (const double v : {0.5, 3.})
            for (const double h : {0.02, 0.005})
                for (const ContactMethod method :
                     {ContactMethod::built_in, ContactMethod::simultaneous,
                      ContactMethod::one_at_a_time, ContactMethod::shock_propagation}) {
                    CAPTURE(mu, v, h, static_cast<int>(method));
                    Drive belt = moving({v, 0, 0});
                    belt.is_belt = true;
                    RigidBody parcel = body_of(Box{{0.3, 0.02, 0.3}}, {0, 0.01, 0}, {0, mu});
                    World world = solved({driven(table, {0, mu}, under, belt), parcel});
                    world.settings.contact_method = method;
                    const double T = 3;
                    run(world, static_cast<int>(std::lround(T / h)), h);
                    const double slides = v / (mu * g);
                    const double x = slides < T ? v * T - v * slides / 2 : mu * g * T * T / 2;
                    const RigidState& s = world.bodies[1].state;
                    CHECK_THAT(s.velocity.x(), IsClose(std::min(v, mu * g * T), Order(1e-3 * v)));
                    CHECK_THAT(s.position.x(), IsClose(x, Order(2 * v * h)));
                    CHECK(world.bodies[0].state.position == under);
                    CHECK_FALSE(world.bodies[1].rest.is_asleep());
                }
}

TEST_CASE("classics: a stack rides on a conveyor as one", "[classics]")
{
    const double v = 1, mu = 0.3;
    for (const int boxes : {2, 5})
        for (const double ratio : {1., 10.}) // mass of every second box over the others'
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(boxes, ratio, h);
                Drive belt = moving({v, 0, 0});
                belt.is_belt = true;
                std::vector<RigidBody> bodies = {driven(table, {0, mu}, under, belt)};
                for (int i = 0; i < boxes; ++i) {
                    bodies.push_back(
                        body_of(Box{{0.4, 0.1, 0.4}}, {0, 0.1 * (i + 0.5), 0}, {0, mu}));
                    if (i % 2 == 1)
                        set_mass(bodies.back(), ratio * bodies.back().mass,
                                 ratio * bodies.back().inertia);
                }
                World world = solved(bodies);
                run(world, static_cast<int>(std::lround(2 / h)), h);
                for (int i = 1; i <= boxes; ++i) {
                    const RigidState& s = world.bodies[i].state;
                    CHECK_THAT(s.velocity.x(), IsClose(v, Order(1e-3 * v)));
                    CHECK_THAT(s.position.y(), IsClose(0.1 * (i - 0.5), Order(1e-4)));
                    CHECK_THAT(s.position.x(),
                               IsClose(v * 2 - v * v / (2 * mu * g), Order(2 * v * h)));
                }
            }
}

// In a lift or a train of even speed everything is as on the ground (Galilei 1632, "Dialogo").
TEST_CASE("classics: a stack of heavy on light stands in a lift and in a train", "[classics]")
{
    for (const Vector3d& velocity : {Vector3d(0, 1, 0), Vector3d(0, -3, 0), Vector3d(20, 0, 0)})
        for (const double ratio : {1., 100.})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(velocity, ratio, h);
                std::vector<RigidBody> bodies = {driven(table, {0, 0.3}, under, moving(velocity))};
                for (int i = 0; i < 5; ++i) {
                    RigidBody box =
                        body_of(Box{{0.4, 0.1, 0.4}}, {0, 0.1 * (i + 0.5), 0}, {0, 0.3});
                    if (i % 2 == 1) set_mass(box, ratio * box.mass, ratio * box.inertia);
                    box.state.velocity = velocity;
                    bodies.push_back(box);
                }
                World world = solved(bodies);
                run(world, static_cast<int>(std::lround(1 / h)), h);
                for (int i = 1; i <= 5; ++i) {
                    const RigidState& s = world.bodies[i].state;
                    const Vector3d place =
                        world.bodies[0].state.position + Vector3d(0, 0.5 + 0.1 * (i - 0.5), 0);
                    CHECK_THAT(s.position, IsClose(place, Order(1e-9)));
                }
            }
}

TEST_CASE("classics: what lies on a shaken table leaves it if it is shaken harder than gravity",
          "[classics]")
{
    const double f = 4, w = 2 * pi * f;
    for (const double share : {0.5, 0.95, 1.1, 2.})
        for (const double h : {1 / 120., 1 / 480.}) {
            CAPTURE(share, h);
            const double A = share * g / (w * w);
            RigidBody block = body_of(Box{{0.2, 0.2, 0.2}}, {0, 0.1, 0}, {0, 0.5});
            block.state.velocity = {0, A * w, 0};
            World world = solved({driven(table, {0, 0.5}, under, shaking({0, A, 0}, f)), block});
            double gap = 0, sinks = 0;
            for (int i = 0; i * h < 3; ++i) {
                step(world, h);
                const double apart =
                    world.bodies[1].state.position.y() - world.bodies[0].state.position.y() - 0.6;
                gap = std::max(gap, apart);
                sinks = std::max(sinks, -apart);
            }
            check_at_most(sinks, 1e-4, "sinking [m]");
            if (share < 1)
                check_at_most(gap, g * h * h, "gap [m]");
            else
                check_at_least(gap, 2e-4, "gap [m]");
        }
}

// A table that moves to and fro takes a ball along by 2/7 of the table's way, and a hoop by 1/2, by
// the law of the moment of momentum about the point of contact.
TEST_CASE("classics: a table that is shaken rolls a ball along by two sevenths", "[classics]")
{
    const double A = 0.2, f = 0.5, w = 2 * pi * f;
    for (const double radius : {0.05, 0.3}) {
        std::vector<double> errors;
        for (const int steps : {200, 400, 800}) {
            RigidBody ball = body_of(Sphere{radius}, {0, radius, 0}, {0, 100});
            const double v = A * w; // speed of the table at first
            ball.state.velocity = {2. / 7 * v, 0, 0};
            spin(ball, {0, 0, 5. / 7 * v / radius});
            World world = solved({driven(table, {0, 100}, under, shaking({A, 0, 0}, f)), ball});
            double off = 0;
            const double h = 4. / steps;
            for (int i = 1; i <= steps; ++i) {
                step(world, h);
                off = std::max(off, std::abs(world.bodies[1].state.position.x() -
                                             2. / 7 * A * std::sin(w * i * h)));
            }
            errors.push_back(off);
        }
        CAPTURE(radius, errors);
        CHECK(errors[1] < 0.3 * errors[0]);
        check_at_most(errors.back(), 1e-4, "error of the place [m]");
    }
}

// A table that waits, moves and waits again takes along what sleeps on it: with a at most μ g the
// block is as fast as the table after v/(μ g), and slides as far after the stop. The times at
// which these two slides begin are known only to one step.
TEST_CASE("classics: what sleeps on a table wakes when the table sets out", "[classics]")
{
    const double v = 0.5, mu = 0.3, starts = 2, stops = 4;
    for (const double h : {1 / 60., 1 / 240.}) {
        CAPTURE(h);
        Drive drive = moving({v, 0, 0});
        drive.start = starts;
        drive.end = stops;
        RigidBody block = body_of(Box{{0.2, 0.1, 0.2}}, {0, 0.05, 0}, {0, mu});
        World world = solved({driven(table, {0, mu}, under, drive), block});
        run(world, static_cast<int>(std::lround(1.5 / h)), h);
        CHECK(world.bodies[1].rest.is_asleep());
        run(world, static_cast<int>(std::lround(1.5 / h)), h);
        CHECK_FALSE(world.bodies[1].rest.is_asleep());
        CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(v, Order(1e-6)));
        run(world, static_cast<int>(std::lround(3 / h)), h);
        CHECK_THAT(world.bodies[1].state.position.x(),
                   IsClose(v * (stops - starts), Order(2 * v * h)));
        CHECK(world.bodies[1].rest.is_asleep());
    }
}

TEST_CASE("classics: a belt that sets out takes along what lies on it", "[classics]")
{
    const double v = 0.5, mu = 0.3, starts = 2, stops = 4;
    for (const double h : {1 / 60., 1 / 240.}) {
        CAPTURE(h);
        Drive drive = moving({v, 0, 0});
        drive.is_belt = true;
        drive.start = starts;
        drive.end = stops;
        RigidBody block = body_of(Box{{0.2, 0.1, 0.2}}, {0, 0.05, 0}, {0, mu});
        World world = solved({driven(table, {0, mu}, under, drive), block});
        run(world, static_cast<int>(std::lround(3 / h)), h);
        CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(v, Order(1e-6)));
        run(world, static_cast<int>(std::lround(3 / h)), h);
        // The block slides until it is as fast as the belt, and again until it rests.
        CHECK_THAT(world.bodies[1].state.position.x(),
                   IsClose(v * (stops - starts), Order(2 * v * h)));
        CHECK(world.bodies[1].rest.is_asleep());
    }
}

TEST_CASE("classics: a paddle that comes adds twice its speed to a ball", "[classics]")
{
    for (const double u : {-1., 0.5, 4.})
        for (const double restitution : {1., 0.5})
            for (const double h : {0.01, 0.003}) {
                CAPTURE(u, restitution, h);
                const Material material{restitution, 0};
                RigidBody ball = body_of(Sphere{0.1}, {2, 0, 0}, material);
                ball.state.velocity = {-2, 0, 0};
                World world = solved(
                    {driven(Box{{0.2, 2, 2}}, material, {-1, 0, 0}, moving({u, 0, 0})), ball},
                    {0, 0, 0});
                const double meets = 2.8 / (2 + u); // they are 3 m - 0.1 m - 0.1 m apart
                const double T = meets + 0.3;
                const int steps = static_cast<int>(std::lround(T / h));
                run(world, steps, h);
                const double v = u + restitution * (2 + u);
                const double x = 2 - 2 * meets + v * (steps * h - meets);
                CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(v, Rounding(1e5, 10)));
                CHECK_THAT(world.bodies[1].state.position.x(), IsClose(x, Order(1e-8)));
            }
}

// A mass on a spring whose other end is moved by A sin(Ω t): x'' = ω² (A sin Ω t - x).
TEST_CASE("classics: a spring with a driven end forces its body", "[classics]")
{
    const double A = 0.1, mass = 12;
    for (const double share : {0.5, 0.9, 2.}) {
        const double W = 2 * pi, w = W / share, k = mass * w * w;
        std::vector<double> errors;
        for (const int steps : {300, 600, 1200}) {
            World world = solved(
                {driven(Sphere{0.01}, {}, {0, 0, 0}, shaking({A, 0, 0}, W / (2 * pi))), free_box()},
                {0, 0, 0});
            world.bodies[1].state.position = {1, 0, 0};
            world.springs.push_back({0, 1, {0, 0, 0}, {0, 0, 0}, k, 0, 1});
            const double T = 3;
            run(world, steps, T / steps);
            const double c = A * w * w / (w * w - W * W);
            const double x = c * (std::sin(W * T) - share * std::sin(w * T));
            errors.push_back(std::abs(world.bodies[1].state.position.x() - 1 - x));
        }
        CAPTURE(share, errors);
        check_order(errors, 4);
    }
}

// A ball that falls on a shaken plate: the plate has the height y(t), and the velocity of the ball
// becomes y' + ε (y' - V) at the moment of the impact, whatever the step is.
TEST_CASE("classics: a shaken plate hits with its velocity at the impact", "[classics]")
{
    const double r = 0.05, A = 0.02, f = 3, epsilon = 0.8, w = 2 * pi * f;
    for (const double phase : {0., 1., 2.5, 4.})
        for (const double H : {0.1, 0.35}) {
            const auto plate = [&](double t) {
                return A * (std::sin(w * t + phase) - std::sin(phase));
            };
            double low = 0, high = 1; // the time of the impact is between them
            while (high - low > 1e-15) {
                const double middle = (low + high) / 2;
                (H - g * middle * middle / 2 > plate(middle) ? low : high) = middle;
            }
            const double hit = low, speed = A * w * std::cos(w * hit + phase),
                         V = speed + epsilon * (speed + g * hit);
            const double T = hit + 0.05, t = T - hit;
            for (const int steps : {20, 33, 80}) {
                CAPTURE(phase, H, steps);
                const Material material{epsilon, 0};
                World world = solved({driven(table, material, under, shaking({0, A, 0}, f, phase)),
                                      body_of(Sphere{r}, {0, r + H, 0}, material)});
                run(world, steps, T / steps);
                const RigidState& ball = world.bodies[1].state;
                CHECK_THAT(ball.velocity.y(), IsClose(V - g * t, Order(1e-9)));
                CHECK_THAT(ball.position.y(),
                           IsClose(r + plate(hit) + V * t - g * t * t / 2, Order(1e-9)));
            }
        }
}

} // namespace driven_bodies
