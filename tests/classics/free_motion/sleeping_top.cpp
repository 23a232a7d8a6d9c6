// SPDX-License-Identifier: MIT
// An upright top sleeps if it spins fast enough: (I₃ ω₃)² > 4 I₁ F d; below that it falls
// (Lagrange; Whittaker, "Analytical dynamics", § 71).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a top sleeps above its critical spin and falls below it", "[classics]")
{
    const double I1 = 0.04, I3 = 0.02, F = 10, d = 0.1;
    const double critical = std::sqrt(4 * I1 * F * d) / I3;
    AppliedForce pull;
    pull.force = {0, -F, 0};
    pull.point = {0, d, 0};
    for (const double share : {0.95, 0.99, 1.01, 1.05})
        for (const double h : {0.01, 0.002}) {
            CAPTURE(share, h);
            RigidBody top = free_box();
            set_mass(top, 1, Vector3d(I1, I3, I1).asDiagonal().toDenseMatrix());
            top.state.orientation = turn({0, 0, 1}, 1e-5);
            const Vector3d axis = rotation_matrix(top.state.orientation).col(1);
            spin(top, share * critical * axis);
            World world = solved({top}, {0, 0, 0});
            world.forces = {pull};
            double tilt = 0;
            for (int n = 0; n * h < 20; ++n) {
                step(world, h);
                const Vector3d a = rotation_matrix(world.bodies[0].state.orientation).col(1);
                tilt = std::max(tilt, std::hypot(a.x(), a.z()));
            }
            if (share > 1)
                check_at_most(tilt, 2e-4, "tilt [rad]");
            else
                check_at_least(tilt, 0.1, "tilt [rad]");
        }
}
