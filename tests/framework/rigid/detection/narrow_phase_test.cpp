// SPDX-License-Identifier: MIT
#include "framework/rigid/worlds.hpp"
#include "rigid/detection/narrow_phase.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double anything = 1e9;

std::vector<Contact> touches_of(const Shape& a, const Pose& pose_a, const Shape& b,
                                const Pose& pose_b, double reach = anything)
{
    std::vector<Contact> touches;
    find_shape_contacts(a, pose_a, b, pose_b, reach, touches);
    return touches;
}

Pose random_pose(Random& random, double spread)
{
    return {random.rotation(), spread * random.vector()};
}

std::vector<Vector3d> corners(const Box& box, const Pose& pose)
{
    std::vector<Vector3d> all;
    for (int i = 0; i < 8; ++i)
        all.push_back(
            pose *
            Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).cwiseProduct(box.size / 2));
    return all;
}

// The distance between two boxes along an axis, by projection of all corners.
double separation_along(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b,
                        const Vector3d& n)
{
    double low_a = 1e300, high_a = -1e300, low_b = 1e300, high_b = -1e300;
    for (const Vector3d& x : a) {
        low_a = std::min(low_a, n.dot(x));
        high_a = std::max(high_a, n.dot(x));
    }
    for (const Vector3d& x : b) {
        low_b = std::min(low_b, n.dot(x));
        high_b = std::max(high_b, n.dot(x));
    }
    return std::max(low_a - high_b, low_b - high_a);
}

// The largest separation over the 15 axes, by testing all of them.
double separation(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b)
{
    std::vector<Vector3d> axes;
    for (int i = 0; i < 3; ++i) {
        axes.push_back(pose_a.R.col(i));
        axes.push_back(pose_b.R.col(i));
        for (int j = 0; j < 3; ++j) {
            const Vector3d l = pose_a.R.col(i).cross(pose_b.R.col(j));
            if (l.norm() > 1e-3) axes.push_back(l.normalized());
        }
    }
    double best = -1e300;
    for (const Vector3d& axis : axes)
        best = std::max(best, separation_along(corners(a, pose_a), corners(b, pose_b), axis));
    return best;
}

// The distance from a point to the surface of a box, by testing a fine grid of points on its faces.
double distance_to_surface(const Box& box, const Vector3d& p, int n)
{
    double best = 1e300;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-0.5, 0.5})
            for (int i = 0; i <= n; ++i)
                for (int j = 0; j <= n; ++j) {
                    Vector3d x;
                    x[axis] = side;
                    x[(axis + 1) % 3] = static_cast<double>(i) / n - 0.5;
                    x[(axis + 2) % 3] = static_cast<double>(j) / n - 0.5;
                    best = std::min(best, (x.cwiseProduct(box.size) - p).norm());
                }
    return best;
}

} // namespace

TEST_CASE("narrow phase: spheres touch on the line of their centers", "[rigid]")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Pose a = random_pose(random, 1), b = random_pose(random, 1);
        const auto touches = touches_of(Sphere{0.4}, a, Sphere{0.7}, b);
        REQUIRE(touches.size() == 1);
        const Contact& t = touches[0];
        REQUIRE_THAT(t.gap, IsClose((a.X - b.X).norm() - 1.1, Rounding(8, 2)));
        REQUIRE_THAT(t.normal, IsClose(Vector3d((a.X - b.X).normalized()), Rounding(8)));
        REQUIRE_THAT((t.point - b.X).norm(), IsClose(0.7 + t.gap / 2, Rounding(16, 2)));
        REQUIRE(touches_of(Sphere{0.4}, a, Sphere{0.7}, b, t.gap).empty());
    }
    const auto concentric = touches_of(Sphere{1}, {}, Sphere{2}, {});
    REQUIRE(concentric.size() == 1);
    CHECK_THAT(concentric[0].normal, IsExactly(Vector3d(0, 1, 0)));
}

TEST_CASE("narrow phase: a sphere touches a box where the box is nearest", "[rigid]")
{
    const Box box{{1, 2, 3}};
    int inside = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Pose pose = random_pose(random, 3);
        const Vector3d c = random.vector().cwiseProduct(Vector3d(1, 1.6, 2.4));
        const bool is_inside = (c.cwiseAbs().array() < box.size.array() / 2).all();
        inside += is_inside;
        const auto touches = touches_of(Sphere{0.25}, {Matrix3d::Identity(), pose * c}, box, pose);
        REQUIRE(touches.size() == 1);
        const Contact& t = touches[0];
        const double distance = t.gap + 0.25; // signed distance of the center
        REQUIRE((distance < 0) == is_inside);
        REQUIRE(std::abs(std::abs(distance) - distance_to_surface(box, c, 200)) < 0.01);
        // The center, moved along the normal by the distance, lies on the surface.
        const Vector3d on = pose.R.transpose() * (pose * c - distance * t.normal - pose.X);
        REQUIRE_THAT((on.cwiseAbs() - box.size / 2).maxCoeff(), IsClose(0.0, Rounding(32, 6)));
        REQUIRE_THAT(t.normal.norm(), IsClose(1.0, Rounding(8)));
    }
    CHECK(inside > 5);
}

TEST_CASE("narrow phase: the touch of a sphere is on its own normal", "[rigid]")
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Pose sphere = random_pose(random, 2), other = random_pose(random, 1);
        for (const Shape& shape : {Shape(Sphere{0.5}), Shape(Box{{1, 1, 2}}), Shape(Plane{})}) {
            const Contact t = touches_of(Sphere{0.3}, sphere, shape, other).at(0);
            REQUIRE_THAT(Vector3d((t.point - sphere.X).cross(t.normal)),
                         IsClose(Vector3d(0, 0, 0), Rounding(32, 4)));
        }
    }
}

TEST_CASE("narrow phase: a box touches a plane with its vertices", "[rigid]")
{
    const Box box{{1, 2, 3}};
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Pose pose = random_pose(random, 1), plane = random_pose(random, 1);
        const auto touches = touches_of(box, pose, Plane{}, plane, 0);
        std::size_t below = 0;
        for (const Vector3d& corner : corners(box, pose)) {
            const double gap = (plane.R.transpose() * (corner - plane.X)).y();
            if (gap >= 0) continue;
            REQUIRE(below < touches.size());
            REQUIRE_THAT(touches[below].gap, IsClose(gap, Rounding(16, 4)));
            REQUIRE_THAT(touches[below].point, IsClose(corner, Rounding(16)));
            ++below;
        }
        REQUIRE(below == touches.size());
    }
}

TEST_CASE("narrow phase: boxes overlap by what the fifteen axes say", "[rigid]")
{
    int faces = 0, edges = 0;
    for (unsigned seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Box a{{1, 1.5, 2}}, b{{0.8, 1.2, 1}};
        const Pose pose_a = random_pose(random, 0.8), pose_b = random_pose(random, 0.8);
        const double exact = separation(a, pose_a, b, pose_b);
        const auto touches = touches_of(a, pose_a, b, pose_b, 0);
        REQUIRE(touches.empty() == (exact >= 0));
        if (touches.empty()) continue;
        double deepest = 0;
        for (const Contact& t : touches) {
            deepest = std::min(deepest, t.gap);
            REQUIRE_THAT(t.normal.norm(), IsClose(1.0, Rounding(16)));
            // The contact lies in the middle of the overlap, so at most half the overlap deep in
            // each box.
            REQUIRE(((pose_a.R.transpose() * (t.point - pose_a.X)).cwiseAbs() - a.size / 2)
                        .maxCoeff() <= -t.gap / 2 + 1e-9);
            REQUIRE(((pose_b.R.transpose() * (t.point - pose_b.X)).cwiseAbs() - b.size / 2)
                        .maxCoeff() <= -t.gap / 2 + 1e-9);
        }
        // A face may be preferred if it overlaps only a little more: one percent of half the
        // shortest edge.
        REQUIRE(deepest <= exact + 1e-12);
        REQUIRE(deepest >= exact - 0.0041 - 1e-12);
        // Moved apart by that distance along the normal, the boxes no longer overlap.
        const Pose apart{pose_a.R, pose_a.X - (deepest - 1e-9) * touches[0].normal};
        REQUIRE(separation(a, apart, b, pose_b) >= 0);
        (touches.size() == 1 ? edges : faces) += 1;
    }
    CHECK(faces > 50);
    CHECK(edges > 10);
}

TEST_CASE("narrow phase: seen from the other side the contacts are the same", "[rigid]")
{
    const std::vector<Shape> shapes = {Sphere{0.7}, Box{{1, 2, 1.5}}, Box{{2, 0.5, 1}}};
    for (unsigned seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Pose a = random_pose(random, 0.7), b = random_pose(random, 0.7);
        for (const Shape& first : shapes)
            for (const Shape& second : shapes) {
                const auto there = touches_of(first, a, second, b, 0.1),
                           back = touches_of(second, b, first, a, 0.1);
                REQUIRE(there.size() == back.size());
                double deepest = 1e300, deepest_back = 1e300;
                for (std::size_t i = 0; i < there.size(); ++i) {
                    deepest = std::min(deepest, there[i].gap);
                    deepest_back = std::min(deepest_back, back[i].gap);
                    REQUIRE_THAT(back[i].normal, IsClose(Vector3d(-there[0].normal), Rounding(64)));
                }
                if (!there.empty()) REQUIRE_THAT(deepest_back, IsClose(deepest, Rounding(64, 4)));
            }
    }
}

TEST_CASE("narrow phase: crossed cubes that touch at edges only have their contact there",
          "[rigid]")
{
    // Each cube stands on an edge along its own axis, and the upper one overlaps the lower one
    // slightly.
    const double half = std::sqrt(0.5), overlap = 1e-3;
    const Pose lower{rotation_matrix(turn({1, 0, 0}, std::numbers::pi / 4)), {0, 0, 0}};
    const Pose upper{rotation_matrix(turn({0, 0, 1}, std::numbers::pi / 4)),
                     {0, 2 * half - overlap, 0}};
    const Box cube{{1, 1, 1}};
    for (const Vector3d& corner : corners(cube, upper)) // no vertex lies in the other cube
        REQUIRE(((lower.R.transpose() * corner).cwiseAbs().array() > 0.5).any());
    const auto touches = touches_of(cube, upper, cube, lower, 0);
    REQUIRE(touches.size() == 1);
    CHECK_THAT(touches[0].gap, IsClose(-overlap, Rounding(16, 2)));
    CHECK_THAT(touches[0].normal, IsClose(Vector3d(0, 1, 0), Rounding(16)));
    CHECK_THAT(touches[0].point, IsClose(Vector3d(0, half - overlap / 2, 0), Rounding(16)));
}

TEST_CASE("narrow phase: aligned cubes have the four corners of their common face", "[rigid]")
{
    const auto touches =
        touches_of(Box{{1, 1, 1}}, {Matrix3d::Identity(), {0.25, 1, 0}}, Box{{1, 1, 1}}, {}, 0.1);
    REQUIRE(touches.size() == 4);
    Vector3d middle = Vector3d::Zero();
    for (const Contact& t : touches) {
        CHECK_THAT(t.gap, IsClose(0.0, Rounding(8, 1)));
        CHECK_THAT(t.normal, IsExactly(Vector3d(0, 1, 0)));
        middle += t.point / 4;
    }
    CHECK_THAT(middle, IsClose(Vector3d(0.125, 0.5, 0), Rounding(16)));
}

TEST_CASE("narrow phase: a compound body touches with the part that is there", "[rigid]")
{
    RigidBody dumbbell = body_of(Sphere{0.5}, {0, 0.4, 0});
    dumbbell.parts.push_back(dumbbell.parts[0]);
    dumbbell.parts[0].position = {-2, 0, 0};
    dumbbell.parts[1].position = {2, 0, 0};
    const World world =
        world_of({fixed(Plane{}, {}), dumbbell, fixed(Box{{1, 1, 1}}, {}, {2, 1.3, 0})});
    const std::vector<Pose> poses = {
        {}, {Matrix3d::Identity(), {0, 0.4, 0}}, {Matrix3d::Identity(), {2, 1.3, 0}}};
    std::vector<Contact> contacts;
    find_contacts(world, poses, 0, 1, 0, contacts);
    REQUIRE(contacts.size() == 2);
    CHECK_THAT(contacts[0].normal,
               IsExactly(Vector3d(0, -1, 0))); // from body 2 to body 1, which is the plane
    find_contacts(world, poses, 1, 2, 0, contacts);
    REQUIRE(contacts.size() == 3);
    CHECK_THAT(contacts[2].point, IsClose(Vector3d(2, 0.9, 0), Rounding(8)));
    CHECK_THAT(contacts[2].gap, IsClose(-0.1, Rounding(8, 2)));
}

TEST_CASE("narrow phase: no rounding decides which contact comes first", "[rigid]")
{
    Random random(5);
    const Matrix3d on_its_side = rotation_matrix(turn({0, 0, 1}, std::numbers::pi / 2));
    for (int i = 0; i < 200; ++i) {
        const Matrix3d R = rotation_matrix(turn({0, 1, 0}, random.uniform(0, 6)));
        const Vector3d X = {random.uniform(-9, 9), 0.5, random.uniform(-9, 9)};
        const World world =
            world_of({fixed(Box{{40, 1, 40}}, {}, {0.1, -0.5, 0.3}, quaternion_of(R)),
                      body_of(Box{{1, 2, 3}}, X, {}, quaternion_of(R * on_its_side))});
        const std::vector<Pose> poses = {pose_of(world.bodies[0].state),
                                         pose_of(world.bodies[1].state)};
        std::vector<Contact> contacts;
        find_contacts(world, poses, 0, 1, 0.1, contacts);
        REQUIRE(contacts.size() == 4); // all at the same height up to rounding
        for (int k = 0; k < 3; ++k)
            REQUIRE(contacts[k].point.x() <= contacts[k + 1].point.x());
    }
}
