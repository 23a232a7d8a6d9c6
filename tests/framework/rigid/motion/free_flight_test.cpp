// SPDX-License-Identifier: MIT
#include "framework/rigid/integrators.hpp"
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"
#include "support/free_rotor.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

double attitude_error(Integrator integrator, const Vector3d& omega, double end, int steps)
{
    World world = world_of({free_box(omega)}, {0, 0, 0});
    world.settings.integrator = integrator;
    run(world, steps, end / steps);
    return rotation_angle(eigen(world.bodies[0].state.orientation),
                          FreeRotor(free_moments, omega).orientation(end));
}

} // namespace

TEST_CASE("flight: the exact rotor agrees with its known values", "[rigid]")
{
    const FreeRotor rotor(free_moments, {1, 2, 3});
    CHECK_THAT(rotor.period(), IsClose(3.67184730265235, Rounding(64)));
    CHECK_THAT(
        rotor.body_angular_velocity(10),
        IsClose(Vector3d(-1.441479761782112, 1.32591216920842, 3.268251472830505), Rounding(64)));
    CHECK(rotation_angle(rotor.orientation(10),
                         Eigen::Quaterniond(-0.7167345284363959, 0.02657340199601567,
                                            0.01350657848027917, 0.6967087213399667)) < 1e-13);
    const FreeRotor racket(free_moments, {0.1, 2, 0.1});
    CHECK_THAT(
        racket.body_angular_velocity(10),
        IsClose(Vector3d(0.164146942774017, -1.99116951183221, -0.190874255368313), Rounding(256)));
}

TEST_CASE("flight: every integrator has its order", "[rigid]")
{
    const auto errors = [](Integrator integrator, std::vector<int> steps) {
        std::vector<double> all;
        for (int n : steps)
            all.push_back(attitude_error(integrator, {1, 2, 3}, 10, n));
        return all;
    };
    check_order(errors(Integrator::linear, {25600, 51200, 102400}), 1);
    check_order(errors(Integrator::exponential, {25600, 51200, 102400}), 1);
    check_order(errors(Integrator::buss, {1600, 3200, 6400}), 2);
    check_order(errors(Integrator::runge_kutta, {400, 800, 1600}), 4);
    check_order(errors(Integrator::matrix, {1600, 3200, 6400}), 4);
}

TEST_CASE("flight: the method of fourth order beats the errors of its rivals", "[rigid]")
{
    CHECK(attitude_error(Integrator::runge_kutta, {1, 2, 3}, 10, 100) < 3.1e-4);
    CHECK(attitude_error(Integrator::runge_kutta, {1, 2, 3}, 10, 400) < 9.1e-7);
    // The body flips over twice.
    CHECK(attitude_error(Integrator::runge_kutta, {0.1, 2, 0.1}, 20, 8000) < 1e-8);
}

TEST_CASE("flight: an isotropic body takes one exact step of any size", "[rigid]")
{
    for (const Integrator integrator :
         {Integrator::exponential, Integrator::buss, Integrator::runge_kutta, Integrator::exact}) {
        World world = world_of({body_of(Sphere{0.5}, {0, 0, 0})}, {0, 0, 0});
        world.settings.integrator = integrator;
        const Vector3d w(7, -11, 13);
        spin(world.bodies[0], w);
        step(world, 2);
        const Eigen::Quaterniond exact(Eigen::AngleAxisd(2 * w.norm(), w.normalized()));
        CHECK(rotation_angle(eigen(world.bodies[0].state.orientation), exact) < 1e-13);
        CHECK(world.counters.substeps == 0);
        CHECK(world.counters.isotropic_shortcuts == 1);
    }
}

TEST_CASE("flight: without the isotropic shortcut the motion is the same", "[rigid]")
{
    for (const Integrator integrator : all_integrators) {
        CAPTURE(static_cast<int>(integrator));
        World world = world_of({body_of(Box{{1, 1, 1}}, {0, 0, 0}, {}, turn({1, 2, 3}, 1))});
        world.settings.integrator = integrator;
        spin(world.bodies[0], {1, -2, 0.5});
        World without = world;
        without.bodies[0].is_isotropic = false;
        run(world, 50, 0.02);
        run(without, 50, 0.02);
        CHECK_THAT(without.bodies[0].state, IsClose(world.bodies[0].state, Rounding(5000)));
        CHECK(without.counters.isotropic_shortcuts == 0);
    }
}

TEST_CASE("flight: what is symmetric about an axis flies exactly in one step of any size",
          "[rigid]")
{
    for (const Shape& shape : {Shape(Cylinder{0.3, 1}), Shape(Box{{2, 1, 1}}), Shape(Cone{1, 0.5}),
                               Shape(Torus{1, 0.3})}) {
        CAPTURE(shape.index());
        World coarse = world_of({body_of(shape, {0, 0, 0}, {}, turn({1, 2, 3}, 1))});
        spin(coarse.bodies[0], {1, -2, 0.5});
        REQUIRE(coarse.bodies[0].is_body_of_revolution());
        World fine = coarse;
        fine.bodies[0].symmetry_axis.setZero();
        fine.settings.integrator = Integrator::runge_kutta; // it is of fourth order
        step(coarse, 2);
        run(fine, 20000, 1e-4);
        CHECK(coarse.counters.substeps == 0);
        CHECK(rotation_angle(eigen(coarse.bodies[0].state.orientation),
                             eigen(fine.bodies[0].state.orientation)) < 1e-11);
    }
    CHECK_FALSE(body_of(Box{{1, 2, 3}}, {0, 0, 0}).is_body_of_revolution());
    // A cube is isotropic and has no axis of symmetry.
    CHECK_FALSE(body_of(Box{{1, 1, 1}}, {0, 0, 0}).is_body_of_revolution());
}

TEST_CASE("flight: a rod that spins fast about itself keeps its energy", "[rigid]")
{
    RigidBody rod = body_of(Sphere{0.1}, {0, 0, 0});
    set_mass(rod, 12, Vector3d(1e6, 1e6, 1).asDiagonal().toDenseMatrix());
    World world = world_of({rod}, {0, 0, 0});
    spin(world.bodies[0], {1, 1, 1000});
    const double energy = totals(world).kinetic_energy;
    run(world, 1000, 1.0 / 60);
    // |L| is 1400 times the component of L along the axis, so a rounding error of q is 1400 times
    // as large in the spin.
    CHECK_THAT(totals(world).kinetic_energy, IsClose(energy, Rounding(1000, 1400 * energy)));
}

TEST_CASE("flight: the linear update turns by twice an arc tangent", "[rigid]")
{
    World world = world_of({body_of(Sphere{0.5}, {0, 0, 0})}, {0, 0, 0});
    world.settings.integrator = Integrator::linear;
    spin(world.bodies[0], {0, 0, 1});
    step(world, 0.1);
    const Quaternion& q = world.bodies[0].state.orientation;
    CHECK_THAT(2 * std::atan2(q.v.z(), q.s), IsClose(0.0999167914438855, Rounding(8)));
}

TEST_CASE("flight: a body that turns by ten radians a step takes seven substeps", "[rigid]")
{
    World world = world_of({free_box({0, 0, 10})}, {0, 0, 0});
    world.settings.integrator = Integrator::runge_kutta;
    step(world, 1);
    CHECK(world.counters.substeps == 7);
    step(world, 0.157); // slightly less than a quarter turn
    CHECK(world.counters.substeps == 7);
}

TEST_CASE("flight: free fall is a parabola to rounding", "[rigid]")
{
    const double h = 0.01;
    const int n = 200;
    for (const Integrator integrator :
         {Integrator::matrix, Integrator::buss, Integrator::runge_kutta, Integrator::exact}) {
        World world = world_of({body_of(Sphere{0.1}, {1, 2, 3})});
        world.settings.integrator = integrator;
        world.bodies[0].state.velocity = {4, 5, 6};
        run(world, n, h);
        const double t = n * h;
        CHECK_THAT(
            world.bodies[0].state.position,
            IsClose(Vector3d(1 + 4 * t, 2 + 5 * t - g * t * t / 2, 3 + 6 * t), Rounding(n, 30)));
    }
    for (const Integrator integrator : {Integrator::linear, Integrator::exponential}) {
        World world = world_of({body_of(Sphere{0.1}, {0, 0, 0})});
        world.settings.integrator = integrator;
        world.bodies[0].state.velocity = {0, 5, 0};
        run(world, n, h);
        CHECK_THAT(world.bodies[0].state.position.y(),
                   IsClose(n * h * 5 - g * h * h * n * (n + 1) / 2, Rounding(n, 30)));
    }
}

TEST_CASE("flight: the axis of a symmetric rotor precesses about its momentum at L over I",
          "[rigid]")
{
    RigidBody body;
    set_mass(body, 1, Vector3d(0.04, 0.02, 0.04).asDiagonal().toDenseMatrix());
    spin(body, {2, -4, 6});
    const Vector3d L = body.state.angular_momentum;
    World world = world_of({body}, {0, 0, 0});
    const double rate = L.norm() / 0.04, period = 2 * std::numbers::pi / rate;
    run(world, 2000, period / 2000);
    const Vector3d axis = rotation_matrix(world.bodies[0].state.orientation) * Vector3d::UnitY();
    CHECK_THAT(axis, IsClose(Vector3d(0, 1, 0), Order(1e-11)));
}
