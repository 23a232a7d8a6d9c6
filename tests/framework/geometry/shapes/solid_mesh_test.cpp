// SPDX-License-Identifier: MIT
#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "support/close.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("solid mesh: bodies share one level set and it is made once", "[geometry]")
{
    const SolidMesh solid(cross_mesh(1, 0.3));
    int made = 0;
    const LevelSet& first = solid.level_set([&] { ++made; });
    const LevelSet& second = solid.level_set([&] { ++made; });
    CHECK(&first == &second);
    CHECK(made == 1);
}

TEST_CASE("solid mesh: a dent is found and the ball holds all vertices", "[geometry]")
{
    CHECK(SolidMesh(voussoir_mesh(1, 1.4, 30, 0.5)).is_convex());
    CHECK_FALSE(SolidMesh(angle_mesh({1, 1, 0.4}, 0.3)).is_convex());
    const SolidMesh box(box_mesh({1, 2, 2}));
    CHECK_THAT(box.radius(), IsClose(1.5, Rounding(4)));
    CHECK_THAT(box.volume(), IsClose(4.0, Rounding(16)));
}
