// SPDX-License-Identifier: MIT
// Contacts by level sets, one case at a time.
#include "formulas/collision.hpp"
#include "framework/rigid/contact_shapes.hpp"
#include "geometry/level_sets/level_set.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/detection/shapes/reduce_contacts.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

Pose turned(const Vector3d& axis, double degrees, const Vector3d& X)
{
    return {rotation_matrix(turn(axis, degrees * std::numbers::pi / 180)), X};
}

// A box with a dent in its top, which leaves its other surfaces unchanged. A dented box is handled
// by its level set.
TriangleMesh dented_box(const Vector3d& size)
{
    TriangleMesh box = box_mesh(size);
    const Vector3d middle(0, size.y() / 2, 0);
    const auto lid = std::find_if(box.triangles.begin(), box.triangles.end(), [&](const auto& t) {
        return box.vertices[t[0]].y() > 0 && box.vertices[t[1]].y() > 0 &&
               box.vertices[t[2]].y() > 0;
    });
    const auto [i, j, k] = *lid;
    const Vector3d center = (box.vertices[i] + box.vertices[j] + box.vertices[k]) / 3;
    box.vertices.push_back(center - Vector3d(0, 0.3 * size.y(), 0));
    *lid = {i, j, 8};
    box.triangles.push_back({j, k, 8});
    box.triangles.push_back({k, i, 8});
    return box;
}

} // namespace

TEST_CASE("level set: a ball sampled on a grid of spacing h is off by h²/4 at most", "[rigid]")
{
    for (const int cells : {16, 32, 64}) {
        LevelSet grid; // exact at the nodes
        const double h = grid.cell_size = 3.0 / cells;
        grid.size = {cells + 1, cells + 1, cells + 1};
        grid.origin = Vector3d::Constant(-1.5);
        for (int k = 0; k <= cells; ++k)
            for (int j = 0; j <= cells; ++j)
                for (int i = 0; i <= cells; ++i)
                    grid.distances.push_back((grid.origin + h * Vector3d(i, j, k)).norm() - 1);
        Random random(1);
        double worst = 0;
        for (int n = 0; n < 5000; ++n) {
            const Vector3d p = random.uniform(0.9, 1.1) * random.unit_vector();
            worst = std::max(worst, std::abs(sample_level_set(grid, p) - (p.norm() - 1)));
        }
        CAPTURE(cells, worst);
        // The curvature of |p| is 1/|p| perpendicular to p: three axes with h²/8 · 2/(3·0.9) each,
        // and a margin.
        CHECK(worst <= h * h / 4 / 0.9);
        CHECK(worst > h * h / 8);                  // and somewhere it is that large
        const TriangleMesh ball = icosphere(1, 5); // its error is 1 - cos(angle of half an edge)
        const LevelSet by_mesh = make_level_set(ball, cells);
        for (int n = 0; n < 1000; ++n) {
            const Vector3d p = random.uniform(0.9, 1.1) * random.unit_vector();
            const double d = by_mesh.cell_size;
            REQUIRE(std::abs(sample_level_set(by_mesh, p) - (p.norm() - 1)) <=
                    d * d / 4 / 0.9 + 5e-4);
        }
    }
}

TEST_CASE("level set: it is made when bodies first come near and for those that need one",
          "[rigid]")
{
    const Shape ring = mesh(ring_mesh(0.3, 0.5, 0.25, 24)), cross = mesh(cross_mesh(1, 0.3)),
                stone = mesh(voussoir_mesh(1, 1.3, 20, 0.5));
    World world = world_of({fixed(Plane{}, {}), body_of(ring, {0, 0, 0}), body_of(ring, {0, 0, 0}),
                            body_of(cross, {0, 0, 0}), body_of(stone, {0, 0, 0}),
                            body_of(Box{{1, 1, 1}}, {0, 0, 0}), body_of(stone, {0, 0, 0})});
    const auto counters_of = [&](int i, int j, const Vector3d& X) {
        std::vector<Pose> poses(world.bodies.size());
        poses[j].X = X;
        std::vector<Contact> contacts;
        Counters counters;
        find_contacts(world, poses, i, j, 0.01, contacts, counters);
        return counters;
    };
    // Against a plane only points are tested.
    CHECK(counters_of(0, 1, {0, 0.12, 0}).level_sets_built == 0);
    CHECK(counters_of(4, 5, {0, 0.6, 0}).level_sets_built == 0); // neither has a dent
    CHECK(counters_of(4, 6, {0, 0.3, 0}).level_sets_built == 0);
    CHECK(counters_of(1, 2, {5, 0, 0}).level_sets_built == 0); // too far apart
    const Counters first = counters_of(1, 2, {0, 0.25, 0});
    CHECK(first.level_sets_built == 1); // one for both bodies
    CHECK(first.level_set_samples > 0);
    CHECK(counters_of(1, 2, {0, 0.25, 0}).level_sets_built == 0); // it exists already
    // Only the cross needs a level set, not the box.
    CHECK(counters_of(3, 5, {0, 0.9, 0}).level_sets_built == 1);
}

TEST_CASE("mesh contact: crossed cubes that touch at edges only have their contact there",
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

TEST_CASE("mesh contact: bars that cross flat touch at the corners of their crossing", "[rigid]")
{
    const Shape cross =
        mesh(cross_mesh(2, 0.3)); // an arm along x of one on an arm along z of the other
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

TEST_CASE("mesh contact: a level set that is no number is told by the body and when", "[rigid]")
{
    TriangleMesh endless = cross_mesh(1, 0.3);
    for (Vector3d& v : endless.vertices)
        v *= 1e200; // its distances overflow
    World world = world_of({fixed(Mesh{std::make_shared<SolidMesh>(endless, "rock", 8)}, {}),
                            body_of(mesh(cross_mesh(1, 0.3)), {0, 0, 0})});
    world.bodies[0].name = "rock";
    world.time = 1.5;
    std::vector<Contact> contacts;
    try {
        find_contacts(world, {{}, {}}, 0, 1, 0.1, contacts);
        FAIL("a level set of nothing was taken for one");
    } catch (const NonFiniteState& e) {
        CHECK(e.body == "rock");
        CHECK(e.quantity == "signed distance of the level set");
        CHECK(e.time == 1.5);
    }
}

TEST_CASE("mesh contact: a ball in a corner touches both walls", "[rigid]")
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

TEST_CASE("mesh contact: a ball over the hole of a ring rests on three points", "[rigid]")
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

TEST_CASE("contact: a cylinder touches a box with its face or its line or its rim", "[rigid]")
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

TEST_CASE("contact: of many touches eight stay that span them and one of them is the deepest",
          "[rigid]")
{
    for (unsigned seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        std::vector<Contact> touches(1, Contact{{9, 9, 9}, {0, 1, 0}, -1}); // must be left alone
        double least = 1;
        for (int i = 0; i < 200; ++i) {
            const Vector3d p = random.vector();
            touches.push_back({{p.x(), 0, p.z()}, {0, 1, 0}, 0.1 * p.y() * p.y() - 0.02});
            least = std::min(least, touches.back().gap);
        }
        reduce_contacts(touches, 1, 0.1);
        REQUIRE(touches.size() == 1 + most_contacts);
        REQUIRE(touches[0].gap == -1);
        touches.erase(touches.begin());
        REQUIRE(deepest(touches) <= least + 1e-4);
        for (const double x : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) { // some contact is kept near each corner
                double nearest = 1e9;
                for (const Contact& t : touches)
                    nearest = std::min(nearest, (t.point - Vector3d(x, 0, z)).norm());
                REQUIRE(nearest < 1.2); // the square has side 2
            }
    }
}
