// SPDX-License-Identifier: MIT
// Contacts of spheres and boxes, and of bodies.
#include "rigid/detection/narrow_phase.hpp"

#include "framework/rigid/contact_shapes.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

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
