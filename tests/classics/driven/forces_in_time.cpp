// SPDX-License-Identifier: MIT
// Forces and torques that turn with a body or change with time, and ropes, which only pull. Each
// motion has a closed form.
#include "classics/problems.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

// A world with one force on its last body.
World with_force(std::vector<RigidBody> bodies, AppliedForce force, const Vector3d& gravity)
{
    World world = world_of(std::move(bodies), gravity);
    world.settings.formulas_are_reference = true;
    force.body = static_cast<int>(world.bodies.size()) - 1;
    world.forces = {force};
    return world;
}

} // namespace

// A rocket that spins while it burns goes round in a circle: V̇ = F/M (cos ω t, sin ω t).
TEST_CASE("classics: a rocket that spins flies in a circle", "[classics]")
{
    const double F = 30, M = 12, w = 2.5, T = 2;
    for (const Integrator integrator : {Integrator::runge_kutta, Integrator::matrix}) {
        std::vector<double> errors;
        for (const int steps : {20, 40, 80}) {
            AppliedForce thrust;
            thrust.force = {F, 0, 0};
            thrust.turns_with_body = true;
            World world = with_force({free_box({0, 0, w})}, thrust, {0, 0, 0});
            world.settings.integrator = integrator;
            run(world, steps, T / steps);
            const Vector3d V = F / (M * w) * Vector3d(std::sin(w * T), 1 - std::cos(w * T), 0);
            const Vector3d X =
                F / (M * w * w) * Vector3d(1 - std::cos(w * T), w * T - std::sin(w * T), 0);
            errors.push_back((world.bodies[0].state.velocity - V).norm() +
                             (world.bodies[0].state.position - X).norm());
        }
        CAPTURE(static_cast<int>(integrator), errors);
        check_order(errors, 4);
    }
}

// M ẍ = F sin(2π f t + φ) from rest.
TEST_CASE("classics: a force that swings gives the integral of its sine", "[classics]")
{
    const double F = 30, M = 12, f = 0.7, T = 2;
    for (const double phase : {0., 1., 4.}) {
        std::vector<double> errors;
        for (const int steps : {20, 40, 80}) {
            AppliedForce force;
            force.force = {F, 0, 0};
            force.frequency = f;
            force.phase = phase;
            World world = with_force({free_box()}, force, {0, 0, 0});
            run(world, steps, T / steps);
            const double w = 2 * pi * f;
            const double V = F / (M * w) * (std::cos(phase) - std::cos(w * T + phase));
            const double X = F / (M * w) * std::cos(phase) * T -
                             F / (M * w * w) * (std::sin(w * T + phase) - std::sin(phase));
            const RigidState& s = world.bodies[0].state;
            errors.push_back(std::abs(s.velocity.x() - V) + std::abs(s.position.x() - X));
        }
        CAPTURE(phase, errors);
        check_order(errors, 4);
    }
}

TEST_CASE("classics: a fast force is resolved whatever the step", "[classics]")
{
    const double F = 30, M = 12, f = 40, w = 2 * pi * f, h = 0.05;
    AppliedForce force;
    force.force = {F, 0, 0};
    force.frequency = f;
    World world = with_force({free_box()}, force, {0, 0, 0});
    run(world, 41, h);
    const double t = 41 * h;
    CHECK_THAT(world.bodies[0].state.velocity.x(),
               IsClose(F / (M * w) * (1 - std::cos(w * t)), Order(1e-3 * F / (M * w))));
}

// A spool that is pulled by a thread off its axle, Timoshenko and Young (1948, "Advanced
// dynamics"): with F at the height r below the axle and I = k M R², it rolls by
// M (1 + k) a = F (1 - r/R), towards the pull however the thread tries to unwind it.
TEST_CASE("classics: a spool rolls towards the hand that pulls its thread", "[classics]")
{
    const double R = 0.3, F = 20, T = 1;
    for (const double share : {-0.8, 0., 0.5, 0.9})
        for (const double h : {0.02, 0.005}) {
            CAPTURE(share, h);
            RigidBody spool = body_of(Cylinder{R, 0.4}, {0, R, 0}, {0, 2}, turn({1, 0, 0}, pi / 2));
            AppliedForce pull;
            pull.force = {F, 0, 0};
            pull.torque = {0, 0, F * share * R}; // the force acts so far below the axle
            World world = with_force({fixed(Plane{}, {0, 2}), spool}, pull, {0, -g, 0});
            run(world, static_cast<int>(std::lround(T / h)), h);
            const double a = F * (1 - share) / (1.5 * spool.mass);
            CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(a * T, Order(1e-6)));
            CHECK_THAT(world.bodies[1].state.position.x(), IsClose(a * T * T / 2, Order(1e-6)));
        }
}

// A torque about a principal axis speeds the body up evenly, and one that turns with the body keeps
// doing so whatever its orientation.
TEST_CASE("classics: a torque that turns with a body spins it up evenly", "[classics]")
{
    for (const bool turns_with_body : {true, false})
        for (int axis = 0; axis < 3; ++axis) {
            CAPTURE(turns_with_body, axis);
            AppliedForce torque;
            torque.torque[axis] = 26;
            torque.turns_with_body = turns_with_body;
            RigidBody box = free_box();
            const Quaternion q = turns_with_body ? turn({1, 2, -1}, 0.8) : Quaternion();
            box.state.orientation = q;
            World world = with_force({box}, torque, {0, 0, 0});
            run(world, 50, 0.02);
            const Vector3d w = 26 / free_moments[axis] * Vector3d::Unit(axis);
            CHECK_THAT(angular_velocity(world.bodies[0]),
                       IsClose(Vector3d(rotation_matrix(q) * w), Order(1e-9)));
        }
}

// A body on a rope falls freely until the rope is tight, and then swings on it as on a spring:
// y = l + g/ω² (1 - cos ω t) + v/ω sin ω t below the hook.
TEST_CASE("classics: a rope is slack until it is tight", "[classics]")
{
    const double l = 1, k = 3000, M = 12, w = std::sqrt(k / M);
    const double v = std::sqrt(2 * g * l), falls = v / g;
    std::vector<double> errors;
    for (const int steps : {400, 800, 1600}) {
        World world = world_of({free_box()});
        Spring rope{0, -1, {0, 0, 0}, {0, 0, 0}, k, 0, l};
        rope.only_pulls = true;
        world.springs = {rope};
        const double T = falls + 0.15;
        run(world, steps, T / steps);
        const double y = l + g / (w * w) * (1 - std::cos(w * 0.15)) + v / w * std::sin(w * 0.15);
        errors.push_back(std::abs(world.bodies[0].state.position.y() + y));
    }
    CAPTURE(errors);
    check_at_most(errors.back(), 1e-5, "error of the place [m]");
    CHECK(errors.back() < errors.front());

    World thrown = world_of({free_box()}, {0, 0, 0}); // inside the rope's length nothing pulls
    Spring rope{0, -1, {0, 0, 0}, {0, 0, 0}, k, 5, l};
    rope.only_pulls = true;
    thrown.springs = {rope};
    thrown.bodies[0].state.velocity = {0.5, 0, 0};
    run(thrown, 100, 0.01);
    CHECK_THAT(thrown.bodies[0].state.velocity.x(), IsClose(0.5, Rounding(100, 1)));
}
