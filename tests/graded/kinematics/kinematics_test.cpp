// SPDX-License-Identifier: MIT
// A1.1 to A1.5: points, frames and velocities.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

// The matrix w*, column by column: w × eᵢ.
Matrix3d star(const Vector3d& w)
{
    Matrix3d w_x;
    for (int i = 0; i < 3; ++i)
        w_x.col(i) = w.cross(Vector3d::Unit(i));
    return w_x;
}

Matrix3d turn(const Vector3d& w, double t)
{
    return Eigen::AngleAxisd(w.norm() * t, w.normalized()).toRotationMatrix();
}

Matrix3d quarter_turn_about_z()
{
    Matrix3d R;
    R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    return R;
}

} // namespace

TEST_CASE("kinematics: the cross-product matrix by hand", "[A1.1][kinematics]")
{
    Matrix3d expected;
    expected << 0, -3, 2, 3, 0, -1, -2, 1, 0;

    REQUIRE_THAT(cross_matrix(Vector3d(1, 2, 3)), IsExactly(expected));
    REQUIRE_THAT(cross_matrix(Vector3d::Zero()), IsExactly(Matrix3d(Matrix3d::Zero())));
}

TEST_CASE("kinematics: w* x is w × x", "[A1.1][kinematics]")
{
    for (Random random : seeds(100)) {
        const Vector3d w = random.vector(), x = random.vector();

        const Vector3d w_x_x = cross_matrix(w) * x;

        REQUIRE_THAT(w_x_x, IsClose(w.cross(x), Rounding(8, w.norm() * x.norm())));
    }
}

TEST_CASE("kinematics: w* is skew", "[A1.1][kinematics]")
{
    for (Random random : seeds(100)) {
        const Matrix3d w_x = cross_matrix(random.vector());

        REQUIRE_THAT(Matrix3d(w_x.transpose()), IsExactly(Matrix3d(-w_x)));
    }
}

TEST_CASE("kinematics: a point of a body turned a quarter about z", "[A1.2][kinematics]")
{
    const Vector3d X(10, 20, 30);

    const Vector3d x = world_point(quarter_turn_about_z(), X, Vector3d(1, 0, 0));

    REQUIRE_THAT(x, IsClose(Vector3d(10, 21, 30), Rounding(8, X.norm())));
}

TEST_CASE("kinematics: the origin of object space lies at X", "[A1.2][kinematics]")
{
    for (Random random : seeds(20)) {
        const Matrix3d R = random.rotation();
        const Vector3d X = random.vector();

        REQUIRE_THAT(world_point(R, X, Vector3d::Zero()), IsClose(X, Rounding(8, X.norm())));
    }
}

TEST_CASE("kinematics: a rigid motion turns and then moves a point", "[A1.2][kinematics]")
{
    for (Random random : seeds(100)) {
        const Eigen::Quaterniond q = random.eigen_quaternion();
        const Vector3d X = random.vector(), p1 = random.vector(), p2 = random.vector();

        const Vector3d x1 = world_point(q.toRotationMatrix(), X, p1);
        const Vector3d x2 = world_point(q.toRotationMatrix(), X, p2);

        REQUIRE_THAT(x1, IsClose(Vector3d(q * p1 + X), Rounding(64, p1.norm() + X.norm())));
        INFO("distances are kept");
        REQUIRE_THAT((x1 - x2).norm(),
                     IsClose((p1 - p2).norm(), Rounding(64, p1.norm() + p2.norm() + X.norm())));
    }
}

TEST_CASE("kinematics: a point seen from a body turned a quarter about z", "[A1.3][kinematics]")
{
    const Vector3d X(10, 20, 30);

    const Vector3d p = object_point(quarter_turn_about_z(), X, Vector3d(10, 21, 30));

    REQUIRE_THAT(p, IsClose(Vector3d(1, 0, 0), Rounding(8, X.norm())));
}

TEST_CASE("kinematics: the center of mass is the origin of object space", "[A1.3][kinematics]")
{
    for (Random random : seeds(20)) {
        const Matrix3d R = random.rotation();
        const Vector3d X = random.vector();

        REQUIRE_THAT(object_point(R, X, X),
                     IsClose(Vector3d(Vector3d::Zero()), Rounding(8, X.norm())));
    }
}

TEST_CASE("kinematics: the way back undoes the way there", "[A1.3][kinematics]")
{
    for (Random random : seeds(100)) {
        const Eigen::Quaterniond q = random.eigen_quaternion();
        const Vector3d X = random.vector(), p = random.vector();
        const Vector3d x = q * p + X;

        REQUIRE_THAT(object_point(q.toRotationMatrix(), X, x),
                     IsClose(p, Rounding(64, p.norm() + 2 * X.norm())));
    }
}

TEST_CASE("kinematics: angular velocity of a body that spins about z", "[A1.4][kinematics]")
{
    Matrix3d R_dot; // ω* R with ω = (0, 0, 2)
    R_dot << -2, 0, 0, 0, -2, 0, 0, 0, 0;

    REQUIRE_THAT(angular_velocity(R_dot, quarter_turn_about_z()),
                 IsClose(Vector3d(0, 0, 2), Rounding(8, 2)));
    INFO("a body that does not turn");
    REQUIRE_THAT(angular_velocity(Matrix3d::Zero(), quarter_turn_about_z()),
                 IsExactly(Vector3d(Vector3d::Zero())));
}

TEST_CASE("kinematics: angular velocity is in world space", "[A1.4][kinematics]")
{
    for (Random random : seeds(100)) {
        const Matrix3d R = random.rotation();
        const Vector3d w = random.vector();

        REQUIRE_THAT(angular_velocity(star(w) * R, R), IsClose(w, Rounding(64, w.norm())));
    }
}

TEST_CASE("kinematics: angular velocity is that of the skew part", "[A1.4][kinematics]")
{
    for (Random random : seeds(100)) {
        const Matrix3d R = random.rotation(), B = random.positive_definite();
        const Vector3d w = random.vector();

        const Vector3d found = angular_velocity((star(w) + B) * R, R);

        REQUIRE_THAT(found, IsClose(w, Rounding(16, w.norm() + B.norm())));
    }
}

TEST_CASE("kinematics: a difference in time gives the angular velocity to second order",
          "[A1.4][kinematics]")
{
    // (R(t + h) - R(t))/h Rᵀ = (exp(h ω*) - δ)/h, whose skew part is sin(h |ω|)/(h |ω|) ω*. The
    // error is therefore of second order.
    for (Random random : seeds(20)) {
        const Matrix3d R = random.rotation();
        const Vector3d w = 2 * random.unit_vector();
        std::vector<double> errors;
        for (const double h : {0.1, 0.05, 0.025}) {
            const Matrix3d R_dot = (turn(w, h) * R - R) / h;

            const Vector3d found = angular_velocity(R_dot, R);

            REQUIRE_THAT(found,
                         IsClose(Vector3d(std::sin(2 * h) / (2 * h) * w), Rounding(16, 1 / h)));
            errors.push_back((found - w).norm());
        }
        check_order(errors, 2);
    }
}

TEST_CASE("kinematics: velocity of a point of a spinning body", "[A1.5][kinematics]")
{
    const Vector3d V(0, 0, 5), w(0, 0, 2), X(1, 0, 0), x(1, 3, 0);

    // (0, 0, 2) × (0, 3, 0) = (-6, 0, 0)
    REQUIRE_THAT(point_velocity(V, w, X, x), IsClose(Vector3d(-6, 0, 5), Rounding(8, 11)));
    INFO("the center of mass moves with V");
    REQUIRE_THAT(point_velocity(V, w, X, X), IsClose(V, Rounding(8, 5)));
}

TEST_CASE("kinematics: no two points of a body part or approach", "[A1.5][kinematics]")
{
    for (Random random : seeds(100)) {
        const Vector3d V = random.vector(), w = random.vector(), X = random.vector();
        const Vector3d x1 = random.vector(), x2 = random.vector();
        const double scale = V.norm() + w.norm() * (X.norm() + x1.norm() + x2.norm());

        const Vector3d v1 = point_velocity(V, w, X, x1), v2 = point_velocity(V, w, X, x2);

        REQUIRE_THAT((v1 - v2).dot(x1 - x2), IsClose(0.0, Rounding(16, 4 * scale)));
        INFO("v₁ - v₂ = ω × (x₁ - x₂)");
        REQUIRE_THAT(Vector3d(v1 - v2), IsClose(w.cross(x1 - x2), Rounding(16, scale)));
    }
}

TEST_CASE("kinematics: velocity is the derivative of the position", "[A1.5][kinematics]")
{
    for (Random random : seeds(20)) {
        const Matrix3d R = random.rotation();
        const Vector3d V = random.vector(), w = 2 * random.unit_vector(), X = random.vector();
        const Vector3d p = random.unit_vector();
        const Vector3d axis = w.normalized(), r = R * p;
        if (axis.cross(r).norm() < 0.1) continue; // hardly moves: no order can be seen

        const Vector3d v = point_velocity(V, w, X, r + X);

        std::vector<double> errors;
        for (const double h : {0.1, 0.05, 0.025}) {
            const Vector3d after = turn(w, h) * r + X + h * V, before = turn(w, -h) * r + X - h * V;
            errors.push_back((v - (after - before) / (2 * h)).norm());
        }
        check_order(errors, 2);
    }
}
