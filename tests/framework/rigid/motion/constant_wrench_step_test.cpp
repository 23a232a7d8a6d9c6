// SPDX-License-Identifier: MIT
#include "rigid/motion/constant_wrench_step.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/motion/runge_kutta.hpp"
#include "support/free_rotor.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

RigidState flown(const RigidBody& body, RigidState state, const Wrench& wrench, double time,
                 int steps)
{
    for (int i = 0; i < steps; ++i)
        state = constant_wrench_step(body, state, wrench, time / steps);
    return state;
}

// A cylinder of random size and density, in a random pose, that moves and rotates.
RigidBody random_cylinder(Random& random)
{
    RigidBody body = body_of(Cylinder{random.uniform(0.2, 0.5), random.uniform(0.5, 1)},
                             random.vector(), {}, random.quaternion());
    body.state.velocity = random.vector();
    spin(body, 3 * random.vector());
    return body;
}

double angle_between(const RigidState& a, const RigidState& b)
{
    return rotation_angle(eigen(a.orientation), eigen(b.orientation));
}

} // namespace

TEST_CASE("constant wrench: a step that takes no time leaves the state as it is", "[rigid]")
{
    for (Random random : seeds(10))
        for (const RigidBody& body : {free_box({1, 2, 3}), random_cylinder(random)}) {
            const Wrench wrench{random.vector(), random.vector()};
            CHECK_THAT(constant_wrench_step(body, body.state, wrench, 0), IsExactly(body.state));
        }
}

TEST_CASE("constant wrench: velocity and momentum and the parabola of the path are exact",
          "[rigid]")
{
    for (Random random : seeds(20)) {
        RigidBody body = random_cylinder(random);
        const Wrench wrench{100 * random.vector(), 100 * random.vector()};
        const double h = random.uniform(0.01, 0.5), M = body.mass;
        const RigidState& s = body.state;
        const RigidState next = constant_wrench_step(body, s, wrench, h);
        CHECK_THAT(next.position,
                   IsClose(Vector3d(s.position + h * s.velocity + h * h / 2 * wrench.force / M),
                           Rounding(16, 4)));
        CHECK_THAT(next.velocity,
                   IsClose(Vector3d(s.velocity + h * wrench.force / M), Rounding(16, 4)));
        CHECK_THAT(next.angular_momentum,
                   IsClose(Vector3d(s.angular_momentum + h * wrench.torque), Rounding(4)));
    }
}

TEST_CASE("constant wrench: a free rotor is of fourth order", "[rigid]")
{
    const Vector3d omega(1, 2, 3);
    const RigidBody body = free_box(omega);
    std::vector<double> errors;
    for (const int steps : {400, 800, 1600}) {
        const RigidState end = flown(body, body.state, {}, 10, steps);
        errors.push_back(
            rotation_angle(eigen(end.orientation), FreeRotor(free_moments, omega).orientation(10)));
    }
    check_order(errors, 4);
}

// The steps of Runge and Kutta on rotation matrices are another method, as good as exact when they
// are short.
TEST_CASE("constant wrench: under a torque the order stays four", "[rigid]")
{
    RigidBody top = free_box();
    set_mass(top, 12, Vector3d(13, 5, 5).asDiagonal().toDenseMatrix());
    spin(top, {1, 2, 3});
    REQUIRE(top.is_body_of_revolution());
    for (const RigidBody& body : {free_box({1, 2, 3}), top}) {
        CAPTURE(body.is_body_of_revolution());
        const Wrench wrench{{0, 0, 0}, {5, -8, 12}};
        BodyStages<MatrixScheme> exact(body, MatrixScheme::from(body.state), wrench);
        constexpr int short_steps = 20000;
        constexpr double end = 2; // [s]
        for (int i = 0; i < short_steps; ++i) {
            runge_kutta_4<MatrixScheme>({&exact, 1}, end / short_steps, [] {});
            exact.start = exact.stage;
        }
        const RigidState expected = MatrixScheme::to(exact.start, body.state);
        std::vector<double> errors;
        for (const int steps : {50, 100, 200})
            errors.push_back(angle_between(flown(body, body.state, wrench, end, steps), expected));
        check_order(errors, 4);
    }
}

TEST_CASE("constant wrench: an isotropic body turns exactly under a torque along its spin",
          "[rigid]")
{
    RigidBody ball = body_of(Sphere{0.5}, {0, 0, 0});
    const Vector3d axis = Vector3d(1, 2, -2) / 3;
    spin(ball, 2 * axis);
    const double I = ball.inertia(0, 0), h = 0.7, rate = 1.5; // [kg m²], [s], [rad/s²]
    const RigidState end = constant_wrench_step(ball, ball.state, {{0, 0, 0}, rate * I * axis}, h);
    const Eigen::Quaterniond exact(Eigen::AngleAxisd(2 * h + rate * h * h / 2, axis));
    CHECK(rotation_angle(eigen(end.orientation), exact) < 1e-14);
}

TEST_CASE("constant wrench: a free body of revolution takes one exact step of any size", "[rigid]")
{
    for (Random random : seeds(10)) {
        const RigidBody body = random_cylinder(random);
        REQUIRE(body.is_body_of_revolution());
        const double time = random.uniform(1, 3);
        const RigidState once = constant_wrench_step(body, body.state, {}, time);
        // Two parts of the time are the same motion.
        const RigidState twice = constant_wrench_step(
            body, constant_wrench_step(body, body.state, {}, time / 3), {}, 2 * time / 3);
        CHECK(angle_between(once, twice) < 1e-13);
        // The method of fourth order, which knows of no symmetry, comes to the same motion.
        RigidBody general = body;
        general.symmetry_axis.setZero();
        std::vector<double> errors;
        for (const int steps : {40, 80, 160})
            errors.push_back(angle_between(flown(general, body.state, {}, time, steps), once));
        check_order(errors, 4);
    }
}

TEST_CASE("constant wrench: a body at rest without a wrench stays at rest", "[rigid]")
{
    Random random(2);
    for (RigidBody body : {free_box(), random_cylinder(random)}) {
        body.state.velocity.setZero();
        body.state.angular_momentum.setZero();
        CHECK_THAT(constant_wrench_step(body, body.state, {}, 0.1), IsExactly(body.state));
    }
}
