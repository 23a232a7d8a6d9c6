// SPDX-License-Identifier: MIT
// A spinning top that is let go falls, is turned aside, and rises again (Goldstein, "Classical
// mechanics", § 5.7). With λ = (I₃ ω₃)²/(2 I₁ F d), cos θ falls from u₀ to
// (λ - √(λ² - 4 λ u₀ + 4))/2.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a top that is let go nods as deep as its spin allows", "[classics]")
{
    const double I1 = 0.04, I3 = 0.02, F = 10, d = 0.1, tilt = 0.6, h = 1 / 4000.;
    AppliedForce pull;
    pull.force = {0, -F, 0};
    pull.point = {0, d, 0};
    for (const double s : {5., 30., 90.}) {
        CAPTURE(s);
        RigidBody top = free_box();
        set_mass(top, 1, Vector3d(I1, I3, I1).asDiagonal().toDenseMatrix());
        top.state.orientation = turn({0, 0, 1}, tilt);
        spin(top, s * rotation_matrix(top.state.orientation).col(1));
        World world = solved({top}, {0, 0, 0});
        world.forces = {pull};
        const double u0 = std::cos(tilt), l = std::pow(I3 * s, 2) / (2 * I1 * F * d);
        double lowest = 1, highest = -1;
        for (int n = 0; n < 6000; ++n) {
            step(world, h);
            const double u = rotation_matrix(world.bodies[0].state.orientation)(1, 1);
            lowest = std::min(lowest, u);
            highest = std::max(highest, u);
        }
        CHECK_THAT(lowest, IsClose((l - std::sqrt(l * l - 4 * l * u0 + 4)) / 2, Order(1e-5)));
        check_at_most(highest, u0 + 1e-9, "cosine of the least tilt");
    }
}
