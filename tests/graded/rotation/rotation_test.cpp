// SPDX-License-Identifier: MIT
// A3.1 to A3.4: the drift of rotation matrices, and the limits of Euler angles.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

Matrix3d about(const Vector3d& axis, double angle)
{
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

const Vector3d e_x = Vector3d::UnitX(), e_y = Vector3d::UnitY(), e_z = Vector3d::UnitZ();

Matrix3d yaw_pitch_roll(const Vector3d& angles)
{
    return about(e_z, angles.z()) * about(e_y, angles.y()) * about(e_x, angles.x());
}

} // namespace

TEST_CASE("rotation: the matrix update turns x towards y about z", "[A3.1][rotation]")
{
    const Matrix3d R = advance_matrix(Matrix3d::Identity(), Vector3d(0, 0, 2), 0.5);
    REQUIRE_THAT(R, IsClose(matrix({1, 1, 0}, {-1, 1, 0}, e_z), Rounding(8, 2)));
}

TEST_CASE("rotation: the matrix update moves each axis by ω × axis", "[A3.1][rotation]")
{
    for (Random random : seeds(100)) {
        const Matrix3d R = random.rotation();
        const Vector3d w = 5 * random.vector();
        const double h = random.uniform(0, 0.5);
        Matrix3d expected = R;
        for (int i = 0; i < 3; ++i)
            expected.col(i) += h * w.cross(R.col(i));
        REQUIRE_THAT(advance_matrix(R, w, h), IsClose(expected, Rounding(16, 1 + h * w.norm())));
    }
}

TEST_CASE("rotation: the matrix update stretches what is perpendicular to ω", "[A3.1][rotation]")
{
    // each step stretches by √(1 + |ω|²Δt²), here √1.25; vectors along ω keep their length
    const Vector3d w(0, 3, 4);
    const int n = 100;
    Matrix3d R = matrix(e_x, Vector3d(0, -0.8, 0.6), Vector3d(0, 0.6, 0.8));
    for (int i = 0; i < n; ++i)
        R = advance_matrix(R, w, 0.1);
    const double stretched = std::pow(1.25, n / 2.0);
    const Vector3d lengths = R.colwise().norm().transpose();
    const Vector3d expected(stretched, stretched, 1);
    REQUIRE_THAT(lengths[0], IsClose(expected[0], Rounding(8 * n)));
    REQUIRE_THAT(lengths[1], IsClose(expected[1], Rounding(8 * n)));
    REQUIRE_THAT(lengths[2], IsClose(expected[2], Rounding(8 * n)));
}

TEST_CASE("rotation: the matrix update takes a matrix that has drifted", "[A3.1][rotation]")
{
    // Each step stretches the matrix, and the next one turns about another axis.
    for (Random random : seeds(20)) {
        Matrix3d R = random.rotation(), expected = R;
        for (int step = 0; step < 4; ++step) {
            const Vector3d omega = 2 * random.vector();
            R = advance_matrix(R, omega, 0.3);
            const Matrix3d before = expected;
            for (int i = 0; i < 3; ++i)
                expected.col(i) += 0.3 * omega.cross(before.col(i));
            REQUIRE_THAT(R, IsClose(expected, Rounding(64, 16)));
        }
    }
}

TEST_CASE("rotation: the matrix update is of first order", "[A3.1][rotation]")
{
    const Vector3d w(0.6, 0, 0.8);
    std::vector<double> errors;
    for (int n : {50, 100, 200}) {
        Matrix3d R = Matrix3d::Identity();
        for (int i = 0; i < n; ++i)
            R = advance_matrix(R, w, 1.0 / n);
        errors.push_back((R - turn(w).toRotationMatrix()).norm());
    }
    check_order(errors, 1);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(4e-3)));
}

TEST_CASE("rotation: Gram-Schmidt by hand", "[A3.2][rotation]")
{
    const Matrix3d R = matrix({0, 2, 0}, {3, 1, 0}, {5, 5, -4});
    REQUIRE_THAT(gram_schmidt(R), IsClose(matrix(e_y, e_x, -e_z), Rounding(16, 1)));
}

TEST_CASE("rotation: Gram-Schmidt leaves a rotation as it is", "[A3.2][rotation]")
{
    for (Random random : seeds(100)) {
        const Matrix3d R = random.rotation();
        REQUIRE_THAT(gram_schmidt(R), IsClose(R, Rounding(64, 1)));
    }
}

TEST_CASE("rotation: Gram-Schmidt is biased to the first column", "[A3.2][rotation]")
{
    for (Random random : seeds(100)) {
        Matrix3d R = random.rotation();
        for (int i = 0; i < 3; ++i)
            R.col(i) = random.mass() * (R.col(i) + 0.3 * random.vector());

        const Matrix3d Q = gram_schmidt(R);

        REQUIRE_THAT(Q, IsRotation());
        const Vector3d a = R.col(0).normalized();
        const Vector3d b = (R.col(1) - a.dot(R.col(1)) * a).normalized();
        REQUIRE_THAT(Q, IsClose(matrix(a, b, a.cross(b)), Rounding(256, 1)));
    }
}

TEST_CASE("rotation: Gram-Schmidt turns a reflection into a rotation", "[A3.2][rotation]")
{
    const Matrix3d R = matrix(e_x, e_y, -e_z);
    REQUIRE_THAT(gram_schmidt(R), IsClose(Matrix3d(Matrix3d::Identity()), Rounding(16, 1)));
}

TEST_CASE("rotation: Gram-Schmidt completes what is missing to a rotation", "[A3.2][rotation]")
{
    const Vector3d zero = Vector3d::Zero(), p(0.1, 0.2, 0.3), q(-0.7, 0.4, 0.5);
    const Matrix3d cases[] = {
        Matrix3d::Zero(),       matrix(zero, p, q),        matrix(p, zero, q),
        matrix(p, q, zero),     matrix(zero, zero, p),     matrix(zero, p, zero),
        matrix(p, zero, zero),  matrix(zero, e_x, q),      matrix(zero, e_y, q),
        matrix(zero, e_z, q),   matrix(p, 3 * p, q),       matrix(p, -7 * p, zero),
        matrix(p, 3 * p, p),    matrix(p, q, p + q),       matrix(e_x, e_x, e_x),
        matrix(e_y, -e_y, e_z), matrix(e_z, 2 * e_z, e_x), matrix(p, p / 3, 0.1 * q),
    };
    for (const Matrix3d& R : cases) {
        INFO("R = " << R);
        const Matrix3d Q = gram_schmidt(R);
        REQUIRE_THAT(Q, IsRotation());
        // a first column that is not zero keeps its direction
        if (R.col(0).isZero(0)) continue;
        REQUIRE_THAT(Q.col(0).eval(), IsClose(R.col(0).normalized(), Rounding(64, 1)));
    }
}

TEST_CASE("rotation: Euler angles by hand", "[A3.3][rotation]")
{
    const Tolerance tolerance = Rounding(16, 1);
    REQUIRE_THAT(euler_to_matrix({pi / 2, 0, 0}), IsClose(matrix(e_x, e_z, -e_y), tolerance));
    REQUIRE_THAT(euler_to_matrix({0, pi / 2, 0}), IsClose(matrix(-e_z, e_y, e_x), tolerance));
    REQUIRE_THAT(euler_to_matrix({0, 0, pi / 2}), IsClose(matrix(e_y, -e_x, e_z), tolerance));
    // roll comes first and takes y to z, and yaw leaves it there
    REQUIRE_THAT(euler_to_matrix({pi / 2, 0, pi / 2}), IsClose(matrix(e_y, e_z, e_x), tolerance));
}

TEST_CASE("rotation: Euler angles turn about x then y then z", "[A3.3][rotation]")
{
    for (Random random : seeds(100)) {
        const Vector3d angles = pi * random.vector();
        const Matrix3d R = euler_to_matrix(angles);
        REQUIRE_THAT(R, IsRotation());
        REQUIRE_THAT(R, IsClose(yaw_pitch_roll(angles), Rounding(64, 1)));
    }
}

TEST_CASE("rotation: at gimbal lock yaw and roll turn about one axis", "[A3.3][rotation]")
{
    const Matrix3d R = euler_to_matrix({0.3, pi / 2, 1.1});
    REQUIRE_THAT(R, IsClose(yaw_pitch_roll({0, pi / 2, 0.8}), Rounding(32, 1)));
}

TEST_CASE("rotation: Euler rates by hand", "[A3.4][rotation]")
{
    using Rates = std::optional<Vector3d>;
    const Tolerance tolerance = Rounding(16, 2);
    // upright, the rates are the components of ω
    REQUIRE_THAT(euler_rates({0.7, 0, 0}, {1, 2, 3}), IsClose(Rates({1, 2, 3}), tolerance));
    // yawed by a quarter turn, the roll axis is y and the pitch axis -x
    REQUIRE_THAT(euler_rates({0, 0, pi / 2}, {1, 2, 3}), IsClose(Rates({2, -1, 3}), tolerance));
    // pitched by 45°, a turn about the world's x needs some yaw
    REQUIRE_THAT(euler_rates({0, pi / 4, 0}, e_x), IsClose(Rates({std::sqrt(2), 0, 1}), tolerance));
}

TEST_CASE("rotation: Euler rates add up to ω", "[A3.4][rotation]")
{
    for (Random random : seeds(100)) {
        const Vector3d angles = Vector3d(3, 1.4, 3).cwiseProduct(random.vector());
        const Vector3d w = 5 * random.vector();

        const std::optional<Vector3d> rates = euler_rates(angles, w);

        check_that(rates.has_value(), "rates of the angles, since cos θ is not 0");
        const Vector3d roll_axis = about(e_z, angles.z()) * about(e_y, angles.y()) * e_x;
        const Vector3d pitch_axis = about(e_z, angles.z()) * e_y;
        const Vector3d sum = rates->x() * roll_axis + rates->y() * pitch_axis + rates->z() * e_z;
        REQUIRE_THAT(sum, IsClose(w, Rounding(32, w.norm() + rates->lpNorm<1>())));
    }
}

TEST_CASE("rotation: Euler rates are the derivative of the angles", "[A3.4][rotation]")
{
    // d/dt R(angles + t rates) = ω* R, tested by central differences of second order
    const Vector3d angles(0.4, -0.9, 2.0), w(1, -2, 0.5);
    const std::optional<Vector3d> rates = euler_rates(angles, w);
    check_that(rates.has_value(), "rates of the angles, since cos θ is not 0");
    const Matrix3d R = yaw_pitch_roll(angles);
    Matrix3d R_dot;
    R_dot << w.cross(R.col(0)), w.cross(R.col(1)), w.cross(R.col(2));
    std::vector<double> errors;
    for (double h : {4e-3, 2e-3, 1e-3}) {
        const Vector3d d = h * *rates;
        const Matrix3d slope = (yaw_pitch_roll(angles + d) - yaw_pitch_roll(angles - d)) / (2 * h);
        errors.push_back((slope - R_dot).norm());
    }
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(2e-5)));
}

TEST_CASE("rotation: at gimbal lock there are no Euler rates", "[A3.4][rotation]")
{
    for (double theta : {pi / 2, -pi / 2, 3 * pi / 2, pi / 2 + 1e-14}) {
        CAPTURE(theta);
        const auto rates = euler_rates({0.3, theta, -0.2}, {1, 2, 3});
        REQUIRE_THAT(rates, IsExactly(std::optional<Vector3d>()));
    }
    INFO("also if ω has no part about the axis of roll, or none at all");
    for (double theta : {pi / 2, -pi / 2})
        for (double yaw : {0.0, -0.2, pi / 2})
            for (const auto& [about_pitch, about_yaw] :
                 {std::pair(0, 0), std::pair(0, 1), std::pair(0, -2), std::pair(2, 0),
                  std::pair(2, 1)}) {
                CAPTURE(theta, yaw, about_pitch, about_yaw);
                const Vector3d omega(-about_pitch * std::sin(yaw), about_pitch * std::cos(yaw),
                                     about_yaw);
                REQUIRE_THAT(euler_rates({0.3, theta, yaw}, omega),
                             IsExactly(std::optional<Vector3d>()));
            }
    check_that(euler_rates({0.3, pi / 2 - 1e-6, -0.2}, {1, 2, 3}).has_value(),
               "rates of the angles at θ = π/2 − 1e-6, which is not yet gimbal lock");
}
