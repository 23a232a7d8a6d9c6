// SPDX-License-Identifier: MIT
// A wing nut that turns about its middle axis turns over again and again (Dzhanibekov 1985). By
// Jacobi's solution (Landau and Lifshitz, "Mechanics", § 37), with I₁ < I₂ < I₃ and L² > 2 E I₂, it
// takes 2 K(k) √(I₁ I₂ I₃/((I₃ - I₂)(L² - 2 E I₁))) from one flip to the next, with
// k² = (I₂ - I₁)(2 E I₃ - L²)/((I₃ - I₂)(L² - 2 E I₁)).
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a wing nut turns over at even intervals", "[classics]")
{
    const double I1 = 5, I2 = 10, I3 = 13;
    const Vector3d w0(0.02, 2, 0.02); // about the axes of 13, 10 and 5
    const Vector3d L = free_moments.cwiseProduct(w0);
    const double E2 = w0.dot(L), LL = L.squaredNorm();
    REQUIRE(LL > E2 * I2);
    const double k = std::sqrt((I2 - I1) * (E2 * I3 - LL) / ((I3 - I2) * (LL - E2 * I1)));
    const double interval =
        2 * std::comp_ellint_1(k) * std::sqrt(I1 * I2 * I3 / ((I3 - I2) * (LL - E2 * I1)));
    const double h = 0.005;
    World world = solved({free_box(w0)}, {0, 0, 0});
    std::vector<double> flips;
    double before = w0.y();
    for (int n = 1; n * h < 3.6 * interval; ++n) {
        step(world, h);
        const double now = (rotation_matrix(world.bodies[0].state.orientation).transpose() *
                            angular_velocity(world.bodies[0]))
                               .y();
        if (before * now < 0) flips.push_back(h * (n - now / (now - before)));
        before = now;
    }
    CAPTURE(interval, flips);
    REQUIRE(flips.size() >= 3);
    for (std::size_t i = 1; i < flips.size(); ++i)
        CHECK_THAT(flips[i] - flips[i - 1], IsClose(interval, Order(1e-4)));
}
