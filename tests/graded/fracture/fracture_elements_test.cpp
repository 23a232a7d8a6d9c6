// SPDX-License-Identifier: MIT
// A7.6: a crack through a vertex cuts elements.
#include "element_laws.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

namespace {

void check_unchanged(const TetrahedralMesh& mesh, int vertex, const Vector3d& n)
{
    const SplitMesh result = split_element(mesh, vertex, n);
    check_split(mesh, result);
    check_count(vertex_count(result.mesh), vertex_count(mesh), "vertices");
    check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh), "tetrahedra");
}

// A vertex with tetrahedra left and right of x = 1, or -1 if there is none.
int two_sided_vertex(const TetrahedralMesh& mesh)
{
    for (int v = 0; v < vertex_count(mesh); ++v) {
        bool left = false, right = false;
        for (int t = 0; t < tetrahedron_count(mesh); ++t)
            if (corner_of(mesh.tetrahedra[t], v) < 4)
                (center(mesh, t).x() < 1 ? left : right) = true;
        if (left && right) return v;
    }
    return -1;
}

} // namespace

TEST_CASE("fracture: a plane through two vertices halves a tetrahedron", "[A7.6][fracture]")
{
    // the plane goes through 0 and 3, and through the middle of the edge between 1 and 2
    everywhere(unit_tetrahedron(), [](const Placed& at) {
        for (const double sign : {1.0, -1.0}) {
            const SplitMesh result =
                cut_at(at.mesh, at.vertex[0], sign * at.R * Vector3d(1, -1, 0).normalized());
            check_count(tetrahedron_count(result.mesh), 2, "tetrahedra");
            check_count(vertex_count(result.mesh), 8, "vertices");
            check_piece_volumes(result.mesh, std::vector<double>(2, std::pow(at.length, 3) / 12),
                                Rounding(16, volume_scale(at.mesh)));
        }
    });
}

TEST_CASE("fracture: a plane through one vertex cuts off a corner", "[A7.6][fracture]")
{
    // The plane 2x = y + z cuts the edges from 1 to 2 and from 1 to 3 at two thirds of their length
    // from vertex 1.
    everywhere(unit_tetrahedron(), [](const Placed& at) {
        const SplitMesh result =
            cut_at(at.mesh, at.vertex[0], at.R * Vector3d(2, -1, -1).normalized());
        check_count(tetrahedron_count(result.mesh), 3, "tetrahedra");
        check_count(vertex_count(result.mesh), 4 + 5, "vertices");
        const double whole = std::pow(at.length, 3) / 6, corner = 2.0 / 3 * 2 / 3 * whole;
        check_piece_volumes(result.mesh, std::vector{corner, whole - corner},
                            Rounding(32, volume_scale(at.mesh)));
    });
}

TEST_CASE("fracture: a vertex near the plane counts as on it", "[A7.6][fracture]")
{
    // class B: the plane goes through 0, with vertex 3 above it by a little less and a little more
    // than 0.05 of the edge of √2
    const auto tilted = [](double height) {
        const double h = height * std::numbers::sqrt2, a = std::sqrt((1 - h * h) / 2);
        return Vector3d(a, -a, h);
    };
    for (const double near : {0.0499999, -0.0499999, 0.01}) {
        CAPTURE(near);
        const SplitMesh result = cut_at(unit_tetrahedron(), 0, tilted(near));
        check_count(tetrahedron_count(result.mesh), 2, "tetrahedra");
        check_count(vertex_count(result.mesh), 8, "vertices");
    }
    for (const double off : {0.0500001, -0.0500001, 0.1}) {
        CAPTURE(off);
        const SplitMesh result = cut_at(unit_tetrahedron(), 0, tilted(off));
        check_count(tetrahedron_count(result.mesh), 3, "tetrahedra");
        check_count(vertex_count(result.mesh), 9, "vertices");
    }
}

TEST_CASE("fracture: a plane beside all tetrahedra of the vertex changes nothing",
          "[A7.6][fracture]")
{
    const double root3 = std::numbers::sqrt3;
    for (const double sign : {1.0, -1.0}) {
        check_unchanged(unit_tetrahedron(), 0, sign * Vector3d(1, 1, 1) / root3);
        check_unchanged(unit_tetrahedron(), 0, sign * Vector3d::UnitZ()); // along a face
        check_unchanged(block(2, 2, 2), 0, sign * Vector3d(1, 2, 2) / 3);
        check_unchanged(block(2, 2, 2), block_vertex(2, 2, 1, 1, 2), sign * Vector3d::UnitZ());
    }
    // vertex 3 is below the plane by less than 0.05 of the longest edge
    check_unchanged(unit_tetrahedron(), 0, Vector3d(1, 1, -0.06).normalized());
}

TEST_CASE("fracture: a neighbour is halved with the edge that it shares", "[A7.6][fracture]")
{
    // The plane goes through 0, 3 and the middle of the edge 1 2, which the second tetrahedron has
    // too. That one is cut, but does not come apart, since only vertex 0 is doubled.
    everywhere(two_tetrahedra(), [](const Placed& at) {
        const SplitMesh result =
            cut_at(at.mesh, at.vertex[0], at.R * Vector3d(1, -1, 0).normalized());
        check_count(tetrahedron_count(result.mesh), 4, "tetrahedra");
        check_count(vertex_count(result.mesh), 5 + 1 + 1, "vertices");
        check_count(piece_count(result.mesh), 1, "pieces");
        std::vector<int> parents = sorted(result.parents);
        REQUIRE_THAT(parents, IsExactly(std::vector{0, 0, 1, 1}));
    });
}

TEST_CASE("fracture: a tetrahedron beside the vertex is halved at each of its cut edges",
          "[A7.6][fracture]")
{
    // A tetrahedron has an inner vertex 4, near its face 1 2 3, and three of its four parts meet at
    // vertex 0. The fourth part, 1 2 3 4, does not have vertex 0. A plane that separates one of its
    // vertices cuts three of its edges, and one that separates two cuts four.
    const TetrahedralMesh whole = {
        {{0, 0, 1}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, {0.05, 0.02, 0.3}},
        {{1, 2, 4, 0}, {2, 3, 4, 0}, {3, 1, 4, 0}, {1, 2, 3, 4}}};
    std::set<int> counts; // how many edges of the fourth part were cut
    everywhere(whole, [&](const Placed& at) {
        for (int i = 0; i < 24; ++i) {
            CAPTURE(i);
            const double angle = 0.1 + i * std::numbers::pi / 12;
            const Vector3d n =
                at.R * Vector3d(std::cos(angle), std::sin(angle), 0.2 * (i % 3 - 1)).normalized();
            std::map<int, double> h = heights(at.mesh, at.vertex[0], n).of;
            int edges = 0;
            for (int a = 1; a <= 4; ++a)
                for (int b = 1; b < a; ++b)
                    edges += h.at(at.vertex[a]) * h.at(at.vertex[b]) < 0;
            const SplitMesh result = cut_at(at.mesh, at.vertex[0], n);
            const auto halves =
                std::count(result.parents.begin(), result.parents.end(), at.tetrahedron[3]);
            check_that(halves > edges, "each cut edge adds a part at least");
            counts.insert(edges);
        }
    });
    check_that(counts.contains(3) && counts.contains(4),
               "cases with three and with four cut edges");
}

TEST_CASE("fracture: a plane along faces cuts no tetrahedron", "[A7.6][fracture]")
{
    const TetrahedralMesh cube = block(4, 4, 4);
    for (const Vector3d& n : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, -1)}) {
        CAPTURE(n);
        const SplitMesh result = cut_at(cube, block_vertex(4, 4, 2, 2, 2), n);
        check_count(tetrahedron_count(result.mesh), tetrahedron_count(cube), "tetrahedra");
        check_count(vertex_count(result.mesh), vertex_count(cube) + 1,
                    "vertices"); // the rim stays closed
    }
}

TEST_CASE("fracture: every plane through its middle halves an octahedron", "[A7.6][fracture]")
{
    for (const Vector3d& n : {Vector3d(1, 2, 3), Vector3d(-2, 1, 4), Vector3d(1, 1, -1),
                              Vector3d(3, 0, 4), Vector3d(0, 1, 0)}) {
        CAPTURE(n);
        const SplitMesh result = cut_at(octahedron(), 0, n.normalized());
        check_count(piece_count(result.mesh), 2, "pieces");
        check_piece_volumes(result.mesh, std::vector{2.0 / 3, 2.0 / 3}, Rounding(64, 1));
    }
}

TEST_CASE("fracture: the area of a crack through an octahedron", "[A7.6][fracture]")
{
    // the plane x + y + z = 0 meets the edges in their middles: a regular hexagon of side 1/√2
    const SplitMesh result = cut_at(octahedron(), 0, Vector3d(1, 1, 1).normalized());
    check_count(vertex_count(result.mesh), 6 + 2 * 7, "vertices");
    const double hexagon = 1.5 * std::numbers::sqrt3 / 2;
    REQUIRE_THAT(surface_areas(result.mesh).cracks, IsClose(2 * hexagon, Rounding(64, 1)));
}

TEST_CASE("fracture: cuts at the vertices of a section break a bar there", "[A7.6][fracture]")
{
    // Cuts at one vertex after another that still has matter on both sides. Two cuts may be enough,
    // four always are.
    SplitMesh bar;
    bar.mesh = block(2, 1, 1);
    int cuts = 0;
    for (int next = two_sided_vertex(bar.mesh); next >= 0; next = two_sided_vertex(bar.mesh)) {
        check_count(piece_count(bar.mesh), 1, "pieces");
        bar = cut_at(bar.mesh, next, Vector3d::UnitX());
        check_count(tetrahedron_count(bar.mesh), 12, "tetrahedra");
        check_that(++cuts <= 4, "the bar is in two pieces after four cuts at most");
    }
    check_count(vertex_count(bar.mesh), 16, "vertices");
    check_piece_volumes(bar.mesh, std::vector{1.0, 1.0}, Rounding(16, 1));
}

TEST_CASE("fracture: a cut keeps volume and center and inverts nothing",
          "[A7.6][fracture][property]")
{
    for (Random random : seeds(60)) {
        const TetrahedralMesh mesh = jiggled(block(2, 2, 2), random);
        const int vertex = random_index(random, mesh.vertices.size());
        const Vector3d n = random.unit_vector();
        const Heights h = heights(mesh, vertex, n);
        if (h.margin < 1e-6) continue; // too close to call
        bool above = false, below = false;
        for (const auto& [v, height] : h.of) {
            above |= height > 0;
            below |= height < 0;
        }
        if (above && below)
            cut_at(mesh, vertex, n);
        else
            check_unchanged(mesh, vertex, n);
    }
}

TEST_CASE("fracture: cuts upon cuts keep what one cut keeps", "[A7.6][fracture][property]")
{
    for (Random random : seeds(8)) {
        TetrahedralMesh mesh = jiggled(block(2, 2, 1), random);
        for (int cuts = 0; cuts < 8; ++cuts) {
            CAPTURE(cuts);
            const int vertex = random_index(random, mesh.vertices.size());
            const SplitMesh result = split_element(mesh, vertex, random.unit_vector());
            check_matter(mesh, result);
            mesh = result.mesh;
        }
    }
}

TEST_CASE("fracture: the way a mesh is numbered does not matter to where it is cut",
          "[A7.6][fracture][property]")
{
    for (Random random : seeds(20)) {
        const TetrahedralMesh mesh = jiggled(block(2, 2, 1), random);
        const int vertex = random_index(random, mesh.vertices.size());
        const Vector3d n = random.unit_vector();
        if (heights(mesh, vertex, n).margin < 1e-6) continue; // too close to call
        const Renumbered other = renumbered(mesh, random);
        // the second normal points the other way
        const SplitMesh one = split_element(mesh, vertex, n);
        const SplitMesh two = split_element(other.mesh, other.vertex[vertex], -n);
        check_count(vertex_count(two.mesh), vertex_count(one.mesh), "vertices");
        check_count(piece_count(two.mesh), piece_count(one.mesh), "pieces");
        check_piece_volumes(two.mesh, piece_volumes(one.mesh), Rounding(256, 4));
        REQUIRE_THAT(surface_areas(two.mesh).cracks,
                     IsClose(surface_areas(one.mesh).cracks, Rounding(256, 4)));
    }
}

TEST_CASE("fracture: a large mesh is cut at one vertex", "[A7.6][fracture]")
{
    const TetrahedralMesh cube = block(16, 16, 16); // 24576 tetrahedra
    const SplitMesh result =
        split_element(cube, block_vertex(16, 16, 8, 8, 8), Vector3d(1, 2, 3).normalized());
    check_that(vertex_count(result.mesh) > vertex_count(cube) + 1,
               "new vertices on the edges that the plane cuts");
    REQUIRE_THAT(volume(result.mesh), IsClose(4096.0, Rounding(24576, 4096))); // 24576 summands
}

} // namespace rigor::testing
