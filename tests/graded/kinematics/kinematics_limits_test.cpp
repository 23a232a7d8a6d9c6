// SPDX-License-Identifier: MIT
// A1: rods and point masses, which have inertia about some axes or about none, and bodies that have
// turned by a tiny angle.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

void check_rates(const MatrixState& state, double inverse_mass, const Matrix3d& I_inverse,
                 const Wrench& wrench)
{
    const MatrixStateRate rate = equations_of_motion(state, inverse_mass, I_inverse, wrench);
    const Matrix3d& R = state.rotation;
    const Vector3d w = I_inverse * state.angular_momentum;
    Matrix3d R_dot;
    R_dot << w.cross(R.col(0)), w.cross(R.col(1)), w.cross(R.col(2));
    REQUIRE_THAT(rate.position_rate, IsExactly(state.velocity));
    REQUIRE_THAT(rate.rotation_rate, IsClose(R_dot, Rounding(128, 1 + w.norm())));
    REQUIRE_THAT(rate.velocity_rate, IsClose(Vector3d(inverse_mass * wrench.force), Rounding(32)));
    REQUIRE_THAT(rate.angular_momentum_rate, IsExactly(wrench.torque));
}

} // namespace

TEST_CASE("kinematics: rods and point masses move as well", "[A1.9][kinematics]")
{
    for (Random random : seeds(40)) {
        const Matrix3d R = random.rotation();
        const MatrixState state = {random.vector(), R, random.vector(), random.vector()};
        const Wrench wrench = {random.vector(), random.vector()};
        const double inverse_mass = random.mass();
        for (const double across : {0.0, 2.0}) { // a point mass, a rod along its z-axis
            CAPTURE(across);
            const Matrix3d I_inverse = R * Vector3d(across, across, 0).asDiagonal() * R.transpose();
            check_rates(state, inverse_mass, I_inverse, wrench);
        }
    }
}

TEST_CASE("kinematics: a body at rest is set in motion, and one without a force moves on",
          "[A1.9][kinematics]")
{
    for (Random random : seeds(4))
        for (int zeros = 0; zeros < 16; ++zeros) {
            CAPTURE(zeros);
            MatrixState state = {random.vector(), random.rotation(), random.vector(),
                                 random.vector()};
            Wrench wrench = {random.vector(), random.vector()};
            int k = 0;
            for (Vector3d* part :
                 {&state.velocity, &state.angular_momentum, &wrench.force, &wrench.torque})
                if (zeros >> k++ & 1) part->setZero();
            check_rates(state, random.mass(), Matrix3d::Identity(), wrench);
        }
}

TEST_CASE("kinematics: grains of dust and planets move by the same equations", "[A1.9][kinematics]")
{
    for (Random random : seeds(4))
        for (int power = -60; power <= 60; power += 4) {
            CAPTURE(power);
            const double inverse_mass = std::pow(10.0, power);
            const MatrixState state = {random.vector(), random.rotation(), random.vector(),
                                       random.vector() / inverse_mass};
            check_rates(state, inverse_mass, inverse_mass * Matrix3d::Identity(),
                        {random.vector(), random.vector()});
        }
}

TEST_CASE("kinematics: a static body has no rates even if it has a velocity", "[A1.9][kinematics]")
{
    for (Random random : seeds(20)) {
        const MatrixState state = {random.vector(), random.rotation(), random.vector(),
                                   random.vector()};
        const Wrench wrench = {random.vector(), random.vector()};
        const MatrixStateRate rate = equations_of_motion(state, 0, Matrix3d::Zero(), wrench);
        REQUIRE_THAT(rate, IsExactly(MatrixStateRate()));
    }
}

namespace {

// The rotation matrix of a body that has turned by a tiny angle, down to 2^-40 rad: no entry of the
// matrix is a rounding error.
Matrix3d slightly_turned(Random& random)
{
    const double angle = std::ldexp(1, -1 - static_cast<int>(random.bits() % 40));
    return Eigen::AngleAxisd(angle, random.unit_vector()).toRotationMatrix();
}

} // namespace

TEST_CASE("kinematics: a body that has turned by a tiny angle has turned", "[A1.2][kinematics]")
{
    for (Random random : seeds(80)) {
        const Matrix3d R = slightly_turned(random);
        const Vector3d p = random.vector();
        const Vector3d expected = p.x() * R.col(0) + p.y() * R.col(1) + p.z() * R.col(2);
        REQUIRE_THAT(world_point(R, Vector3d::Zero(), p),
                     IsClose(expected, Rounding(32, p.norm())));
    }
}

TEST_CASE("kinematics: seen from a body that has turned by a tiny angle, the world has turned",
          "[A1.3][kinematics]")
{
    for (Random random : seeds(80)) {
        const Matrix3d R = slightly_turned(random);
        const Vector3d x = random.vector();
        const Vector3d expected(R.col(0).dot(x), R.col(1).dot(x), R.col(2).dot(x));
        REQUIRE_THAT(object_point(R, Vector3d::Zero(), x),
                     IsClose(expected, Rounding(32, x.norm())));
    }
}

TEST_CASE("kinematics: a point that is nearly at the center", "[A1.2][kinematics]")
{
    // The center has only an x, the point no x.
    for (int power = 0; power <= 80; power += 2) {
        const double s = std::ldexp(1, -power);
        CAPTURE(s);
        REQUIRE_THAT(world_point(Matrix3d::Identity(), {1, 0, 0}, {0, s, 0}),
                     IsExactly(Vector3d(1, s, 0)));
    }
}

TEST_CASE("kinematics: a point that is nearly at the center, seen from the body",
          "[A1.3][kinematics]")
{
    for (int power = 0; power <= 80; power += 2) {
        const double s = std::ldexp(1, -power);
        CAPTURE(s);
        REQUIRE_THAT(object_point(Matrix3d::Identity(), {1, 0, 0}, {1, s, 0}),
                     IsExactly(Vector3d(0, s, 0)));
    }
}

TEST_CASE("kinematics: the angular velocity of a body that has turned by a tiny angle",
          "[A1.4][kinematics]")
{
    for (Random random : seeds(80)) {
        const Matrix3d R = slightly_turned(random);
        const Vector3d w = random.vector();
        Matrix3d R_dot;
        R_dot << w.cross(R.col(0)), w.cross(R.col(1)), w.cross(R.col(2));
        REQUIRE_THAT(angular_velocity(R_dot, R), IsClose(w, Rounding(32, w.norm())));
    }
}
