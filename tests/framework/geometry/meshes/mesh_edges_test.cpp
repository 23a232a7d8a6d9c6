// SPDX-License-Identifier: MIT
#include "geometry/meshes/mesh_edges.hpp"

#include "geometry/meshes/generators.hpp"
#include "support/catch.hpp"
#include "support/close.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("mesh: the angle of facets is that of a polygonal wheel", "[geometry]")
{
    for (const double size : {1e-3, 1., 1e3})
        for (const int sides : {9, 12, 24, 360}) {
            CAPTURE(size, sides);
            const double angle = 2 * std::numbers::pi / sides;
            CHECK_THAT(facet_angle(surface_of_revolution(
                           {{0, -size}, {size, -size}, {size, size}, {0, size}}, sides)),
                       IsClose(angle, Rounding(64, sides)));
            CHECK_THAT(facet_angle(ring_mesh(0.5 * size, size, size, sides)),
                       IsClose(angle, Rounding(64, sides)));
        }
}

TEST_CASE("mesh: a body with flat faces and sharp edges has no facets", "[geometry]")
{
    CHECK(facet_angle(box_mesh({1, 2, 3})) == 0);
    CHECK(facet_angle(cross_mesh(1, 0.3)) == 0);
    CHECK(facet_angle(angle_mesh({1, 1, 0.2}, 0.2)) == 0);
    CHECK(facet_angle(icosphere(1, 0)) == 0); // an icosahedron bends by 42°
    CHECK(facet_angle(icosphere(1, 2)) > 0);
}
