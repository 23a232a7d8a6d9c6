// SPDX-License-Identifier: MIT
// A3: inputs that a special case easily swallows: exact half turns, steps back and steps of no
// time, angles beyond a whole turn, fast spins, bodies whose moments are equal or nearly so.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <numbers>

namespace rotation_special_inputs_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double times[] = {0, 0x1p-30, 0x1p-12, 0.01, 0.5, 3, 100};

// Orientations to start from: no turn with either sign, half a turn about z, and a random one.
std::vector<Quaternion> starts(Random& random)
{
    return {{1, {0, 0, 0}}, {-1, {0, 0, 0}}, {0, {0, 0, 1}}, random.quaternion()};
}

// Calls check(q, ω, Δt) for all these starts and times, also back in time.
template <class Check> void for_each_update(const Check& check)
{
    for (Random random : seeds(5))
        for (const Quaternion& q : starts(random))
            for (const double time : times)
                for (const double h : {time, -time}) {
                    CAPTURE(h);
                    check(q, random.uniform(1, 20) * random.unit_vector(), h);
                }
}

// Calls check(n) for axes along x, y and z, both ways, for all diagonals, and for others.
template <class Check> void for_each_axis(const Check& check)
{
    for (int k = 0; k < 27; ++k)
        if (k != 13) check(Vector3d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1).normalized());
    for (Random random : seeds(20))
        check(random.unit_vector());
}

// The matrix of half a turn about the axis n.
Matrix3d half_turn(const Vector3d& n)
{
    return 2 * n * n.transpose() - Matrix3d::Identity();
}

} // namespace

TEST_CASE("rotation: a half turn turns a vector", "[A3.8][rotation]")
{
    for_each_axis([](const Vector3d& n) {
        const Vector3d p(1, 2, 3);
        REQUIRE_THAT(rotate({0, n}, p), IsClose(Vector3d(half_turn(n) * p), Rounding(32, 8)));
    });
}

TEST_CASE("rotation: the matrix of a half turn", "[A3.9][rotation]")
{
    for_each_axis([](const Vector3d& n) {
        REQUIRE_THAT(to_matrix({0, n}), IsClose(half_turn(n), Rounding(64, 1)));
    });
}

namespace {

// Calls check(q, R) for turns by multiples of 30° about these axes, in which q has either sign.
template <class Check> void for_each_turn(const Check& check)
{
    for_each_axis([&](const Vector3d& n) {
        for (int step = -12; step <= 12; ++step) {
            const double half = step * std::numbers::pi / 12;
            Quaternion q{std::cos(half), std::sin(half) * n};
            if (step % 6 == 0) q.s = step % 12 == 0 ? q.s : 0; // exactly half a turn
            CAPTURE(step, n);
            check(q, Matrix3d(Eigen::AngleAxisd(2 * half, n)));
        }
    });
}

} // namespace

TEST_CASE("rotation: turns by multiples of 30° about every diagonal", "[A3.8][rotation]")
{
    for_each_turn([](const Quaternion& q, const Matrix3d& R) {
        const Vector3d p(1, 2, 3);
        REQUIRE_THAT(rotate(q, p), IsClose(Vector3d(R * p), Rounding(64, 8)));
    });
}

TEST_CASE("rotation: matrices of turns by multiples of 30° about every diagonal",
          "[A3.9][rotation]")
{
    for_each_turn([](const Quaternion& q, const Matrix3d& R) {
        REQUIRE_THAT(to_matrix(q), IsClose(R, Rounding(64, 1)));
    });
}

TEST_CASE("rotation: turns by multiples of 30° one after the other", "[A3.5][rotation]")
{
    std::vector<Quaternion> turns;
    for_each_turn([&](const Quaternion& q, const Matrix3d&) { turns.push_back(q); });
    for (Random random : seeds(10))
        for (const Quaternion& q : turns) {
            const Quaternion& p = turns[random.bits() % turns.size()];
            CAPTURE(p, q);
            REQUIRE_THAT(multiply(q, p), IsClose(plain(eigen(q) * eigen(p)), Rounding(16, 1)));
        }
}

TEST_CASE("rotation: the exact update turns by any angle, forth and back", "[A3.11][rotation]")
{
    for_each_update([](const Quaternion& q, const Vector3d& w, double h) {
        const double half = h * w.norm() / 2;
        const Quaternion turned{std::cos(half), std::sin(half) * w.normalized()};
        REQUIRE_THAT(advance_exact(q, w, h),
                     IsClose(plain(eigen(turned) * eigen(q)), Rounding(32, 1 + std::abs(half))));
    });
}

TEST_CASE("rotation: the linear update steps forth and back, and by no time", "[A3.12][rotation]")
{
    for_each_update([](const Quaternion& q, const Vector3d& w, double h) {
        const Eigen::Quaterniond sum = eigen({1, h / 2 * w}) * eigen(q);
        REQUIRE_THAT(
            advance_linear(q, w, h),
            IsClose(plain(Eigen::Quaterniond(sum.coeffs() / sum.norm())), Rounding(32, 1)));
    });
}

TEST_CASE("rotation: the matrix update grows with each turn", "[A3.1][rotation]")
{
    for (Random random : seeds(10))
        for (const double h : {0.5, 1.0, 10.0, -10.0}) {
            const Matrix3d R = random.rotation();
            const Vector3d w = 10 * random.unit_vector();
            Matrix3d change;
            for (int i = 0; i < 3; ++i)
                change.col(i) = h * w.cross(R.col(i));
            REQUIRE_THAT(advance_matrix(R, w, h), IsClose(Matrix3d(R + change), Rounding(16, 100)));
        }
}

TEST_CASE("rotation: Euler rates of angles beyond a whole turn", "[A3.4][rotation]")
{
    for (Random random : seeds(40)) {
        const Vector3d angles = 30 * random.vector(), w = 5 * random.vector();
        if (std::abs(std::cos(angles.y())) < 0.1) continue;
        const std::optional<Vector3d> rates = euler_rates(angles, w);
        check_that(rates.has_value(), "rates of the angles, since cos θ is not 0");
        const Eigen::Matrix3d yaw = Eigen::AngleAxisd(angles.z(), Vector3d::UnitZ()).matrix(),
                              pitch = Eigen::AngleAxisd(angles.y(), Vector3d::UnitY()).matrix();
        const Vector3d sum = rates->x() * (yaw * (pitch * Vector3d::UnitX())) +
                             rates->y() * (yaw * Vector3d::UnitY()) +
                             rates->z() * Vector3d::UnitZ();
        REQUIRE_THAT(sum, IsClose(w, Rounding(64, w.norm() + rates->lpNorm<1>())));
    }
}

namespace {

// A step of a body that is round about an axis: its moments are all equal, or that about this axis
// differs by little or by much.
StepCase step_of_round_body(Random& random, int axis, double difference, double speed)
{
    StepCase c = random_step(random);
    const Vector3d moments = random.mass() * (Vector3d::Ones() + difference * Vector3d::Unit(axis));
    c.body.inverse_inertia = moments.cwiseInverse().asDiagonal();
    const Vector3d w = speed * random.unit_vector();
    c.state.angular_momentum = world_inverse(c.body, c.state.orientation).inverse() * w;
    return c;
}

template <class Check> void for_round_bodies(Check check)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double difference : {0., 1e-6, 1e-3, 0.5})
            for (const double speed : {1., 60., 300.}) // [rad/s], up to 30 rad in a step
                check(axis, difference, speed);
}

} // namespace

TEST_CASE("rotation: symplectic Euler turns round and fast bodies", "[A3.15][rotation]")
{
    for (Random random : seeds(5))
        for_round_bodies([&](int axis, double difference, double speed) {
            CAPTURE(axis, difference, speed);
            StepCase c = step_of_round_body(random, axis, difference, speed);
            const double h = c.time_step;
            const Vector3d L = c.state.angular_momentum + h * c.wrench.torque;
            std::vector<Quaternion> orientations = starts(random);
            orientations.push_back(c.state.orientation);
            for (const Quaternion& q : orientations) {
                c.state.orientation = q;
                const Vector3d w = world_inverse(c.body, q) * L;
                const Eigen::Quaterniond sum = eigen({1, h / 2 * w}) * eigen(q);
                const RigidState next = step_symplectic_euler(c.state, c.body, c.wrench, h);
                REQUIRE_THAT(next.orientation,
                             IsClose(plain(Eigen::Quaterniond(sum.coeffs() / sum.norm())),
                                     Rounding(256, 1 + h * w.norm())));
            }
        });
}

TEST_CASE("rotation: Buss's step turns round and fast bodies", "[A3.16][rotation]")
{
    for (Random random : seeds(5))
        for_round_bodies([&](int axis, double difference, double speed) {
            CAPTURE(axis, difference, speed);
            const StepCase c = step_of_round_body(random, axis, difference, speed);
            const double h = c.time_step;
            const Matrix3d I_inv = world_inverse(c.body, c.state.orientation);
            const Vector3d& L = c.state.angular_momentum;
            const Vector3d w = I_inv * L, w_dot = I_inv * (c.wrench.torque - w.cross(L));
            const Vector3d by = h * (w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w));
            const double half = by.norm() / 2;
            const Quaternion turned{std::cos(half), std::sin(half) * by.normalized()};
            // the terms of ω × L cancel where the moments are nearly equal
            const double scale = 1 + h * w.norm() +
                                 h * h * (I_inv.norm() * w.norm() * L.norm()) * (1 + h * w.norm());
            REQUIRE_THAT(
                step_buss(c.state, c.body, c.wrench, h).orientation,
                IsClose(plain(eigen(turned) * eigen(c.state.orientation)), Rounding(256, scale)));
        });
}

namespace {

using Step = RigidState (*)(const RigidState&, const BodyInertia&, const Wrench&, double);

void check_no_time_and_static(Step step)
{
    for (Random random : seeds(10)) {
        StepCase c = random_step(random);
        const RigidState same = step(c.state, c.body, c.wrench, 0);
        REQUIRE_THAT(same.position, IsClose(c.state.position, Rounding(8, 1)));
        REQUIRE_THAT(same.orientation, IsClose(c.state.orientation, Rounding(16, 1)));
        REQUIRE_THAT(same.velocity, IsClose(c.state.velocity, Rounding(8, 1)));
        REQUIRE_THAT(
            same.angular_momentum,
            IsClose(c.state.angular_momentum, Rounding(8, 1 + c.state.angular_momentum.norm())));

        c.body.inverse_mass = 0; // static, whatever its inertia
        const RigidState still = step(c.state, c.body, c.wrench, c.time_step);
        REQUIRE_THAT(still.position, IsExactly(c.state.position));
        REQUIRE_THAT(still.orientation, IsExactly(c.state.orientation));
        REQUIRE_THAT(still.velocity, IsExactly(c.state.velocity));
        REQUIRE_THAT(still.angular_momentum, IsExactly(c.state.angular_momentum));
    }
}

} // namespace

TEST_CASE("rotation: symplectic Euler by no time, and of a static body", "[A3.15][rotation]")
{
    check_no_time_and_static(step_symplectic_euler);
}

TEST_CASE("rotation: Buss's step by no time, and of a static body", "[A3.16][rotation]")
{
    check_no_time_and_static(step_buss);
}

} // namespace rotation_special_inputs_test
