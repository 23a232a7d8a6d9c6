// SPDX-License-Identifier: MIT
// A3.5 to A3.10: the algebra of quaternions.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/seeds.hpp"

namespace rotation_quaternion_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

const Vector3d e_x = Vector3d::UnitX(), e_y = Vector3d::UnitY(), e_z = Vector3d::UnitZ();
const double half_root = std::sqrt(0.5);

/// A random quaternion, in general not a unit one.
Quaternion any_quaternion(Random& random)
{
    const double s = random.uniform(-2, 2);
    return {s, 2 * random.vector()};
}

Quaternion times(double a, const Quaternion& q)
{
    return {a * q.s, a * q.v};
}

} // namespace

TEST_CASE("rotation: i² = j² = k² = -1", "[A3.5][rotation]")
{
    for (const Vector3d& e : {e_x, e_y, e_z})
        REQUIRE_THAT(multiply({0, e}, {0, e}), IsExactly(Quaternion{-1, {0, 0, 0}}));
}

TEST_CASE("rotation: ij = -ji = k and so on around", "[A3.5][rotation]")
{
    const Vector3d e[] = {e_x, e_y, e_z};
    for (int i = 0; i < 3; ++i) {
        const Vector3d &a = e[i], &b = e[(i + 1) % 3], &c = e[(i + 2) % 3];
        REQUIRE_THAT(multiply({0, a}, {0, b}), IsExactly(Quaternion{0, c}));
        REQUIRE_THAT(multiply({0, b}, {0, a}), IsExactly(Quaternion{0, -c}));
    }
}

TEST_CASE("rotation: the product of a quaternion with itself and its relatives", "[A3.5][rotation]")
{
    for (Random random : seeds(20))
        for (const double length : {0.5, 1.0, 3.0}) {
            const Quaternion q = {length * random.uniform(-1, 1), length * random.vector()};
            for (const double scalar : {1., -1.})
                for (const double vector : {1., -1.}) {
                    CAPTURE(length, scalar, vector);
                    const Quaternion p = {scalar * q.s, vector * q.v};
                    const Quaternion expected = {scalar * q.s * q.s - vector * q.v.squaredNorm(),
                                                 (vector + scalar) * q.s * q.v};
                    const double scale = q.s * q.s + q.v.squaredNorm();
                    REQUIRE_THAT(multiply(q, p), IsClose(expected, Rounding(16, scale)));
                }
        }
}

TEST_CASE("rotation: the product of any two quaternions", "[A3.5][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion a = any_quaternion(random), b = any_quaternion(random);
        const Quaternion ab = multiply(a, b);
        REQUIRE_THAT(ab, IsClose(plain(eigen(a) * eigen(b)), Rounding(64, length(a) * length(b))));
        REQUIRE_THAT(length(ab), IsClose(length(a) * length(b), Rounding(64)));
    }
}

TEST_CASE("rotation: the conjugate changes the sign of the vector part", "[A3.6][rotation]")
{
    REQUIRE_THAT(conjugate({1, {2, -3, 4}}), IsExactly(Quaternion{1, {-2, 3, -4}}));
    REQUIRE_THAT(conjugate({-5, {0, 0, 0}}), IsExactly(Quaternion{-5, {0, 0, 0}}));
    REQUIRE_THAT(conjugate({0, {0, 0, 0}}), IsExactly(Quaternion{0, {0, 0, 0}}));
}

TEST_CASE("rotation: q times its conjugate is |q|²", "[A3.6][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = any_quaternion(random);
        const double squared = eigen(q).squaredNorm();
        const Quaternion product = plain(eigen(q) * eigen(conjugate(q)));
        REQUIRE_THAT(product, IsClose(Quaternion{squared, {0, 0, 0}}, Rounding(16, squared)));
    }
}

TEST_CASE("rotation: normalized by hand", "[A3.7][rotation]")
{
    const Tolerance tolerance = Rounding(8, 1);
    REQUIRE_THAT(normalize({3, {0, 4, 0}}), IsClose(Quaternion{0.6, {0, 0.8, 0}}, tolerance));
    REQUIRE_THAT(normalize({1, {-1, 1, -1}}), IsClose(Quaternion{.5, {-.5, .5, -.5}}, tolerance));
}

TEST_CASE("rotation: a normalized quaternion is unit and keeps its sign", "[A3.7][rotation]")
{
    REQUIRE_THAT(normalize({-2, {0, 0, 0}}), IsClose(Quaternion{-1, {0, 0, 0}}, Rounding(32, 1)));
    for (Random random : seeds(100)) {
        const Quaternion q = any_quaternion(random);
        const Quaternion n = normalize(q);
        REQUIRE_THAT(length(n), IsClose(1.0, Rounding(32)));
        REQUIRE_THAT(times(length(q), n), IsClose(q, Rounding(64, length(q))));
    }
}

TEST_CASE("rotation: the zero quaternion becomes the identity", "[A3.7][rotation]")
{
    REQUIRE_THAT(normalize({0, {0, 0, 0}}), IsExactly(Quaternion{1, {0, 0, 0}}));
}

TEST_CASE("rotation: tiny and huge quaternions are normalized as well", "[A3.7][rotation]")
{
    const Quaternion unit = {0.5, {-0.5, 0.5, -0.5}};
    for (double scale : {1e-300, 1e-200, 1e-150, 1e150, 1e200, 1e300}) {
        CAPTURE(scale);
        REQUIRE_THAT(normalize(times(scale, unit)), IsClose(unit, Rounding(8, 1)));
    }
}

TEST_CASE("rotation: components of very different sizes are normalized as well", "[A3.7][rotation]")
{
    for (const double large : {1e-300, 1e-160, 1e-5, 1.0, 1e5, 1e160, 1e300})
        for (const double ratio : {1e-3, 1e-7, 1e-40, 1e-150}) {
            CAPTURE(large, ratio);
            const double small = ratio * large;
            const double length = std::sqrt(2 + ratio * ratio), other = std::hypot(1, ratio);
            REQUIRE_THAT(
                normalize({large, {small, 0, large}}),
                IsClose(Quaternion{1 / length, {ratio / length, 0, 1 / length}}, Rounding(8, 1)));
            REQUIRE_THAT(normalize({small, {0, -large, 0}}),
                         IsClose(Quaternion{ratio / other, {0, -1 / other, 0}}, Rounding(8, 1)));
        }
}

TEST_CASE("rotation: whichever component is the largest", "[A3.7][rotation]")
{
    for (int large = 0; large < 4; ++large)
        for (int small = 0; small < 4; ++small)
            for (const double size : {1e-150, 1.0, 1e150, 1e300})
                for (const double ratio : {0.1, 1e-10, 1e-100, 1e-155, 1e-160}) {
                    if (small == large) continue;
                    CAPTURE(large, small, size, ratio);
                    Eigen::Vector4d q = Eigen::Vector4d::Zero(), unit = q;
                    q[large] = -size;
                    q[small] = ratio * size;
                    unit[large] = -1 / std::hypot(1, ratio);
                    unit[small] = ratio / std::hypot(1, ratio);
                    REQUIRE_THAT(
                        normalize({q[0], q.tail<3>()}),
                        IsClose(Quaternion{unit[0], Vector3d(unit.tail<3>())}, Rounding(8, 1)));
                }
}

TEST_CASE("rotation: a quarter turn about z takes x to y", "[A3.8][rotation]")
{
    const Quaternion q = {half_root, {0, 0, half_root}};
    REQUIRE_THAT(rotate(q, {2, 0, 3}), IsClose(Vector3d(0, 2, 3), Rounding(16, 4)));
    REQUIRE_THAT(rotate(q, {0, 1, 0}), IsClose(Vector3d(-1, 0, 0), Rounding(16, 1)));
}

TEST_CASE("rotation: the axis stays and lengths are kept", "[A3.8][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = random.quaternion();
        const Vector3d p = 3 * random.vector();
        REQUIRE_THAT(rotate(q, q.v), IsClose(q.v, Rounding(64, 1)));
        REQUIRE_THAT(rotate(q, p).norm(), IsClose(p.norm(), Rounding(64)));
    }
}

TEST_CASE("rotation: q and -q rotate alike", "[A3.8][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = random.quaternion();
        const Vector3d p = 3 * random.vector();
        const Vector3d expected = eigen(q).toRotationMatrix() * p;
        REQUIRE_THAT(rotate(q, p), IsClose(expected, Rounding(32, p.norm())));
        REQUIRE_THAT(rotate(times(-1, q), p), IsClose(expected, Rounding(32, p.norm())));
    }
}

TEST_CASE("rotation: the columns of the matrix are the rotated axes", "[A3.9][rotation]")
{
    Matrix3d expected;
    expected << e_y, -e_x, e_z;
    const Quaternion quarter = {half_root, {0, 0, half_root}};
    REQUIRE_THAT(to_matrix(quarter), IsClose(expected, Rounding(16, 1)));
    // a third of a turn about the diagonal takes x to y, y to z and z to x
    expected << e_y, e_z, e_x;
    REQUIRE_THAT(to_matrix({0.5, {0.5, 0.5, 0.5}}), IsClose(expected, Rounding(16, 1)));
}

TEST_CASE("rotation: a unit quaternion's matrix is a rotation", "[A3.9][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = random.quaternion();
        const Matrix3d R = to_matrix(q);
        REQUIRE_THAT(R, IsRotation());
        REQUIRE_THAT(R, IsClose(eigen(q).toRotationMatrix(), Rounding(256, 1)));
        REQUIRE_THAT(to_matrix(times(-1, q)), IsClose(R, Rounding(256, 1)));
    }
}

TEST_CASE("rotation: at the identity the rate is half of ω", "[A3.10][rotation]")
{
    const Quaternion rate = quaternion_rate({1, {0, 0, 0}}, {2, -4, 6});
    REQUIRE_THAT(rate, IsClose(Quaternion{0, {1, -2, 3}}, Rounding(8, 4)));
    REQUIRE_THAT(quaternion_rate({0.6, {0, 0.8, 0}}, {0, 0, 0}),
                 IsExactly(Quaternion{0, {0, 0, 0}}));
}

TEST_CASE("rotation: the rate is perpendicular to q", "[A3.10][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = random.quaternion();
        const Vector3d w = 5 * random.vector();
        const Quaternion rate = quaternion_rate(q, w);
        REQUIRE_THAT(q.s * rate.s + q.v.dot(rate.v), IsClose(0.0, Rounding(64, w.norm())));
        // 2 q̇ q̄ is (0, ω), with ω in world space
        const Quaternion twice = plain(eigen(rate) * eigen(q).conjugate());
        REQUIRE_THAT(times(2, twice), IsClose(Quaternion{0, w}, Rounding(64, w.norm())));
    }
}

TEST_CASE("rotation: a quaternion times nearly its conjugate turns a little", "[A3.5][rotation]")
{
    // a (ā + δ) = |a|² + a δ
    for (Random random : seeds(10))
        for (int power = 10; power <= 60; power += 2) {
            CAPTURE(power);
            const Quaternion a = any_quaternion(random);
            const double off = std::ldexp(1, -power);
            const Quaternion b = {a.s, Vector3d(off, off, off) - a.v};
            const Quaternion found = multiply(a, b);
            const Vector3d d = b.v + a.v; // off, as it was rounded
            REQUIRE_THAT(found.v, IsClose(Vector3d(a.s * d + a.v.cross(d)), Rounding(64, 16)));
        }
}

TEST_CASE("rotation: the rate is the derivative of the turning quaternion", "[A3.10][rotation]")
{
    const Vector3d w(1, -2, 0.5);
    const Eigen::Quaterniond q(0.5, 0.5, -0.7, 0.1);
    const Quaternion rate = quaternion_rate(plain(q.normalized()), w);
    std::vector<double> errors;
    for (double h : {0.04, 0.02, 0.01}) {
        const Eigen::Quaterniond ahead = turn(h * w) * q.normalized();
        const Eigen::Quaterniond behind = turn(-h * w) * q.normalized();
        const Eigen::Vector4d slope = (ahead.coeffs() - behind.coeffs()) / (2 * h);
        errors.push_back((slope - eigen(rate).coeffs()).norm());
    }
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(4e-5)));
}

} // namespace rotation_quaternion_test
