// SPDX-License-Identifier: MIT
#include "geometry/shapes/pose.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

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
