// SPDX-License-Identifier: MIT
// The level sets of meshes, as the contacts of meshes use them.
#include "formulas/collision.hpp"
#include "framework/rigid/contact_shapes.hpp"
#include "geometry/level_sets/level_set.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/detection/narrow_phase.hpp"
#include "support/sweep.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("level set: a ball sampled on a grid of spacing h is off by h²/4 at most", "[rigid]")
{
    Sweep sweep;
    for (const int cells : {16, 32, 64}) {
        if (!sweep.takes_next()) continue;
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
        // Along an axis, linear interpolation is off by at most h²/8 times the second derivative.
        // Those of |p| along the three axes add up to 2/|p|, and |p| is at least 0.9.
        CHECK(worst <= h * h / 4 / 0.9);
        CHECK(worst > h * h / 8);                  // somewhere it is about half of that
        const TriangleMesh ball = icosphere(1, 5); // its faces are less than 5e-4 inside
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

TEST_CASE("level set: one that is no number is told by the body and when", "[rigid]")
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
