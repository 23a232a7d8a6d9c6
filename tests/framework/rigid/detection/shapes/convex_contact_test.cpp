// SPDX-License-Identifier: MIT
// A drum on a table, and random pairs of convex shapes: pairs that are aligned up to rounding, and
// round shapes on a large box. RIGOR_FUZZ sets the number of random pairs of each test; 100000 is
// the full size.
#include "framework/rigid/contact_shapes.hpp"

#include "geometry/distance/separation.hpp"

#include <cstdlib>

using namespace rigor;
using namespace rigor::testing;

namespace {

unsigned pairs()
{
    const char* all = std::getenv("RIGOR_FUZZ");
    return all ? static_cast<unsigned>(std::strtoul(all, nullptr, 10)) : 2000;
}

// A solid, and the same solid as a shape whose distance has a closed form.
struct Solid {
    Shape shape, exact;
};

TriangleMesh prism_mesh(double radius, double height, int sides)
{
    return surface_of_revolution(
        {{0, -height / 2}, {radius, -height / 2}, {radius, height / 2}, {0, height / 2}}, sides);
}

Solid random_solid(Random& random)
{
    const auto length = [&] { return std::pow(10, random.uniform(-1, 1)); };
    const Vector3d size(length(), length(), length());
    switch (random.bits() % 5) {
    case 0:
        return {Box{size}, Box{size}};
    case 1:
        return {mesh(box_mesh(size)), Box{size}};
    case 2:
        return {Cylinder{size.x(), size.y()}, Cylinder{size.x(), size.y()}};
    case 3:
        return {mesh(prism_mesh(size.x(), size.y(), 12)), Cylinder{size.x(), size.y()}};
    default:
        return {Cone{size.x(), size.y()}, Cone{size.x(), size.y()}};
    }
}

Matrix3d quarter_turns(Random& random)
{
    Matrix3d R = Matrix3d::Identity();
    for (int i = 0; i < 4; ++i) {
        Matrix3d turn = Matrix3d::Zero(); // about a random axis by 90 degrees
        const int a = static_cast<int>(random.bits() % 3);
        turn(a, a) = 1;
        turn((a + 1) % 3, (a + 2) % 3) = -1;
        turn((a + 2) % 3, (a + 1) % 3) = 1;
        R = turn * R;
    }
    return R;
}

double distance_along(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b,
                      const Vector3d& n)
{
    const Vector3d low = pose_a * support(a.shape, -(pose_a.R.transpose() * n));
    const Vector3d high = pose_b * support(b.shape, pose_b.R.transpose() * n);
    return n.dot(low - high);
}

double distance_to(const Solid& solid, const Pose& pose, const Vector3d& x)
{
    return signed_distance(solid.exact, pose.R.transpose() * (x - pose.X)).distance;
}

} // namespace

TEST_CASE("convex contact: a cylinder touches a box with its face or its line or its rim",
          "[rigid]")
{
    const Box table{{4, 1, 4}};
    const Cylinder drum{0.5, 1.2};
    const auto standing = touches_of(drum, {Matrix3d::Identity(), {0.2, 1.1, 0}}, table, {}, 0.01);
    REQUIRE(standing.size() == 8);
    for (const Contact& t : standing) {
        CHECK_THAT(t.normal, IsExactly(Vector3d(0, 1, 0)));
        CHECK_THAT(t.gap, IsClose(0.0, Rounding(8, 2)));
        CHECK_THAT((t.point - Vector3d(0.2, 0.5, 0)).norm(), IsClose(0.5, Rounding(16)));
    }
    const auto lying = touches_of(drum, turned({0, 0, 1}, 90, {0, 1 - 1e-3, 0}), table, {}, 0.01);
    REQUIRE(lying.size() == 2);
    for (const Contact& t : lying) {
        CHECK_THAT(t.normal, IsClose(Vector3d(0, 1, 0), Rounding(16)));
        CHECK_THAT(t.gap, IsClose(-1e-3, Rounding(16, 2)));
        CHECK_THAT(std::abs(t.point.x()), IsClose(0.6, Rounding(16)));
    }
    // Beyond the edge of the table, the line of contact ends at the edge.
    const auto overhanging = touches_of(drum, turned({0, 0, 1}, 90, {2, 1, 0}), table, {}, 0.01);
    REQUIRE(overhanging.size() == 2);
    CHECK_THAT(std::max(overhanging[0].point.x(), overhanging[1].point.x()),
               IsClose(2.0, Rounding(16)));
    const double tilt = 30, s = std::sin(tilt * std::numbers::pi / 180),
                 c = std::cos(tilt * std::numbers::pi / 180);
    const auto tilted = touches_of(drum, turned({0, 0, 1}, tilt, {0, 1.5, 0}), table, {}, 0.3);
    REQUIRE(tilted.size() >= 1);
    CHECK_THAT(deepest(tilted), IsClose(1.0 - 0.6 * c - 0.5 * s, Rounding(64, 2)));
}

TEST_CASE("convex contact: shapes aligned up to rounding have no false touches", "[rigid]")
{
    unsigned touching = 0;
    const unsigned n = pairs();
    for (unsigned seed = 0; seed < n; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Solid a = random_solid(random), b = random_solid(random);
        // Faces, edges or corners are aligned up to `off`, a length of 1e-11 to 1e-6 m.
        const double off = std::pow(10, random.uniform(-11, -6));
        const auto turned_off = [&] {
            const Vector3d w = off * random.vector();
            return rotation_matrix(turn(w + Vector3d(1e-300, 0, 0), w.norm()));
        };
        const Matrix3d R = random.bits() % 2 ? random.rotation() : Matrix3d::Identity();
        Pose pose_a{R * quarter_turns(random) * turned_off(), {0, 0, 0}};
        const Pose pose_b{R * quarter_turns(random) * turned_off(), {0, 0, 0}};
        // Side by side along one axis, and aligned on some of the others.
        const Vector3d up = R.col(static_cast<int>(random.bits() % 3));
        pose_a.X = off * random.vector();
        for (int i = 0; i < 3; ++i) {
            const Vector3d axis = R.col(i);
            if (std::abs(axis.dot(up)) > 0.5 || random.bits() % 3 == 0) continue;
            const double side = random.bits() % 2 ? 1 : -1; // faces flush on this side
            const double of_a =
                axis.dot(pose_a.R * support(a.shape, pose_a.R.transpose() * (side * axis)));
            const double of_b =
                axis.dot(pose_b.R * support(b.shape, pose_b.R.transpose() * (side * axis)));
            pose_a.X += (of_b - of_a) * axis;
        }
        pose_a.X -= distance_along(a, pose_a, b, pose_b, up) * up;
        pose_a.X += off * random.uniform(-1, 1) * up;
        const double size = reach_along(a.shape, {1, 0, 0}) + reach_along(a.shape, {0, 1, 0}) +
                            reach_along(b.shape, {1, 0, 0}) + reach_along(b.shape, {0, 1, 0});
        const double smaller = 0.05;
        const auto touches = touches_of(a.shape, pose_a, b.shape, pose_b, 0.01 * smaller);
        touching += !touches.empty();
        for (const Contact& t : touches) {
            // No touch is deeper than the shapes overlap along its normal, and its point is at both
            // surfaces.
            const double least = distance_along(a, pose_a, b, pose_b, t.normal);
            const double outside =
                std::max(distance_to(a, pose_a, t.point), distance_to(b, pose_b, t.point));
            CAPTURE(a.shape.index(), b.shape.index(), t.gap, least, outside, size);
            REQUIRE(t.gap >= least - 1e-6 * size);
            REQUIRE(t.gap > -1e-4);
            REQUIRE(outside < 1e-3 * size);
        }
    }
    REQUIRE(touching > n / 2);
}

TEST_CASE("convex contact: a round shape touches a large box where it is nearest", "[rigid]")
{
    const std::vector<std::pair<double, Shape>> round = {{0.4, Ellipsoid{{0.5, 0.3, 0.4}}},
                                                         {0.4, Cone{0.4, 0.9}},
                                                         {0.4, Cylinder{0.35, 0.8}},
                                                         {0.5, Cylinder{0.5, 0.05}},
                                                         {0.5, Ellipsoid{{0.5, 0.5, 0.05}}}};
    const Shape box = Box{{20, 2, 20}};
    for (unsigned seed = 0; seed < pairs(); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const auto& [radius, shape] = round[seed % round.size()];
        Pose pose{random.rotation(), {random.uniform(-5, 5), 0, random.uniform(-5, 5)}};
        const double lowest = reach_along(shape, pose.R.transpose() * Vector3d(0, -1, 0));
        const double gap =
            radius * std::copysign(std::pow(10, random.uniform(-8, -1.5)), random.uniform(-1, 1));
        pose.X.y() = 1 + lowest + gap;
        const auto touches = touches_of(shape, pose, box, {}, 0.1);
        REQUIRE(!touches.empty());
        const Contact* deepest = &touches[0];
        for (const Contact& t : touches)
            if (t.gap < deepest->gap) deepest = &t;
        // the exact lowest point, where the normal is unique
        const Vector3d exact = pose * support(shape, pose.R.transpose() * Vector3d(0, -1, 0));
        double off = 1e300;
        for (const Contact& t : touches)
            off = std::min(off, std::hypot(t.point.x() - exact.x(), t.point.z() - exact.z()));
        const double wrong_gap = std::abs(deepest->gap - gap);
        CAPTURE(shape.index(), touches.size(), gap);
        REQUIRE_THAT(off, IsClose(0.0, Order(1e-6 * radius)));
        REQUIRE_THAT(wrong_gap, IsClose(0.0, Order(1e-6 * radius)));
    }
}

TEST_CASE("contact: the nearest points of a box and a cylinder lie on both", "[rigid]")
{
    for (unsigned seed = 0; seed < pairs(); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const double r = std::pow(10, random.uniform(-2, 2)), side = 160 * r;
        const Shape box = Box{{side, 4 * r, side}}, cylinder = Cylinder{r, 1.2 * r};
        const Matrix3d R = rotation_matrix(turn({0, 0, 1}, random.uniform(0, 7))) *
                           rotation_matrix(turn({1, 0, 0}, std::numbers::pi / 2));
        const double gap = r * random.uniform(-1, 1) * std::pow(10, random.uniform(-16, -13));
        const Pose pose{R, {random.uniform(-0.3, 0.3) * side, 3 * r + gap, 0}};
        const Pose of_box{R.transpose(), -(R.transpose() * pose.X)};
        const Separation nearest = separation(box, of_box, cylinder, 1e9);
        const double to_1 = signed_distance(box, pose * nearest.point1).distance;
        const double to_2 = signed_distance(cylinder, nearest.point2).distance;
        CAPTURE(r, gap, nearest.distance);
        REQUIRE_THAT(to_1, IsClose(0.0, Order(1e-4 * r)));
        REQUIRE_THAT(to_2, IsClose(0.0, Order(1e-4 * r)));
    }
}

TEST_CASE("contact: a lying cylinder touches a large box along its lowest line", "[rigid]")
{
    for (unsigned seed = 0; seed < pairs(); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const double r = std::pow(10, random.uniform(-2, 2)), length = r * random.uniform(0.05, 10);
        const double side = r * std::pow(10, random.uniform(1.5, 2.5));
        const double gap =
            r * std::copysign(std::pow(10, random.uniform(-16, -2)), random.uniform(-1, 1));
        const auto place = [&] { return random.uniform(-0.3, 0.3) * side; };
        const Matrix3d R = rotation_matrix(turn({0, 1, 0}, random.uniform(0, 7))) *
                           rotation_matrix(turn({1, 0, 0}, std::numbers::pi / 2)) *
                           rotation_matrix(turn({0, 1, 0}, random.uniform(0, 7)));
        const Pose pose{R, {place(), 3 * r + gap, place()}};
        const auto touches = touches_of(Cylinder{r, length}, pose, Box{{side, 4 * r, side}}, {}, r);
        REQUIRE(touches.size() >= 2);
        const Vector3d axis = R.col(1);
        for (const Contact& t : touches) {
            const Vector3d d = t.point - pose.X;
            const double off =
                std::hypot(d.x() - d.dot(axis) * axis.x(), d.z() - d.dot(axis) * axis.z());
            CAPTURE(r, length, side, gap);
            REQUIRE_THAT(off, IsClose(0.0, Order(1e-4 * r)));
            REQUIRE_THAT(t.gap - gap, IsClose(0.0, Order(1e-4 * r)));
        }
    }
}
