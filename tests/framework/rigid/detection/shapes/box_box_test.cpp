// SPDX-License-Identifier: MIT
// Contacts of two boxes: all fifteen axes, and the look ahead at a joint.
#include "rigid/detection/shapes/box_box.hpp"

#include "framework/rigid/contact_shapes.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60; // [s]
const Material smooth{0, 0};

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

// Two boxes that meet at x = 0, whose tops both lie at y = 0.
World joint(const RigidBody& body)
{
    const Box tile{{10, 1, 10}};
    return world_of({fixed(tile, smooth, {-5, -0.5, 0}), fixed(tile, smooth, {5, -0.5, 0}), body});
}

} // namespace

TEST_CASE("box contact: boxes overlap by what the fifteen axes say", "[rigid]")
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

TEST_CASE("box contact: crossed cubes that touch at edges only have their contact there", "[rigid]")
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

TEST_CASE("box contact: aligned cubes have the four corners of their common face", "[rigid]")
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

TEST_CASE("box contact: boxes that will overlap have a contact before they do", "[rigid]")
{
    int met = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Box a{{1, 1.5, 2}}, b{{0.8, 1.2, 1}};
        const Pose pose_a{seed % 2 ? random.rotation() : Matrix3d::Identity(),
                          1.5 * random.vector()},
            pose_b{seed % 2 ? random.rotation() : Matrix3d::Identity(), 1.5 * random.vector()};
        const Vector3d move = random.vector();
        const Pose moved{pose_a.R, pose_a.X + move};
        if (separation(a, pose_a, b, pose_b) < 0 || separation(a, moved, b, pose_b) > -0.01)
            continue;
        ++met;
        std::vector<Contact> contacts;
        find_box_contacts(a, pose_a, b, pose_b, move, 10, contacts);
        REQUIRE(!contacts.empty());
        // They are apart along the normal, and the contact is where they overlap after the move.
        for (const Contact& c : contacts)
            CHECK(c.gap > -0.01);
        CHECK(deepest(contacts) + contacts[0].normal.dot(move) < 0);
    }
    CHECK(met > 100);
}

TEST_CASE("box contact: boxes that pass each other by their edges have no contact", "[rigid]")
{
    // Two of 20000 random cases in which the boxes are not opposite each other, and after the move
    // only a pair of edges keeps them apart.
    for (const unsigned seed : {10193u, 19291u}) {
        CAPTURE(seed);
        Random random(seed);
        const Box a{{1, 1.5, 2}}, b{{0.8, 1.2, 1}};
        const Pose pose_a{random.rotation(), 1.5 * random.vector()},
            pose_b{random.rotation(), 1.5 * random.vector()};
        const Vector3d move = random.vector();
        const Pose moved{pose_a.R, pose_a.X + move};
        REQUIRE(separation(a, moved, b, pose_b) > 0.01);
        for (const Pose& pose : {moved, pose_b})
            for (int i = 0; i < 3; ++i)
                REQUIRE(separation_along(corners(a, moved), corners(b, pose_b), pose.R.col(i)) < 0);
        std::vector<Contact> contacts;
        find_box_contacts(a, pose_a, b, pose_b, move, 10, contacts);
        CHECK(contacts.empty());
    }
}

TEST_CASE("box contact: a box that meets another edge to edge slides along its side", "[rigid]")
{
    // Gaps of 5 and 2 cm close in the same step. The box is so slow to turn that it does not.
    RigidBody box = body_of(Box{{1, 1, 1}}, {1.05, 1.02, 0}, smooth);
    set_mass(box, 1, 1e15 * Matrix3d::Identity());
    box.state.velocity = {-2, -2, 0};
    World world = world_of({fixed(Box{{1, 1, 1}}, smooth), box}, {0, 0, 0});
    for (int n = 1; n <= 5; ++n) {
        step(world, 0.1);
        CHECK_THAT(world.bodies[1].state.position,
                   IsClose(Vector3d(1, 1.02 - 0.2 * n, 0), Rounding(64, 1)));
    }
}

TEST_CASE("box contact: a box that slides over a joint does not run into it however slowly",
          "[rigid]")
{
    for (const double speed : {0.01, 0.1, 1.0, 10.0})
        for (const double angle : {0.0, 0.3})
            for (const bool is_ball : {false, true}) {
                const Shape shape = is_ball ? Shape(Sphere{0.5}) : Shape(Box{{1, 1, 1}});
                RigidBody body = body_of(shape, {-0.5 - 10.5 * speed * h, 0.5, 0}, smooth,
                                         turn({0, 1, 0}, angle));
                body.state.velocity = {speed, 0, 0};
                World world = joint(body);
                run(world, 30, h);
                CAPTURE(speed, angle, is_ball);
                CHECK_THAT(world.bodies[2].state.velocity,
                           IsClose(Vector3d(speed, 0, 0), Rounding(64 * 30, 10)));
            }
}

TEST_CASE("box contact: a box that lands at a joint keeps its speed along it", "[rigid]")
{
    for (int i = 0; i < 20; ++i) {
        const double x = -0.5 - 0.1 + 0.01 * i; // its center; the front edge is around the joint
        RigidBody box = body_of(Box{{1, 1, 1}}, {x, 0.51, 0}, smooth);
        box.state.velocity = {3, -1, 0};
        World world = joint(box);
        run(world, 5, h);
        CAPTURE(x);
        // The corners do not land at the same time. The tilt that this causes changes the speed a
        // little.
        CHECK(std::abs(world.bodies[2].state.velocity.x() - 3) <= 0.01);
    }
}

TEST_CASE("box contact: a box that flies at the side of another is stopped by it", "[rigid]")
{
    RigidBody box = body_of(Box{{1, 1, 1}}, {-1, 0.5, 0}, smooth);
    box.state.velocity = {3, 0, 0};
    World world = world_of({fixed(Box{{1, 1, 1}}, smooth, {0.6, 0.5, 0}), box}, {0, 0, 0});
    run(world, 30, h);
    CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(0.0, Rounding(1024, 3)));
}
