// SPDX-License-Identifier: MIT
#include "rigid/motion/runge_kutta.hpp"

#include "framework/rigid/worlds.hpp"
#include "support/free_rotor.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr auto no_update = [] {};

// A body after n steps without a wrench, or under one that does not change.
template <class Scheme>
RigidState after_steps(const RigidBody& body, const Wrench& wrench, double time, int n)
{
    BodyStages<Scheme> stages(body, Scheme::from(body.state), wrench);
    RigidState state = body.state;
    for (int i = 0; i < n; ++i) {
        runge_kutta_4<Scheme>({&stages, 1}, time / n, no_update);
        state = Scheme::to(stages.stage, state);
        stages.start = Scheme::from(state);
    }
    return state;
}

template <class Scheme> void check_order_of_free_rotor(std::vector<int> steps)
{
    const Vector3d omega(1, 2, 3);
    const RigidBody body = free_box(omega);
    std::vector<double> errors;
    for (const int n : steps)
        errors.push_back(rotation_angle(eigen(after_steps<Scheme>(body, {}, 10, n).orientation),
                                        FreeRotor(free_moments, omega).orientation(10)));
    check_order(errors, 4);
}

// The distance of a mass on a spring from its exact path X = cos ω t, with ω = 2.
template <class Scheme> double spring_error(int n)
{
    RigidBody body = free_box();
    body.state.position = {1, 0, 0};
    BodyStages<Scheme> stages(body, Scheme::from(body.state), {});
    for (int i = 0; i < n; ++i) {
        runge_kutta_4<Scheme>({&stages, 1}, 3.0 / n, [&] {
            stages.wrench.force = -4 * body.mass * stages.stage.position;
        });
        stages.start = stages.stage;
    }
    return std::abs(stages.start.position.x() - std::cos(6.0));
}

} // namespace

TEST_CASE("runge kutta: both schemes are of fourth order on a free rotor", "[rigid]")
{
    check_order_of_free_rotor<LieScheme>({400, 800, 1600});
    check_order_of_free_rotor<MatrixScheme>({1600, 3200, 6400});
}

TEST_CASE("runge kutta: both schemes are of fourth order where the force depends on the stage",
          "[rigid]")
{
    check_order(
        {spring_error<LieScheme>(30), spring_error<LieScheme>(60), spring_error<LieScheme>(120)},
        4);
    check_order({spring_error<MatrixScheme>(30), spring_error<MatrixScheme>(60),
                 spring_error<MatrixScheme>(120)},
                4);
}

TEST_CASE("runge kutta: a constant wrench gives an exact parabola and momentum", "[rigid]")
{
    RigidBody body = free_box({0.5, 0, 0});
    body.state.velocity = {1, 2, 3};
    const Wrench wrench{{12, 24, -12}, {1, -2, 3}};
    const Vector3d L = body.state.angular_momentum;
    const double h = 0.5;
    for (const RigidState& end : {after_steps<LieScheme>(body, wrench, h, 1),
                                  after_steps<MatrixScheme>(body, wrench, h, 1)}) {
        CHECK_THAT(end.position, IsClose(Vector3d(0.625, 1.25, 1.375), Rounding(16)));
        CHECK_THAT(end.velocity, IsClose(Vector3d(1.5, 3, 2.5), Rounding(8)));
        CHECK_THAT(end.angular_momentum, IsClose(Vector3d(L + h * wrench.torque), Rounding(8)));
    }
}

TEST_CASE("runge kutta: by the method of Munthe-Kaas a steady spin is exact", "[rigid]")
{
    RigidBody ball = body_of(Sphere{0.5}, {0, 0, 0});
    spin(ball, {2, -1, 2}); // 3 rad/s
    const RigidState end = after_steps<LieScheme>(ball, {}, 1.5, 1);
    CHECK(rotation_angle(eigen(end.orientation), eigen(turn({2, -1, 2}, 4.5))) < 1e-14);
    CHECK_THAT(end.orientation.s * end.orientation.s + end.orientation.v.squaredNorm(),
               IsClose(1.0, Rounding(8)));
}

TEST_CASE("runge kutta: of two quaternions the one nearer to the previous is taken", "[rigid]")
{
    for (Random random : seeds(20)) {
        RigidState state;
        state.orientation = random.quaternion();
        for (const double sign : {1.0, -1.0}) {
            state.orientation = {sign * state.orientation.s, sign * state.orientation.v};
            const RigidState back = MatrixScheme::to(MatrixScheme::from(state), state);
            CHECK_THAT(back.orientation, IsClose(state.orientation, Rounding(16)));
        }
    }
}

TEST_CASE("runge kutta: the nearest rotation is a rotation and a rotation its own", "[rigid]")
{
    for (Random random : seeds(20)) {
        const Matrix3d R = random.rotation();
        CHECK_THAT(MatrixScheme::nearest_rotation(R), IsClose(R, Rounding(32)));
        // A symmetric positive definite factor is taken away (polar decomposition).
        const Matrix3d A = R * random.positive_definite();
        CHECK_THAT(MatrixScheme::nearest_rotation(A), IsRotation());
        CHECK_THAT(MatrixScheme::nearest_rotation(A), IsClose(R, Rounding(64 * 100)));
        CHECK_THAT(MatrixScheme::nearest_rotation(-R), IsRotation());
    }
}

TEST_CASE("runge kutta: the formulas get a rotation at stages that have left the rotations",
          "[rigid]")
{
    for (Random random : seeds(20)) {
        RigidBody body = free_box();
        body.state.orientation = random.quaternion();
        spin(body, random.vector());
        const MatrixState on = MatrixScheme::from(body.state);
        MatrixState off = on;
        off.rotation = on.rotation * (Matrix3d::Identity() + 0.05 * random.positive_definite());
        const Wrench wrench{random.vector(), random.vector()};
        const MatrixStateRate rate = MatrixScheme::rate(body, off, wrench),
                              expected = MatrixScheme::rate(body, on, wrench);
        CHECK_THAT(rate.rotation_rate, IsClose(expected.rotation_rate, Rounding(100, 10)));
        CHECK_THAT(rate.position_rate, IsClose(expected.position_rate, Rounding(4)));
        CHECK_THAT(rate.velocity_rate, IsClose(expected.velocity_rate, Rounding(4)));
    }
}
