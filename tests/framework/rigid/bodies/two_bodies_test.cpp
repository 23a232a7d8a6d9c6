// SPDX-License-Identifier: MIT
#include "rigid/bodies/two_bodies.hpp"

#include "formulas/collision.hpp"
#include "framework/rigid/worlds.hpp"
#include "rigid/bodies/optimised_forms.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;
using namespace rigor::optimised;

TEST_CASE("two bodies: the vectors of both are computed at once", "[rigid]")
{
    const Vector3d a1(1, 2, 3), a2(-4, 5, 6), b1(7, -8, 9), b2(2, 0, -1);
    TwoVectors a = side_by_side(a1, a2);
    const TwoVectors b = side_by_side(b1, b2);
    CHECK(of_first(a) == a1);
    CHECK(of_second(a) == a2);
    CHECK(difference(a) == Vector3d(a1 - a2));
    CHECK(of_first(cross(a, b)) == a1.cross(b1));
    CHECK(of_second(cross(a, b)) == a2.cross(b2));
    const Two products = dot(a, b);
    CHECK(products[0] == a1.dot(b1));
    CHECK(products[1] == a2.dot(b2));
    CHECK(of_first(broadcast(a1)) == a1);
    CHECK(of_second(broadcast(a1)) == a1);
    a += b;
    CHECK(of_first(a) == Vector3d(a1 + b1));
    CHECK(of_second(a) == Vector3d(a2 + b2));
}

TEST_CASE("two bodies: an impulse acts on the first and its opposite on the second", "[rigid]")
{
    for (Random random : seeds(20)) {
        Body body1 = random.body(), body2 = random.body();
        const Vector3d x = random.vector(), j = random.vector();
        const TwoMasses masses(body1, body2);
        const TwoVectors r = side_by_side(x - body1.position, x - body2.position);
        TwoMotions motions{side_by_side(body1.velocity, body2.velocity),
                           side_by_side(body1.angular_velocity, body2.angular_velocity)};
        CHECK_THAT(motions.relative_velocity(r),
                   IsClose(rigor::relative_velocity(body1, body2, x), Rounding(32, 8)));
        motions.apply(masses, r, j);
        optimised::apply_impulse(body1, x, j);
        optimised::apply_impulse(body2, x, -j);
        const Tolerance rounding =
            Rounding(32, 8 + 4 * (body1.inverse_inertia.norm() + body2.inverse_inertia.norm()));
        CHECK_THAT(of_first(motions.V), IsClose(body1.velocity, rounding));
        CHECK_THAT(of_second(motions.V), IsClose(body2.velocity, rounding));
        CHECK_THAT(of_first(motions.w), IsClose(body1.angular_velocity, rounding));
        CHECK_THAT(of_second(motions.w), IsClose(body2.angular_velocity, rounding));
    }
}

TEST_CASE("two bodies: an impulse does not move a static body", "[rigid]")
{
    Random random(1);
    const Body body = random.body();
    const TwoMasses masses(body, Body());
    const TwoVectors r = side_by_side({1, 2, 3}, {4, 5, 6});
    TwoMotions motions{broadcast({0, 0, 0}), broadcast({0, 0, 0})};
    motions.apply(masses, r, {1, -1, 2});
    CHECK(of_second(motions.V) == Vector3d(0, 0, 0));
    CHECK(of_second(motions.w) == Vector3d(0, 0, 0));
    CHECK_THAT(of_first(motions.V),
               IsClose(Vector3d(body.inverse_mass * Vector3d(1, -1, 2)), Rounding(4)));
}
