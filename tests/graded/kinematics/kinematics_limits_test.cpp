// SPDX-License-Identifier: MIT
// A1: rods and point masses, which have inertia about some axes or about none.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("kinematics: rods and point masses move as well", "[A1.9][kinematics]")
{
    for (Random random : seeds(40)) {
        const Matrix3d R = random.rotation();
        const MatrixState state = {random.vector(), R, random.vector(), random.vector()};
        const Wrench wrench = {random.vector(), random.vector()};
        const double inverse_mass = random.mass();
        for (const double across : {0.0, 2.0}) { // a point mass, a rod along the z-axis of its R
            CAPTURE(across);
            const Matrix3d I_inverse = R * Vector3d(across, across, 0).asDiagonal() * R.transpose();
            const MatrixStateRate rate =
                equations_of_motion(state, inverse_mass, I_inverse, wrench);
            const Vector3d w = I_inverse * state.angular_momentum;
            Matrix3d R_dot;
            R_dot << w.cross(R.col(0)), w.cross(R.col(1)), w.cross(R.col(2));
            REQUIRE_THAT(rate.position_rate, IsExactly(state.velocity));
            REQUIRE_THAT(rate.rotation_rate, IsClose(R_dot, Rounding(32, 1 + w.norm())));
            REQUIRE_THAT(rate.velocity_rate,
                         IsClose(Vector3d(inverse_mass * wrench.force), Rounding(8)));
            REQUIRE_THAT(rate.angular_momentum_rate, IsExactly(wrench.torque));
        }
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
