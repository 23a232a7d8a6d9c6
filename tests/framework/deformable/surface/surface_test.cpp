// SPDX-License-Identifier: MIT
#include "deformable/surface/surface.hpp"

#include "deformable/fracture/inverted_elements.hpp"
#include "deformable/fracture/remesh.hpp"
#include "deformable/solid/pieces.hpp"
#include "formulas/fracture.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// The drawn triangles of an element at rest. @param element  negative for all elements
TriangleMesh drawn(const Deformable& solid, const EmbeddedSurface& surface, int element)
{
    TriangleMesh mesh;
    for (const EmbeddedPoint& p : surface.points) {
        Vector3d x = Vector3d::Zero();
        for (int i = 0; i < 4; ++i)
            x += p.weights[i] * solid.rest.vertices[solid.rest.tetrahedra[p.element][i]];
        mesh.vertices.push_back(x);
    }
    for (const EmbeddedTriangle& t : surface.triangles)
        if (element < 0 || t.element == element) mesh.triangles.push_back(t.points);
    return mesh;
}

struct Areas {
    double whole = 0, cracked = 0;
};

Areas areas(const TriangleMesh& mesh, const EmbeddedSurface& surface)
{
    Areas sum;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [i, j, k] = mesh.triangles[t];
        const Vector3d &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        (surface.triangles[t].is_crack ? sum.cracked : sum.whole) +=
            0.5 * (b - a).cross(c - a).norm();
    }
    return sum;
}

} // namespace

TEST_CASE("surface: of a whole solid it is the boundary of its mesh", "[deformable]")
{
    const Deformable solid = solid_of(ball_tetrahedra(1, 3), soft_material());
    const EmbeddedSurface surface = drawn_surface(solid);
    const TriangleMesh mesh = drawn(solid, surface, -1);
    CHECK_NOTHROW(check_mesh(mesh));
    CHECK_THAT(signed_volume(mesh), IsClose(totals(solid).volume, Rounding(100)));
    for (const EmbeddedTriangle& t : surface.triangles)
        CHECK(!t.is_crack);
}

TEST_CASE("surface: faces that came apart are cracks, all others are not", "[deformable]")
{
    Deformable solid = solid_of(block_tetrahedra({2, 1, 1}, {4, 2, 2}), soft_material());
    const double area = 2 * (2 * 1 + 1 * 1 + 2 * 1);
    std::vector<MeshFace> faces;
    for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t)
        for (int f = 0; f < 4; ++f) {
            bool is_middle = true;
            for (const int i : tetrahedron_faces[f])
                if (solid.rest.vertices[solid.rest.tetrahedra[t][i]].x() != 0) is_middle = false;
            if (is_middle) faces.push_back({t, f});
        }
    remesh(solid, split_along_faces(solid.rest, faces));
    const EmbeddedSurface surface = drawn_surface(solid);
    const TriangleMesh mesh = drawn(solid, surface, -1);
    const auto [whole, cracked] = areas(mesh, surface);
    CHECK_THAT(whole, IsClose(area, Rounding(100)));
    CHECK_THAT(cracked, IsClose(2.0, Rounding(100))); // both sides
    CHECK_THAT(signed_volume(mesh), IsClose(2.0, Rounding(100)));
}

TEST_CASE("surface: the parts of a cracked element close around their share of its volume",
          "[deformable]")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        TetrahedralMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
        for (Vector3d& x : mesh.vertices)
            x += 0.1 * random.vector();
        Deformable solid = solid_of(mesh, soft_material());
        solid.uncracked = solid.rest;
        Vector3d middle = Vector3d::Zero();
        for (const Vector3d& x : mesh.vertices)
            middle += x / 4;
        const int cracks = 1 + static_cast<int>(seed % 3);
        for (int k = 0; k < cracks; ++k)
            solid.cracks.push_back({0, middle + 0.05 * random.vector(), random.unit_vector()});
        remesh(solid, virtual_nodes(solid.uncracked, solid.cracks));
        const EmbeddedSurface surface = drawn_surface(solid);
        double sum = 0;
        for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t) {
            const double V = signed_volume(drawn(solid, surface, t));
            const double expected = solid.embedded.fractions[t] * tetrahedron_volume(mesh, 0);
            REQUIRE_THAT(V, IsClose(expected, Rounding(1000, 1)));
            sum += V;
        }
        REQUIRE_THAT(sum, IsClose(tetrahedron_volume(mesh, 0), Rounding(1000, 1)));
        REQUIRE(solid.rest.tetrahedra.size() >= 2);
    }
}

namespace {

// A block of 2 × 1 × 1 m. Its elements that cross the plane x = 0.1 and lie above y = lowest are
// cracked.
Deformable cracked_block(double lowest)
{
    Deformable solid = solid_of(block_tetrahedra({2, 1, 1}, {4, 4, 2}), soft_material());
    solid.uncracked = solid.rest;
    for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t) {
        Vector3d low = Vector3d::Constant(9), high = -low;
        for (const int i : solid.rest.tetrahedra[t]) {
            low = low.cwiseMin(solid.rest.vertices[i]);
            high = high.cwiseMax(solid.rest.vertices[i]);
        }
        if (low.x() < 0.1 && high.x() > 0.1 && low.y() > lowest)
            solid.cracks.push_back({t, Vector3d(0.1, 0, 0), Vector3d::UnitX()});
    }
    remesh(solid, virtual_nodes(solid.uncracked, solid.cracks));
    return solid;
}

} // namespace

TEST_CASE("surface: inside what virtual nodes left in one piece nothing is drawn", "[deformable]")
{
    const double area = 2 * (2 * 1 + 1 * 1 + 2 * 1);
    for (const double lowest : {-0.51, -0.01}) { // through the whole block, or to its middle
        CAPTURE(lowest);
        const Deformable solid = cracked_block(lowest);
        const EmbeddedSurface surface = drawn_surface(solid);
        const TriangleMesh mesh = drawn(solid, surface, -1);
        const auto [whole, cracked] = areas(mesh, surface);
        CHECK_THAT(whole, IsClose(area, Rounding(1000)));
        CHECK_THAT(cracked, IsClose(lowest < -0.5 ? 2.0 : 1.0, Rounding(1000))); // both sides
        CHECK_THAT(signed_volume(mesh), IsClose(2.0, Rounding(1000)));
        if (lowest > -0.5) continue;
        TriangleMesh apart = mesh;
        const std::vector<int> piece = pieces(solid);
        for (std::size_t i = 0; i < surface.points.size(); ++i)
            apart.vertices[i].x() += 9 * piece[surface.points[i].element];
        CHECK_NOTHROW(check_mesh(apart)); // each piece is closed, no face is repeated
    }
}

TEST_CASE("surface: cracks that do not meet leave open what no other element covers",
          "[deformable]")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = solid_of(block_tetrahedra({2, 1, 1}, {2, 1, 1}), soft_material());
        solid.uncracked = solid.rest;
        for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); t += 1 + (t % 2)) {
            Vector3d middle = Vector3d::Zero();
            for (const int i : solid.rest.tetrahedra[t])
                middle += solid.rest.vertices[i] / 4;
            solid.cracks.push_back({t, middle, random.unit_vector()});
        }
        remesh(solid, virtual_nodes(solid.uncracked, solid.cracks));
        const EmbeddedSurface surface = drawn_surface(solid);
        const TriangleMesh mesh = drawn(solid, surface, -1);
        CHECK_THAT(signed_volume(mesh), IsClose(2.0, Rounding(1000))); // closed
        CHECK_THAT(areas(mesh, surface).whole, IsClose(10.0, Rounding(1000)));
    }
}

TEST_CASE("surface: an inverted element that was separated is a crack all around", "[deformable]")
{
    constexpr int inverted = 40;
    for (const FractureMethod method :
         {FractureMethod::faces, FractureMethod::elements, FractureMethod::virtual_nodes}) {
        CAPTURE(static_cast<int>(method));
        Deformable solid = solid_of(block_tetrahedra({2, 1, 1}, {4, 2, 2}), soft_material());
        solid.fracture_method = method;
        const Areas before = areas(drawn(solid, drawn_surface(solid), -1), drawn_surface(solid));
        double inside = 0; // area of its faces that the block hides
        const auto neighbours = face_neighbours(solid.rest);
        for (int f = 0; f < 4; ++f) {
            const auto& [i, j, k] = tetrahedron_faces[f];
            const auto& t = solid.rest.tetrahedra[inverted];
            const Vector3d &a = solid.rest.vertices[t[i]], &b = solid.rest.vertices[t[j]],
                           &c = solid.rest.vertices[t[k]];
            if (neighbours[inverted][f] >= 0) inside += 0.5 * (b - a).cross(c - a).norm();
        }
        for (Vector3d& x : solid.positions)
            x = -x;
        solid.inverted_times.assign(solid.rest.tetrahedra.size(), 0.0);
        solid.inverted_times[inverted] = 1e9;
        ElementWorkspace work(solid);
        work.elements.strains(solid.positions, work.strains);
        World world;
        REQUIRE(separate_inverted_elements(solid, work, {}, world, 0.01));
        const EmbeddedSurface surface = drawn_surface(solid);
        const TriangleMesh mesh = drawn(solid, surface, -1);
        const Areas after = areas(mesh, surface);
        CHECK(inside > 0);
        CHECK_THAT(after.whole, IsClose(before.whole, Rounding(1000)));
        CHECK_THAT(after.cracked, IsClose(2 * inside, Rounding(1000)));
        CHECK_THAT(signed_volume(mesh), IsClose(totals(solid).volume, Rounding(1000)));
    }
}
