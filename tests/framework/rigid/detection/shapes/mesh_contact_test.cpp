// SPDX-License-Identifier: MIT
// Contacts by level sets, one case at a time.
#include "framework/rigid/contact_shapes.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("mesh contact: bars that cross flat touch at the corners of their crossing", "[rigid]")
{
    const Shape cross =
        mesh(cross_mesh(2, 0.3)); // the bar lies across its arm along x, turned by 30°
    const Pose lower{}, upper = turned({0, 1, 0}, 30, {0.5, 0.3 - 1e-4, 0});
    const auto touches = touches_of(Box{{0.3, 0.3, 0.7}}, upper, cross, lower, 0.001);
    REQUIRE(touches.size() >= 4);
    Vector3d low = Vector3d::Constant(1e9), high = -low;
    for (const Contact& t : touches) {
        CHECK_THAT(t.normal, IsClose(Vector3d(0, 1, 0), Order(1e-6)));
        CHECK_THAT(t.gap, IsClose(-1e-4, Order(1e-6)));
        low = low.cwiseMin(t.point);
        high = high.cwiseMax(t.point);
    }
    CHECK_THAT(high.z(), IsClose(0.15, Order(1e-9)));
    CHECK_THAT(low.z(), IsClose(-0.15, Order(1e-9)));
    // The sides of the bar meet those of the arm at x = 0.5 ± 0.15/cos 30° ± 0.15 tan 30°.
    const double outer =
        0.15 / std::cos(std::numbers::pi / 6) + 0.15 * std::tan(std::numbers::pi / 6);
    CHECK_THAT(high.x(), IsClose(0.5 + outer, Order(1e-9)));
    CHECK_THAT(low.x(), IsClose(0.5 - outer, Order(1e-9)));
}

TEST_CASE("mesh contact: a ring on a peg keeps contacts on all sides", "[rigid]")
{
    const Shape ring = mesh(ring_mesh(0.3, 0.5, 0.25, 48));
    const std::vector<Shape> pegs = {Cylinder{0.295, 2}, mesh(ring_mesh(0.1, 0.295, 2, 48)),
                                     Capsule{0.295, 2}};
    for (std::size_t k = 0; k < pegs.size(); ++k) {
        CAPTURE(k);
        const auto touches = touches_of(ring, {}, pegs[k], {}, 0.02);
        REQUIRE(touches.size() >= 4);
        for (const Vector3d& side :
             {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 0, 1), Vector3d(0, 0, -1)}) {
            double most = -1;
            for (const Contact& t : touches)
                most = std::max(most, t.normal.dot(side));
            CHECK(most > 0.7);
        }
        for (const Contact& t : touches) {
            CHECK(std::abs(t.normal.y()) < 1e-6);
            CHECK(std::abs(t.gap - 0.005) <
                  0.003); // polygons with 48 sides are smaller by up to 0.3 (1 - cos 3.75°)
        }
    }
}

TEST_CASE("mesh contact: an aligned block on a block of its size is held along the face", "[rigid]")
{
    const TriangleMesh cube = dented_box({1, 1, 1});
    const Pose above{Matrix3d::Identity(), {0, 1 - 1e-3, 0}};
    const auto touches = touches_of(mesh(cube), above, mesh(box_mesh({1, 1, 1})), {}, 0.01);
    REQUIRE(touches.size() >= 4);
    Vector3d low = Vector3d::Constant(1e9), high = -low;
    // Corners lie on edges here, where the gradient is not along a face's normal.
    for (const Contact& t : touches) {
        CHECK_THAT(t.normal, IsClose(Vector3d(0, 1, 0), Order(1e-6)));
        low = low.cwiseMin(t.point);
        high = high.cwiseMax(t.point);
    }
    CHECK(low.x() < -0.4);
    CHECK(low.z() < -0.4);
    CHECK(high.x() > 0.4);
    CHECK(high.z() > 0.4);
}

TEST_CASE("mesh contact: tubes that cross touch where no vertex is near", "[rigid]")
{
    const Shape tube = mesh(ring_mesh(0.2, 0.3, 3, 48)); // has vertices only at its ends
    const Pose across = turned({0, 0, 1}, 90, {0, 0.1, 0.6 - 1e-3});
    const auto touches = touches_of(tube, {}, tube, across, 0.01);
    REQUIRE(!touches.empty());
    // The distance of facets lies between (0.3 + 0.3) cos 3.75° and 0.6.
    CHECK(deepest(touches) < 0.6 * (1 - std::cos(3.75 * std::numbers::pi / 180)));
    CHECK(deepest(touches) > -2e-3);
}
