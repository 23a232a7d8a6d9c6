// SPDX-License-Identifier: MIT
// A7.6: a crack through a vertex cuts elements.
#include "fracture_laws.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

namespace {

constexpr double snap_distance = 0.05; // fraction of the longest edge, as in the header

// Heights above the plane of the vertices of all tetrahedra that have `vertex`. A vertex that
// counts as on the plane has the height 0. `margin` is the least distance of a height from the
// threshold where this flips, as a fraction of the longest edge.
struct Heights {
    std::map<int, double> of;
    double margin = 1;
};

Heights heights(const TetrahedralMesh& mesh, int vertex, const Vector3d& n)
{
    Heights result;
    double longest = 0;
    for (const Tetrahedron& t : mesh.tetrahedra)
        if (corner_of(t, vertex) < 4)
            for (int a : t) {
                result.of[a] = n.dot(mesh.vertices[a] - mesh.vertices[vertex]);
                for (int b : t)
                    longest = std::max(longest, (mesh.vertices[a] - mesh.vertices[b]).norm());
            }
    for (auto& [v, h] : result.of) {
        result.margin = std::min(result.margin, std::abs(std::abs(h) / longest - snap_distance));
        if (std::abs(h) < snap_distance * longest) h = 0;
    }
    return result;
}

// Checks that new vertices lie on exactly those edges of the vertex's tetrahedra that the plane
// cuts, and at the right place on them.
void check_new_vertices(const TetrahedralMesh& mesh, const SplitMesh& result, int vertex,
                        const Vector3d& n)
{
    const std::map<int, double> h = heights(mesh, vertex, n).of;
    std::map<std::array<int, 2>, double> expected; // where each edge a < b is cut
    for (const Tetrahedron& t : mesh.tetrahedra)
        if (corner_of(t, vertex) < 4)
            for (int a : t)
                for (int b : t)
                    if (a < b && h.at(a) * h.at(b) < 0)
                        expected[{a, b}] = h.at(a) / (h.at(a) - h.at(b));

    std::set<std::array<int, 2>> found;
    for (const auto& [first, second, t] : result.origins) {
        if (first == second || t == 0 || t == 1) continue; // an old vertex
        const std::array<int, 2> edge = {std::min(first, second), std::max(first, second)};
        CAPTURE(edge[0], edge[1]);
        check_that(expected.contains(edge), "a new vertex lies on an edge that the plane cuts");
        INFO("where on its edge a new vertex is");
        REQUIRE_THAT(first < second ? t : 1 - t, IsClose(expected[edge], Rounding(256, 1)));
        found.insert(edge);
    }
    check_count(found.size(), expected.size(),
                "edges with a new vertex, those that the plane cuts");
}

// Checks that all matter around each copy of the vertex is on one side of the plane, and that both
// sides have a copy.
void check_sides(const TetrahedralMesh& mesh, const SplitMesh& result, int vertex,
                 const Vector3d& n)
{
    const std::map<int, double> h = heights(mesh, vertex, n).of;
    const auto height_of = [&](int v) { // height of a vertex of `result`
        const auto& [first, second, t] = result.origins[v];
        const bool is_old = first == second || t == 0 || t == 1;
        return is_old ? h.at(t == 1 ? second : first) : 0.0;
    };
    std::map<int, std::array<bool, 2>> sides; // matter above and below each copy
    for (const Tetrahedron& t : result.mesh.tetrahedra)
        for (int copy : t) {
            const VertexOrigin& origin = result.origins[copy];
            if (origin.first != vertex || origin.second != vertex) continue;
            for (int v : t) {
                sides[copy][0] |= height_of(v) > 0;
                sides[copy][1] |= height_of(v) < 0;
            }
        }
    int above = 0, below = 0;
    for (const auto& [copy, side] : sides) {
        CAPTURE(copy);
        check_that(side[0] != side[1],
                   "all matter around a copy of the vertex is above the plane, or all is below");
        ++(side[0] ? above : below);
    }
    check_that(above > 0, "a copy of the vertex has matter above the plane");
    check_that(below > 0, "a copy of the vertex has matter below the plane");
}

SplitMesh split(const TetrahedralMesh& mesh, int vertex, const Vector3d& n)
{
    const SplitMesh result = split_element(mesh, vertex, n);
    check_split(mesh, result);
    check_new_vertices(mesh, result, vertex, n);
    check_sides(mesh, result, vertex, n);
    return result;
}

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
                split(at.mesh, at.vertex[0], sign * at.R * Vector3d(1, -1, 0).normalized());
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
            split(at.mesh, at.vertex[0], at.R * Vector3d(2, -1, -1).normalized());
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
        const SplitMesh result = split(unit_tetrahedron(), 0, tilted(near));
        check_count(tetrahedron_count(result.mesh), 2, "tetrahedra");
        check_count(vertex_count(result.mesh), 8, "vertices");
    }
    for (const double off : {0.0500001, -0.0500001, 0.1}) {
        CAPTURE(off);
        const SplitMesh result = split(unit_tetrahedron(), 0, tilted(off));
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
            split(at.mesh, at.vertex[0], at.R * Vector3d(1, -1, 0).normalized());
        check_count(tetrahedron_count(result.mesh), 4, "tetrahedra");
        check_count(vertex_count(result.mesh), 5 + 1 + 1, "vertices");
        check_count(piece_count(result.mesh), 1, "pieces");
        std::vector<int> parents = sorted(result.parents);
        REQUIRE_THAT(parents, IsExactly(std::vector{0, 0, 1, 1}));
    });
}

TEST_CASE("fracture: a plane along faces cuts no tetrahedron", "[A7.6][fracture]")
{
    const TetrahedralMesh cube = block(4, 4, 4);
    for (const Vector3d& n : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, -1)}) {
        CAPTURE(n);
        const SplitMesh result = split(cube, block_vertex(4, 4, 2, 2, 2), n);
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
        const SplitMesh result = split(octahedron(), 0, n.normalized());
        check_count(piece_count(result.mesh), 2, "pieces");
        check_piece_volumes(result.mesh, std::vector{2.0 / 3, 2.0 / 3}, Rounding(64, 1));
    }
}

TEST_CASE("fracture: the area of a crack through an octahedron", "[A7.6][fracture]")
{
    // the plane x + y + z = 0 meets the edges in their middles: a regular hexagon of side 1/√2
    const SplitMesh result = split(octahedron(), 0, Vector3d(1, 1, 1).normalized());
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
        bar = split(bar.mesh, next, Vector3d::UnitX());
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
            split(mesh, vertex, n);
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
