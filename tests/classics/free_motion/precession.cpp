// SPDX-License-Identifier: MIT
// A top precesses steadily at the tilt θ with either rate of
// I₁ Ω² cos θ - I₃ ω₃ Ω + F d = 0 (Lagrange 1788; Goldstein, "Classical mechanics", § 5.7). Here a
// steady force pulls at the distance d above the center of mass, which then flies off evenly.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a top precesses steadily with a slow or a fast rate", "[classics]")
{
    const double I1 = 0.04, I3 = 0.02, F = 10, d = 0.1, tilt = 0.5, s = 60;
    AppliedForce pull;
    pull.force = {0, -F, 0};
    pull.point = {0, d, 0};
    for (const int sign : {-1, 1}) {
        const double L3 = I3 * s, c = std::cos(tilt);
        const double W = (L3 + sign * std::sqrt(L3 * L3 - 4 * I1 * F * d * c)) / (2 * I1 * c);
        const Vector3d y(0, 1, 0), axis(-std::sin(tilt), c, 0);
        const double T = 1;
        std::vector<double> errors;
        for (const int steps : {200, 400, 800}) {
            RigidBody top = free_box();
            set_mass(top, 1, Vector3d(I1, I3, I1).asDiagonal().toDenseMatrix());
            top.state.orientation = turn({0, 0, 1}, tilt);
            spin(top, W * y + (s - W * c) * axis);
            World world = solved({top}, {0, 0, 0});
            world.forces = {pull};
            run(world, steps, T / steps);
            const Matrix3d R = rotation_matrix(world.bodies[0].state.orientation);
            errors.push_back((R.col(1) - rotation_matrix(turn(y, W * T)) * axis).norm());
        }
        CAPTURE(sign, W, errors);
        check_order(errors, 4);
        check_at_most(errors.back(), 1e-4, "error of the axis");
    }
}
