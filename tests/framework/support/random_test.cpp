// SPDX-License-Identifier: MIT
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("random: a seed gives the same case on every machine", "[support]")
{
    CHECK(Random(7).bits() == Random(7).bits());
    CHECK(Random(7).bits() != Random(8).bits());
    CHECK(Random(0).bits() == 7960286522194355700u);
}

TEST_CASE("random: bodies could exist", "[support]")
{
    for (Random random : seeds(100)) {
        REQUIRE_THAT(random.rotation(), IsRotation());
        REQUIRE_THAT(random.unit_vector().norm(), IsClose(1.0, Rounding(4, 1)));

        const Matrix3d I = random.inertia();
        const Vector3d m = I.selfadjointView<Eigen::Lower>().eigenvalues();
        REQUIRE(m(0) > 0);
        REQUIRE(m(0) + m(1) >= m(2) * (1 - 1e-12));

        const Body body = random.body();
        REQUIRE_THAT(Vector3d(body.inverse_inertia * body.angular_momentum),
                     IsClose(body.angular_velocity, Rounding(1e3, 1)));
    }
}
