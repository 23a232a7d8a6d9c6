// SPDX-License-Identifier: MIT
// Contacts of spheres, capsules and tori with other shapes.
#include "framework/rigid/contact_shapes.hpp"

#include <algorithm>
#include <utility>

using namespace rigor;
using namespace rigor::testing;

namespace {

// The nearest points of the segments of two capsules, by alternate projection onto each segment.
std::pair<Vector3d, Vector3d> nearest_points(const Capsule& a, const Pose& pose_a, const Capsule& b,
                                             const Pose& pose_b)
{
    const auto projected = [](const Capsule& c, const Pose& pose, const Vector3d& x) -> Vector3d {
        const double along = pose.R.col(1).dot(x - pose.X);
        return pose.X + std::clamp(along, -c.height / 2, c.height / 2) * pose.R.col(1);
    };
    Vector3d x = pose_a.X, y = pose_b.X;
    for (int i = 0; i < 10000; ++i) {
        y = projected(b, pose_b, x);
        x = projected(a, pose_a, y);
    }
    return {x, y};
}

} // namespace

// A capsule is a segment with a radius: the gap is the distance of the segments minus both radii.
TEST_CASE("core contact: capsules touch where their segments are nearest", "[rigid]")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Capsule a{0.2, 1}, b{0.3, 1.4};
        const Pose pose_a = random_pose(random, 2), pose_b = random_pose(random, 2);
        const auto [x, y] = nearest_points(a, pose_a, b, pose_b);
        const double distance = (x - y).norm(), gap = distance - a.radius - b.radius;
        const auto touches = touches_of(a, pose_a, b, pose_b, gap + 1e-3);
        REQUIRE(!touches.empty());
        // The deepest contact that was kept is as deep, up to 1e-5 of their extent.
        REQUIRE_THAT(deepest(touches), IsClose(gap, Order(3e-5)));
        const Contact& t =
            *std::min_element(touches.begin(), touches.end(),
                              [](const Contact& s, const Contact& u) { return s.gap < u.gap; });
        REQUIRE_THAT(t.normal, IsClose(Vector3d((x - y) / distance), Order(0.01)));
        // The contact lies on the surface of the first capsule.
        REQUIRE_THAT(t.point, IsClose(Vector3d(x - a.radius * t.normal), Order(0.01)));
        REQUIRE(touches_of(a, pose_a, b, pose_b, gap - 1e-6).empty());
    }
}

TEST_CASE("core contact: a capsule that lies on another one is held at both ends", "[rigid]")
{
    const Capsule upper{0.2, 1}, lower{0.3, 2};
    const Pose above = turned({0, 0, 1}, 90, {0, 0.5 - 1e-3, 0}),
               below = turned({0, 0, 1}, 90, {0, 0, 0});
    const auto touches = touches_of(upper, above, lower, below, 0.01);
    double left = 0, right = 0;
    for (const Contact& t : touches) {
        CHECK_THAT(t.normal, IsClose(Vector3d(0, 1, 0), Rounding(64)));
        CHECK_THAT(t.gap, IsClose(-1e-3, Rounding(64, 1)));
        left = std::min(left, t.point.x());
        right = std::max(right, t.point.x());
    }
    CHECK_THAT(left, IsClose(-0.5, Order(1e-9)));
    CHECK_THAT(right, IsClose(0.5, Order(1e-9)));
}

TEST_CASE("core contact: a capsule across a round body has one contact", "[rigid]")
{
    // Another one beside it would hit as soon as the capsule rolls on to it.
    for (const Shape& ground :
         {Shape(Cylinder{0.5, 1}), Shape(Ellipsoid{{0.5, 0.7, 0.5}}), Shape(Torus{0.35, 0.15})})
        for (const double a : {0., 0.3, 2., 4.2969, 6.}) { // [degrees]; samples lie at 0 and 4.2969
            CAPTURE(a);
            const double angle = a * std::numbers::pi / 180;
            const Vector3d n(std::sin(angle), std::cos(angle), 0), t(n.y(), -n.x(), 0);
            const Pose above = turned({0, 0, 1}, 90 - a, 0.53 * n - 0.5 * angle * t),
                       below = turned({1, 0, 0}, 90, {0, 0, 0});
            const auto touches = touches_of(Capsule{0.03, 1.2}, above, ground, below, 0.02);
            REQUIRE(touches.size() == 1);
            CHECK_THAT(touches[0].gap, IsClose(0.0, Order(1e-7)));
            CHECK_THAT(touches[0].normal, IsClose(n, Order(1e-6)));
        }
}

TEST_CASE("core contact: a ball in a corner touches both walls", "[rigid]")
{
    const Shape corner = mesh(angle_mesh({2, 2, 2}, 0.3)); // its inside corner is at (-0.7, -0.7)
    const double r = 0.5;
    const auto touches =
        touches_of(Sphere{r}, {Matrix3d::Identity(), {-0.7 + r, -0.7 + r, 0.1}}, corner, {}, 0.01);
    REQUIRE(touches.size() == 2);
    for (const Contact& t : touches)
        CHECK_THAT(t.gap, IsClose(0.0, Order(1e-9)));
    const Vector3d sum = touches[0].normal + touches[1].normal;
    CHECK_THAT(sum, IsClose(Vector3d(1, 1, 0), Order(1e-9)));
}

TEST_CASE("core contact: a ball over the hole of a ring rests on three points", "[rigid]")
{
    const auto touches =
        touches_of(Sphere{0.5}, {Matrix3d::Identity(), {0, 0.55, 0}}, Torus{0.4, 0.15}, {}, 0.1);
    REQUIRE(touches.size() == 3);
    Vector3d sum = Vector3d::Zero();
    const double gap = std::hypot(0.4, 0.55) - 0.65;
    for (const Contact& t : touches) {
        CHECK_THAT(t.gap, IsClose(gap, Rounding(16, 2)));
        sum += t.normal;
    }
    CHECK_THAT(sum.x(), IsClose(0.0, Rounding(16, 3)));
    CHECK_THAT(sum.z(), IsClose(0.0, Rounding(16, 3)));
    CHECK(sum.y() > 0);
}
