// SPDX-License-Identifier: MIT
#include "framework/geometry/distance/convex_shapes.hpp"
#include "geometry/distance/separation.hpp"
#include "geometry/distance/support.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// Distance of two shapes along a direction n from b to a, computed by their support functions [m].
double along(const Shape& a, const Pose& pose, const Shape& b, const Vector3d& n)
{
    const Vector3d low = pose * support(a, -(pose.R.transpose() * n));
    return n.dot(low - support(b, n));
}

// The largest of the distances along many directions.
double brute_force(const Shape& a, const Pose& pose, const Shape& b)
{
    Random random(1);
    double best = -1e300;
    Vector3d direction = Vector3d::UnitY();
    for (int i = 0; i < 3000; ++i) {
        const Vector3d n = random.unit_vector();
        if (const double s = along(a, pose, b, n); s > best) {
            best = s;
            direction = n;
        }
    }
    for (double step = 0.05; step > 1e-7; step *= 0.9) // local search from the best one
        for (int i = 0; i < 8; ++i) {
            const Vector3d n = (direction + step * random.vector()).normalized();
            if (const double s = along(a, pose, b, n); s > best) {
                best = s;
                direction = n;
            }
        }
    return best;
}

} // namespace

TEST_CASE("separation: shapes apart are as far as their nearest points", "[geometry]")
{
    int apart = 0;
    for (std::size_t i = 0; i < convex_shapes().size(); ++i)
        for (std::size_t j = 0; j < convex_shapes().size(); ++j)
            for (unsigned seed = 0; seed < 12; ++seed) {
                CAPTURE(i, j, seed);
                Random random(seed);
                const Pose pose{random.rotation(), 2 * random.vector()};
                const Shape &a = convex_shapes()[i], &b = convex_shapes()[j];
                const Separation found = separation(a, pose, b, 1e9);
                if (found.distance <= 1e-3) continue;
                ++apart;
                // The direction gives a lower bound of the distance, the points an upper bound.
                REQUIRE_THAT(along(a, pose, b, found.normal),
                             IsClose(found.distance, Rounding(64, 4)));
                REQUIRE_THAT((found.point1 - found.point2).norm(),
                             IsClose(found.distance, Order(1e-9)));
                REQUIRE_THAT(found.normal.norm(), IsClose(1.0, Rounding(8)));
            }
    CHECK(apart > 100);
}

TEST_CASE("separation: shapes that overlap a little are parted the shortest way", "[geometry]")
{
    int overlapping = 0;
    for (std::size_t i = 0; i < convex_shapes().size(); ++i)
        for (std::size_t j = 0; j < convex_shapes().size(); ++j)
            for (unsigned seed = 0; seed < 6; ++seed) {
                CAPTURE(i, j, seed);
                Random random(seed);
                const Shape &a = convex_shapes()[i], &b = convex_shapes()[j];
                Pose pose{random.rotation(), 4 * random.unit_vector()};
                const Separation before = separation(a, pose, b, 1e9);
                const double depth = random.uniform(0, 0.15);
                pose.X -= (before.distance + depth) * before.normal; // from a touch to an overlap
                const Separation found = separation(a, pose, b, 1e9);
                if (found.distance >= 0) continue; // it moved past a corner
                ++overlapping;
                REQUIRE_THAT(along(a, pose, b, found.normal),
                             IsClose(found.distance, Rounding(64, 4)));
                // No direction is shorter by more than 1 %, the error of the polytope's last face.
                // A shallow overlap of facets may end at a facet next to the best one.
                const double shortest = std::max(-depth, brute_force(a, pose, b));
                REQUIRE(found.distance >= shortest * 1.01 - 1e-7);
            }
    CHECK(overlapping > 250);
}

TEST_CASE("separation: it is finite and honest for shapes at one place", "[geometry]")
{
    for (const Shape& a : convex_shapes())
        for (const Shape& b : convex_shapes())
            for (const Vector3d& X :
                 {Vector3d(0, 0, 0), Vector3d(0, 1e-12, 0), Vector3d(0.1, 0, 0)}) {
                const Separation found = separation(a, {Matrix3d::Identity(), X}, b, 1e9);
                REQUIRE(std::isfinite(found.distance));
                REQUIRE(found.point1.allFinite());
                REQUIRE_THAT(found.normal.norm(), IsClose(1.0, Rounding(8)));
                REQUIRE_THAT(along(a, {Matrix3d::Identity(), X}, b, found.normal),
                             IsClose(found.distance, Rounding(64, 4)));
            }
}

TEST_CASE("separation: a touch is a distance of zero", "[geometry]")
{
    for (const Shape& a : convex_shapes())
        for (const Shape& b : convex_shapes())
            for (unsigned seed = 0; seed < 4; ++seed) {
                CAPTURE(a.index(), b.index(), seed);
                Random random(seed);
                Pose pose{random.rotation(), 4 * random.unit_vector()};
                const Separation before = separation(a, pose, b, 1e9);
                pose.X -= before.distance * before.normal;
                const Separation found = separation(a, pose, b, 1e9);
                REQUIRE_THAT(found.distance, IsClose(0.0, Order(1e-7)));
                REQUIRE_THAT(along(a, pose, b, found.normal), IsClose(0.0, Order(1e-7)));
            }
}
