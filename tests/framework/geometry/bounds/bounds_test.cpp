// SPDX-License-Identifier: MIT
#include "geometry/shapes/shape_bounds.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("pose: composing poses applies the inner one first", "[geometry]")
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Pose outer{random.rotation(), random.vector()},
            inner{random.rotation(), random.vector()};
        const Vector3d p = random.vector();
        REQUIRE_THAT((outer * inner) * p, IsClose(outer * (inner * p), Rounding(32, 4)));
    }
}

TEST_CASE("pose: quaternion and matrix say the same rotation", "[geometry]")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Matrix3d R = random.rotation();
        REQUIRE_THAT(rotation_matrix(quaternion_of(R)), IsClose(R, Rounding(16)));
        const Quaternion q = quaternion_of(R), longer{3 * q.s, 3 * q.v};
        REQUIRE_THAT(rotation_matrix(longer), IsClose(R, Rounding(16)));
    }
    CHECK_THAT(rotation_matrix({0, {0, 0, 0}}), IsExactly(Matrix3d(Matrix3d::Identity())));
}

TEST_CASE("bounds: a turned box fills its bounds and stays inside", "[geometry]")
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Box box{{1, 2, 3}};
        const Pose pose{random.rotation(), random.vector()};
        const Bounds bounds = bounds_of(box, pose);
        Bounds corners;
        for (int i = 0; i < 8; ++i) {
            const Vector3d sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
            const Vector3d x = pose * sign.cwiseProduct(box.size / 2);
            corners.include({x, x});
        }
        REQUIRE_THAT(bounds.low, IsClose(corners.low, Rounding(16, 3)));
        REQUIRE_THAT(bounds.high, IsClose(corners.high, Rounding(16, 3)));
    }
}

TEST_CASE("bounds: a part lies within its bounding radius however its body turns", "[geometry]")
{
    Part part{Box{{1, 2, 3}}, {0.5, -1, 2}, {}};
    const double radius = bounding_radius(part);
    CHECK_THAT(radius, IsClose(std::sqrt(5.25) + std::sqrt(14.0) / 2, Rounding(8)));
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Vector3d direction = random.unit_vector(); // the support point of the turned part
        const Pose placed = part_pose({random.rotation(), {0, 0, 0}}, part);
        const Vector3d half =
            (placed.R.transpose() * direction).cwiseAbs().cwiseProduct(Vector3d(0.5, 1, 1.5));
        REQUIRE(direction.dot(placed.X) + half.sum() <= radius);
    }
    part.shape = Plane{};
    CHECK(std::isinf(bounding_radius(part)));
    CHECK_FALSE(bounds_of(part.shape, {}).high.allFinite());
}

TEST_CASE("bounds: those that share a face overlap and those apart do not", "[geometry]")
{
    const Bounds a{{0, 0, 0}, {1, 1, 1}}, touching{{1, 0, 0}, {2, 1, 1}},
        apart{{1.1, 0, 0}, {2, 1, 1}};
    CHECK(a.overlaps(touching));
    CHECK_FALSE(a.overlaps(apart));
    Bounds grown = a;
    grown.grow(0.2);
    CHECK(grown.overlaps(apart));
    CHECK_FALSE(Bounds().overlaps(a)); // nothing overlaps nothing
}
