// SPDX-License-Identifier: MIT
// A3: inputs whose parts have very different sizes: columns, components of ω near gimbal lock, slow
// bodies in long steps. Also columns that lie along the axes in every combination.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <limits>
#include <numbers>

namespace rotation_extremes_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

} // namespace

TEST_CASE("rotation: Gram-Schmidt of columns along the axes in every combination",
          "[A3.2][rotation]")
{
    std::vector<Vector3d> columns = {Vector3d::Zero(), {0.6, 0, -0.8}, {1, 2, 3}};
    for (int axis = 0; axis < 3; ++axis)
        for (const double size : {1.0, -2.0})
            columns.emplace_back(size * Vector3d::Unit(axis));
    for (const Vector3d& x : columns)
        for (const Vector3d& y : columns)
            for (const Vector3d& z : columns) {
                CAPTURE(x, y, z);
                const Matrix3d Q = gram_schmidt(matrix(x, y, z));
                REQUIRE_THAT(Q, IsRotation());
                if (x.isZero(0)) continue;
                REQUIRE_THAT(Vector3d(Q.col(0)), IsClose(x.normalized(), Rounding(64, 1)));
                const Vector3d rest = y - y.dot(x) / x.squaredNorm() * x;
                if (rest.norm() < 1e-9) continue;
                REQUIRE_THAT(Vector3d(Q.col(1)), IsClose(rest.normalized(), Rounding(256, 4)));
            }
}

TEST_CASE("rotation: in Gram-Schmidt the lengths of the columns do not matter", "[A3.2][rotation]")
{
    for (Random random : seeds(60)) {
        const Matrix3d R = matrix(Vector3d::UnitX() + 0.3 * random.vector(),
                                  Vector3d::UnitY() + 0.3 * random.vector(),
                                  Vector3d::UnitZ() + 0.3 * random.vector());
        Vector3d lengths;
        for (int i = 0; i < 3; ++i)
            lengths[i] = std::ldexp(1, random_index(random, 1001) - 500);
        CAPTURE(lengths);
        REQUIRE_THAT(gram_schmidt(R * lengths.asDiagonal()),
                     IsClose(gram_schmidt(R), Rounding(64, 4)));
    }
}

TEST_CASE("rotation: near gimbal lock every component of ω counts", "[A3.4][rotation]")
{
    // without yaw φ̇ = ω_x / cos θ, θ̇ = ω_y and ψ̇ = ω_z + φ̇ sin θ
    for (const double off : {1e-3, 1e-6, 1e-9, 2e-12})
        for (int power = 0; power <= 60; power += 3) {
            CAPTURE(off, power);
            const double theta = pi / 2 - off, small = std::ldexp(1, -power);
            const auto rates = euler_rates({0.3, theta, 0}, {small, 1, 0});
            check_that(rates.has_value(), "rates of the angles, since |cos θ| > 1e-12");
            const double roll = small / std::cos(theta);
            REQUIRE_THAT((*rates)[0], IsClose(roll, Rounding(16)));
            REQUIRE_THAT((*rates)[1], IsClose(1.0, Rounding(16)));
            REQUIRE_THAT((*rates)[2], IsClose(roll * std::sin(theta), Rounding(16)));
        }
}

TEST_CASE("rotation: gimbal lock is where the cosine is 0 after any number of turns",
          "[A3.4][rotation]")
{
    int locked = 0;
    for (int power = 0; power <= 40; ++power)
        for (const int quarters : {1, 3}) {
            const double theta = std::ldexp(1, power) * 2 * pi + quarters * pi / 2;
            const double cosine = std::abs(std::cos(theta));
            CAPTURE(power, quarters, cosine);
            if (std::abs(cosine - 1e-12) < 1e-14) continue; // rounding decides
            const auto rates = euler_rates({0.1, theta, 0.2}, {1, 2, 3});
            check_that(rates.has_value() == (cosine >= 1e-12), "rates only if |cos θ| >= 1e-12");
            locked += cosine < 1e-12 ? 1 : 0;
        }
    check_that(locked > 3, "some of these angles are locked");
}

TEST_CASE("rotation: the smallest vector part changes its sign in the conjugate",
          "[A3.6][rotation]")
{
    for (int power = 0; power <= 1000; power += 8) {
        CAPTURE(power);
        const Vector3d v = std::ldexp(1, -power) * Vector3d(1, -2, 3);
        REQUIRE_THAT(conjugate({4, v}), IsExactly(Quaternion{4, -v}));
    }
}

TEST_CASE("rotation: a slow body in a long step turns as a fast one in a short step",
          "[A3.11][rotation]")
{
    for (Random random : seeds(60)) {
        const Quaternion q = random.quaternion();
        const Vector3d axis = random.unit_vector();
        const double half = random.uniform(0.1, 6),
                     h = std::ldexp(1, random_index(random, 161) - 80);
        CAPTURE(half, h);
        const Quaternion turned{std::cos(half), std::sin(half) * axis};
        const Eigen::Quaterniond product =
            Eigen::Quaterniond(turned.s, turned.v.x(), turned.v.y(), turned.v.z()) *
            Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z());
        REQUIRE_THAT(advance_exact(q, 2 * half / h * axis, h),
                     IsClose(Quaternion{product.w(), product.vec()}, Rounding(64, 1 + half)));
    }
}

TEST_CASE("rotation: the slowest body turns in the longest step", "[A3.11][rotation]")
{
    // by 1 rad in all
    const Quaternion expected{std::cos(0.5), {0, 0, std::sin(0.5)}};
    for (int power = 0; power <= 700; power += 4) {
        CAPTURE(power);
        const double h = std::ldexp(1, power);
        REQUIRE_THAT(advance_exact({1, {0, 0, 0}}, {0, 0, 1 / h}, h),
                     IsClose(expected, Rounding(8, 1)));
    }
}

TEST_CASE("rotation: a long linear step makes a little less than a half turn", "[A3.12][rotation]")
{
    // (1, Δt/2 ω)/|…| has the real part 1/|…|
    for (int power = 20; power <= 44; ++power) {
        CAPTURE(power);
        const double half = std::ldexp(1, power);
        REQUIRE_THAT(advance_linear({1, {0, 0, 0}}, {0, 0, 2 * half}, 1).s,
                     IsClose(1 / std::hypot(1, half), Rounding(8, 1)));
    }
}

TEST_CASE("rotation: the longest linear step makes a half turn", "[A3.12][rotation]")
{
    // for a long step the normalized q + Δt/2 (0, ω) q becomes (0, ω/|ω|) q
    const Quaternion q{0.8, {0.36, 0.48, 0}};
    const Vector3d u(2. / 3, -1. / 3, 2. / 3);
    const Quaternion expected{-u.dot(q.v), q.s * u + u.cross(q.v)};
    for (int power = 48; power <= 400; power += 2) {
        CAPTURE(power);
        REQUIRE_THAT(advance_linear(q, u, std::ldexp(1, power)),
                     IsClose(expected, Order(std::ldexp(16, -power) + 0x1p-46)));
        REQUIRE_THAT(advance_linear(q, std::ldexp(1, power) * u, 1),
                     IsClose(expected, Order(std::ldexp(16, -power) + 0x1p-46)));
    }
}

TEST_CASE("rotation: the exact update turns by a million radians", "[A3.11][rotation]")
{
    for (int axis = 0; axis < 3; ++axis)
        for (int power = 0; power <= 30; ++power)
            for (const double sign : {1.0, -1.0}) {
                CAPTURE(axis, power, sign);
                const double half = std::ldexp(0.75, power);
                const Vector3d n = sign * Vector3d::Unit(axis);
                const Quaternion expected{std::cos(half), std::sin(half) * n};
                REQUIRE_THAT(advance_exact({1, {0, 0, 0}}, 3 * n, half / 1.5),
                             IsClose(expected, Rounding(4, 1 + half)));
            }
}

namespace {

// A body with the inverse moments 1, 1 + d and 1 - d about the axes i, i + 1 and i + 2, which turns
// about the latter two with L = a (0, 1, 1). Then ω = a (0, 1 + d, 1 - d), ω̇ = (-2 d a², 0, 0) and
// ω̇ × ω = 2 d a³ (0, 1 - d, -1 - d).
struct NearlyRound {
    int i;
    double a, d;

    Vector3d along(double first, double second, double third) const
    {
        Vector3d v;
        v[i] = first;
        v[(i + 1) % 3] = second;
        v[(i + 2) % 3] = third;
        return v;
    }
    RigidState state() const { return {{0, 0, 0}, {1, {0, 0, 0}}, {0, 0, 0}, along(0, a, a)}; }
    BodyInertia body() const { return {1, along(1, 1 + d, 1 - d).asDiagonal()}; }
    Vector3d omega() const { return along(0, a * (1 + d), a * (1 - d)); }
    Vector3d omega_dot() const { return along(-2 * d * a * a, 0, 0); }
};

template <class Check> void for_nearly_round(const Check& check)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int power = 4; power <= 44; power += 2)
            for (const double sign : {1.0, -1.0}) {
                CAPTURE(axis, power, sign);
                check(NearlyRound{axis, 2, sign * std::ldexp(1, -power)}, 0.5);
            }
}

} // namespace

TEST_CASE("rotation: symplectic Euler of a body that is nearly round", "[A3.15][rotation]")
{
    for_nearly_round([](const NearlyRound& top, double h) {
        const Vector3d turn = h / 2 * top.omega();
        const double length = std::sqrt(1 + turn.squaredNorm());
        const Quaternion expected{1 / length, turn / length};
        REQUIRE_THAT(step_symplectic_euler(top.state(), top.body(), {}, h).orientation,
                     IsClose(expected, Rounding(8, 1)));
    });
}

TEST_CASE("rotation: Buss's step of a body that is nearly round", "[A3.16][rotation]")
{
    for_nearly_round([](const NearlyRound& top, double h) {
        const Vector3d w = top.omega(), w_dot = top.omega_dot();
        const Vector3d half = h / 2 * (w + h / 2 * w_dot + h * h / 12 * w_dot.cross(w));
        const Quaternion expected{std::cos(half.norm()), std::sin(half.norm()) * half.normalized()};
        REQUIRE_THAT(step_buss(top.state(), top.body(), {}, h).orientation,
                     IsClose(expected, Rounding(8, 1)));
    });
}

} // namespace rotation_extremes_test
