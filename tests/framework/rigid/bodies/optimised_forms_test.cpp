// SPDX-License-Identifier: MIT
// The engine's faster forms give the same results as the reference's formulas, up to rounding.
#include "rigid/bodies/optimised_forms.hpp"

#include "formulas/collision.hpp"
#include "framework/rigid/worlds.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("optimised forms: velocities impulse matrices and impulses are the formulas'", "[rigid]")
{
    for (Random random : seeds(20)) {
        const Body a = random.body(), b = random.body();
        const Vector3d x = random.vector(), j = random.vector();
        CHECK_THAT(optimised::relative_velocity(a, b, x),
                   IsClose(relative_velocity(a, b, x), Rounding(32, 8)));
        // A bound on the terms of K and on the changes of V and ω by the impulse.
        const double terms =
            a.inverse_mass + a.inverse_inertia.norm() * (1 + (x - a.position).squaredNorm());
        CHECK_THAT(optimised::impulse_matrix(a, x),
                   IsClose(impulse_matrix(a.inverse_mass, a.inverse_inertia, a.position, x),
                           Rounding(32, terms)));
        Body pushed = a;
        optimised::apply_impulse(pushed, x, j);
        CHECK_THAT(pushed, IsClose(apply_impulse(a, x, j), Rounding(32, 8 + 2 * terms)));
    }
}

TEST_CASE("optimised forms: a matrix times a vector is that product", "[rigid]")
{
    Matrix3d A;
    A << 1, 2, 3, 4, 5, 6, 7, 8, 10;
    CHECK(optimised::product(A, {1, -1, 2}) == Vector3d(5, 11, 19));
}
