// SPDX-License-Identifier: MIT
#include "geometry/shapes/shape_bounds.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

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
        // The support point of the rotated part is computed for this direction.
        const Vector3d direction = random.unit_vector();
        const Pose placed = part_pose({random.rotation(), {0, 0, 0}}, part);
        const Vector3d half =
            (placed.R.transpose() * direction).cwiseAbs().cwiseProduct(Vector3d(0.5, 1, 1.5));
        REQUIRE(direction.dot(placed.X) + half.sum() <= radius);
    }
    part.shape = Plane{};
    CHECK(std::isinf(bounding_radius(part)));
    CHECK_FALSE(bounds_of(part.shape, {}).high.allFinite());
}
