// SPDX-License-Identifier: MIT
// A block lies on a table that is shaken sideways as A sin(w t), or on the ground while the force
// M A w² sin(w t) acts on it (den Hartog 1931, "Forced vibrations with combined Coulomb and viscous
// friction"). While it slides, friction changes its velocity by -μ g per second against the
// sliding, so its path is a sequence of parabolas. Each lasts until the block is as fast as what it
// lies on. There it sticks, or sliding turns round within the step.
#include "classics/problems.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace sliding_turns_round {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double f = 3, w = 2 * pi * f, mu = 0.3, T = 1.5;

// The place of the block and its velocity.
struct Motion {
    double x = 0, v = 0; // [m], [m/s]
    bool stuck = false;  // whether the block has stuck before
};

// The first time in (from, T] at which `holds`, by steps and bisection; T if it never does.
double first_time(double from, const std::function<bool(double)>& holds)
{
    constexpr double step = 1e-4;
    double t = from + step;
    while (t < T && !holds(t))
        t += step;
    if (t >= T) return T;
    double low = t - step;
    for (int i = 0; i < 50; ++i)
        (holds(0.5 * (low + t)) ? t : low) = 0.5 * (low + t);
    return t;
}

// The motion under the forces A w² sin(w t) and friction, per mass, of a block that starts with the
// velocity v.
Motion exact(double A, double v)
{
    const auto force = [&](double t) { return A * w * w * std::sin(w * t); };
    const auto after = [&](const Motion& m, double from, double t, double friction) {
        const double s = t - from, C = m.v + A * w * std::cos(w * from);
        return Motion{m.x + C * s - A * (std::sin(w * t) - std::sin(w * from)) +
                          friction * s * s / 2,
                      C - A * w * std::cos(w * t) + friction * s, m.stuck};
    };
    Motion motion{0, v};
    double t = 0;
    while (t < T) {
        if (motion.v == 0 && std::abs(force(t)) <= mu * g) {
            t = first_time(t, [&](double s) { return std::abs(force(s)) > mu * g; });
            motion.stuck = true;
        }
        if (t >= T) break;
        const double side = motion.v != 0 ? motion.v : force(t), d = side > 0 ? 1 : -1;
        const double stops =
            first_time(t, [&](double s) { return d * after(motion, t, s, -d * mu * g).v < 0; });
        motion = after(motion, t, stops, -d * mu * g);
        if (stops < T) motion.v = 0;
        t = stops;
    }
    return motion;
}

RigidBody block(const Vector3d& size, const Vector3d& e)
{
    return body_of(Box{size}, {0, 0.5 * size.y(), 0}, {0, mu},
                   turn({0, 1, 0}, std::atan2(-e.z(), e.x())));
}

// The place of body 0 along the unit vector e at the time T.
double place(World world, const Vector3d& e, int steps)
{
    run(world, steps, T / steps);
    return world.bodies[0].state.position.dot(e);
}

void check_place(const World& world, const Vector3d& e, double A, double x, bool stuck)
{
    for (const int steps : {75, 150, 300, 611}) {
        CAPTURE(steps);
        const double h = T / steps, j = A * w * w * w; // bounds the change of the force
        // A block that starts from rest may start a step too late. Then its velocity lacks j h²/2
        // at most, until it stops again after half a period. If sliding ends within a thousandth of
        // a step from its start or end, this is not seen: then the velocity is wrong by at most
        // 2 μ g h/1000, also for half a period, and this may happen twice in each period. Any other
        // end of sliding is predicted as if the force were constant, and corrected once.
        const double unseen = T * 2 * mu * g * h / 1000;
        const double allowed = unseen + j * h * h * (stuck ? 1 / (4 * f) : 0.008);
        check_at_most(std::abs(place(world, e, steps) - x), allowed, "error of the place [m]");
    }
}

} // namespace

TEST_CASE("classics: a block on a table that is shaken sideways slides to and fro", "[classics]")
{
    for (const Vector3d& size :
         {Vector3d(0.2, 0.04, 0.2), Vector3d(2, 0.3, 1), Vector3d(0.02, 0.004, 0.03)})
        for (const Vector3d& e : {Vector3d(1, 0, 0), Vector3d(0.6, 0, -0.8)})
            for (const double A : {0.01, 0.02, 0.03, 0.05, 0.2}) {
                CAPTURE(size, e, A);
                const Motion motion = exact(A, -A * w); // as seen from the table
                CHECK(motion.stuck == (A < 0.015));
                check_place(solved({block(size, e), driven(Box{{9, 0.2, 9}}, {0, mu}, {0, -0.1, 0},
                                                           shaking(A * e, f))}),
                            e, A, motion.x + A * std::sin(w * T), motion.stuck);
            }
}

TEST_CASE("classics: a force that swings pushes a block to and fro", "[classics]")
{
    const Vector3d e(0.6, 0, -0.8);
    for (const Vector3d& size : {Vector3d(0.2, 0.04, 0.2), Vector3d(2, 0.3, 1)})
        for (const double A : {0.02, 0.03, 0.05}) { // harder pushes tip it
            CAPTURE(size, A);
            World world = solved({block(size, e), fixed(Box{{9, 0.2, 9}}, {0, mu}, {0, -0.1, 0})});
            world.bodies[0].state.velocity = A * w * e;
            AppliedForce push;
            push.force = world.bodies[0].mass * A * w * w * e;
            push.frequency = f;
            world.forces = {push};
            const Motion motion = exact(A, A * w);
            check_place(world, e, A, motion.x, motion.stuck);
        }
}

} // namespace sliding_turns_round
