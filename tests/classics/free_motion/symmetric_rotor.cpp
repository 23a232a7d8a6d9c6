// SPDX-License-Identifier: MIT
// A body of revolution that nothing pulls at (Euler 1758; Landau and Lifshitz, "Mechanics", § 33):
// its axis goes round the angular momentum with L/I₁ at the angle tan θ = I₁ ω₁/(I₃ ω₃), and in
// the body ω goes round the axis with (I₃ - I₁)/I₁ ω₃. Steps of any length are exact.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: the axis of a free body of revolution goes round a cone evenly", "[classics]")
{
    const double M = 12;
    const Vector3d w0(1.5, 4, 0);
    for (const double I3 : {2., 9.}) { // a rod and a disk
        const double I1 = 5;
        RigidBody body = free_box();
        set_mass(body, M, Vector3d(I1, I3, I1).asDiagonal().toDenseMatrix());
        spin(body, w0);
        const Vector3d L = body.state.angular_momentum;
        for (const double h : {0.01, 0.1, 0.7})
            for (const double T : {0.7, 21.}) {
                CAPTURE(I3, h, T);
                World world = solved({body}, {0, 0, 0});
                run_until(world, T, h);
                const Matrix3d R = rotation_matrix(world.bodies[0].state.orientation);
                const Matrix3d round = rotation_matrix(turn(L, L.norm() / I1 * T));
                const double n = T / h;
                CHECK_THAT(Vector3d(R.col(1)),
                           IsClose(Vector3d(round.col(1)), Rounding(100 * n, 1)));
                const double rate = (I3 - I1) / I1 * w0.y() * T; // from z to x about y
                const Vector3d w(w0.x() * std::cos(rate), w0.y(), -w0.x() * std::sin(rate));
                CHECK_THAT(Vector3d(R.transpose() * angular_velocity(world.bodies[0])),
                           IsClose(w, Rounding(200 * n, 4)));
            }
    }
}
