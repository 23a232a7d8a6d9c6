// SPDX-License-Identifier: MIT
#include "framework/geometry/distance/convex_shapes.hpp"
#include "geometry/distance/support.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("support: no point of the shape is farther", "[geometry]")
{
    for (const Shape& shape : convex_shapes())
        for (unsigned seed = 0; seed < 50; ++seed) {
            CAPTURE(shape.index(), seed);
            Random random(seed);
            const Vector3d d = random.unit_vector();
            const Vector3d far = support(shape, d);
            for (int i = 0; i < 50; ++i)
                REQUIRE(d.dot(support(shape, random.unit_vector())) <= d.dot(far) + 1e-12);
            const Feature feature = feature_towards(shape, d);
            REQUIRE(feature.count >= 1);
            if (feature.count > 1) continue;
            REQUIRE_THAT(d.dot(feature.points[0]), IsClose(d.dot(far), Rounding(32, 2)));
        }
}
