// SPDX-License-Identifier: MIT
#include "framework/rigid/contact_shapes.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("edge contact: crossed cubes that touch at edges only have their contact there",
          "[rigid]")
{
    const double half = std::sqrt(0.5), overlap = 1e-3;
    const Pose lower = turned({1, 0, 0}, 45, {0, 0, 0});
    const Pose upper = turned({0, 0, 1}, 45, {0, 2 * half - overlap, 0});
    const TriangleMesh cube = dented_box({1, 1, 1});
    for (const Vector3d& v : cube.vertices) { // no vertex of one box lies in the other
        const Vector3d p = lower.R.transpose() * (upper * v - lower.X);
        REQUIRE(signed_distance(Box{{1, 1, 1}}, p).distance > 0);
    }
    for (const Shape& first : {Shape(Box{{1, 1, 1}}), mesh(cube)}) {
        const auto touches = touches_of(first, upper, mesh(cube), lower, 0);
        REQUIRE(!touches.empty());
        CHECK_THAT(deepest(touches), IsClose(-overlap, Order(1e-9)));
        const auto at =
            std::min_element(touches.begin(), touches.end(),
                             [](const Contact& a, const Contact& b) { return a.gap < b.gap; });
        CHECK_THAT(at->normal, IsClose(Vector3d(0, 1, 0), Order(1e-9)));
        CHECK_THAT(at->point, IsClose(Vector3d(0, half - overlap / 2, 0), Order(1e-9)));
    }
}
