// SPDX-License-Identifier: MIT
// A7: on which side of a plane a tetrahedron is, in whatever order its corners stand and wherever
// the solid is, and which face is nearest where a small component of the normal decides.
#include "element_laws.hpp"
#include "formulas/fracture.hpp"
#include "fracture_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fracture_sides_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A tetrahedron with its corners in number n of the twelve orders that do not invert it.
Tetrahedron reordered(const Tetrahedron& t, int n)
{
    std::array<int, 4> order = {0, 1, 2, 3};
    for (int even = -1;; std::next_permutation(order.begin(), order.end())) {
        int inversions = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j)
                inversions += order[j] > order[i];
        if (inversions % 2 == 0 && ++even == n)
            return {t[order[0]], t[order[1]], t[order[2]], t[order[3]]};
    }
}

// The mesh moved by `offset`, with positive volumes, and with the corners of its first tetrahedron
// in order n.
TetrahedralMesh placed(TetrahedralMesh mesh, int n, const Vector3d& offset)
{
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        if (volume(mesh, t) < 0) std::swap(mesh.tetrahedra[t][2], mesh.tetrahedra[t][3]);
    mesh.tetrahedra[0] = reordered(mesh.tetrahedra[0], n);
    for (Vector3d& x : mesh.vertices)
        x += offset;
    return mesh;
}

// Cuts the mesh at vertex 0 along z = 0, from either side of the plane. Tetrahedron 1 must come
// off, with three new vertices.
void check_comes_off(const TetrahedralMesh& original)
{
    for (const Vector3d& offset : {Vector3d(0, 0, 0), Vector3d(4, -2, 8), Vector3d(4, -2, -8)})
        for (const double sign : {1.0, -1.0})
            for (int n = 0; n < 12; ++n) {
                CAPTURE(offset, sign, n);
                const TetrahedralMesh mesh = placed(original, n, offset);
                const SplitMesh result = split_element(mesh, 0, sign * Vector3d::UnitZ());
                check_split(mesh, result);
                check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh), "tetrahedra");
                check_count(vertex_count(result.mesh), vertex_count(mesh) + 3, "vertices");
                const double off = volume(mesh, 1);
                check_piece_volumes(result.mesh, sorted(std::vector{off, volume(mesh) - off}),
                                    Rounding(1024, 1));
            }
}

} // namespace

TEST_CASE("fracture: the vertices off the plane decide and not those near it", "[A7.6][fracture]")
{
    // The longest edge is √2 m. Vertex 3 is off the plane; 1 and 2 are near it, so much on the
    // other side that the center of tetrahedron 0 is there too.
    check_comes_off({{{0, 0, 0}, {1, 0, -0.06}, {0, 1, -0.06}, {0.3, 0.3, 0.1}, {0.3, 0.3, -0.6}},
                     {{0, 1, 2, 3}, {0, 1, 2, 4}}});
}

TEST_CASE("fracture: of a tetrahedron on the plane the center decides and no single vertex",
          "[A7.6][fracture]")
{
    // Tetrahedron 0 is near the plane, its center above it, and vertex 3 below it. Tetrahedron 1 is
    // below, on the face 0 1 3, and tetrahedron 2 above, on the face 0 1 2.
    check_comes_off(
        {{{0, 0, 0}, {1, 0, 0.03}, {0, 1, 0.03}, {0.6, 0.6, -0.04}, {0.5, 0.3, -1}, {0.3, 0.3, 1}},
         {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 2, 5}}});
}

TEST_CASE("fracture: a center as near to the plane as can be told decides", "[A7.6][fracture]")
{
    for (int power = 10; power <= 54; ++power)
        for (const double sign : {1.0, -1.0}) {
            CAPTURE(power, sign);
            // the mesh of the test above, but the center of tetrahedron 0 is at z = ±2^-power
            const double height = -0x1p-4 + sign * 4 * std::ldexp(1, -power);
            const TetrahedralMesh mesh = placed({{{0, 0, 0},
                                                  {1, 0, 0x1p-5},
                                                  {0, 1, 0x1p-5},
                                                  {0.6, 0.6, height},
                                                  {0.5, 0.3, -1},
                                                  {0.3, 0.3, 1}},
                                                 {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 2, 5}}},
                                                0, {0, 0, 0});
            const SplitMesh result = split_element(mesh, 0, Vector3d::UnitZ());
            const double off = volume(mesh, sign > 0 ? 1 : 2);
            check_piece_volumes(result.mesh, sorted(std::vector{off, volume(mesh) - off}),
                                Rounding(64, 1));
        }
}

TEST_CASE("fracture: a center however near to the plane decides", "[A7.6][fracture]")
{
    // Tetrahedron 0 has three vertices on the plane and vertex 3 below it, by 2^-power m. So its
    // center is on the side of tetrahedron 1, and tetrahedron 2 comes off.
    for (int power = 8; power <= 300; ++power) {
        CAPTURE(power);
        const TetrahedralMesh mesh = placed({{{0, 0, 0},
                                              {1, 0, 0},
                                              {0, 1, 0},
                                              {0.6, 0.6, std::ldexp(-1, -power)},
                                              {0.5, 0.3, -1},
                                              {0.3, 0.3, 1}},
                                             {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 2, 5}}},
                                            0, {0, 0, 0});
        for (const double sign : {1.0, -1.0}) {
            CAPTURE(sign);
            const SplitMesh result = split_element(mesh, 0, sign * Vector3d::UnitZ());
            check_split(mesh, result);
            check_count(tetrahedron_count(result.mesh), 3, "tetrahedra");
            const std::vector<int> piece = piece_labels(result.mesh);
            std::array<int, 3> piece_of{}; // by the tetrahedron of the mesh before
            for (std::size_t t = 0; t < 3; ++t)
                piece_of[result.parents[t]] = piece[t];
            check_that(piece_of[0] == piece_of[1], "the flat tetrahedron stays with the lower one");
            check_that(piece_of[0] != piece_of[2], "the upper tetrahedron comes off");
        }
    }
}

TEST_CASE("fracture: far from the origin the mean of the heights decides", "[A7.6][fracture]")
{
    // Tetrahedron 0 is near the plane, and its vertices 1 to 3 have heights of a few units above
    // vertex 0. All places are multiples of the unit, and the solid is as far from the origin as
    // such places are exact. Tetrahedron 1 is below it, and tetrahedron 2 above.
    for (Random random : seeds(400)) {
        const int power = 9 + random_index(random, 42); // the unit is 2^-power m
        const double unit = std::ldexp(1, -power);
        const int h1 = 1 + random_index(random, 3), h2 = 1 + random_index(random, 3);
        const int h3 = random_index(random, 7) - 3 - h1 - h2; // so that the sum is -3 … 3
        const double away = std::ldexp(1, 52 - power - random_index(random, 3));
        const int axis = random_index(random, 3), vertex = random_index(random, 2);
        const double sign = random.bits() % 2 == 0 ? 1 : -1;
        CAPTURE(unit, h1, h2, h3, away, axis, vertex, sign);
        TetrahedralMesh mesh = placed({{{0, 0, 0},
                                        {1, 0, h1 * unit},
                                        {0, 1, h2 * unit},
                                        {0.75, 0.75, h3 * unit},
                                        {0.5, 0.25, -1},
                                        {0.25, 0.25, 1}},
                                       {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 2, 5}}},
                                      random_index(random, 12), {0, 0, 0});
        for (Vector3d& x : mesh.vertices) { // the z axis becomes this one
            x = Vector3d(x[(2 - axis) % 3], x[(3 - axis) % 3], x[(4 - axis) % 3]);
            x += away * Vector3d(1, 1, 1);
        }
        const SplitMesh result = split_element(mesh, vertex, sign * Vector3d::Unit(axis));
        check_count(tetrahedron_count(result.mesh), 3, "tetrahedra");
        const std::vector<int> piece = piece_labels(result.mesh);
        std::array<int, 3> piece_of{}; // by the tetrahedron of the mesh before
        for (std::size_t t = 0; t < 3; ++t)
            piece_of[result.parents[t]] = piece[t];
        const int sum = h1 + h2 + h3 - 4 * (vertex == 1 ? h1 : 0); // above this vertex
        const bool is_upper = sum > 0 || (sum == 0 && sign > 0);
        check_that(piece_of[0] == piece_of[is_upper ? 2 : 1],
                   "the flat tetrahedron stays with the one on its side of the plane");
        check_that(piece_of[0] != piece_of[is_upper ? 1 : 2],
                   "the tetrahedron on the other side comes off");
    }
}

namespace {

// An edge from y = -1 to y = 1 with wedges, which are tetrahedra, at some of n angles around it,
// and a ring of tetrahedra around each of its ends, up to y = 2 and down to y = -2. Vertex 4 + i is
// at angle number i. Around each vertex of a wedge all tetrahedra are connected through faces, but
// two wedges may have nothing but the edge in common.
TetrahedralMesh wedges_around_edge(int n, const std::vector<int>& wedges)
{
    TetrahedralMesh mesh = {{{0, 1, 0}, {0, -1, 0}, {0, 2, 0}, {0, -2, 0}}, {}};
    const auto rim = [n](int i) { return 4 + i % n; };
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        mesh.vertices.push_back({std::cos(angle), 0, std::sin(angle)});
        mesh.tetrahedra.push_back({2, 0, rim(i), rim(i + 1)});
        mesh.tetrahedra.push_back({3, 1, rim(i), rim(i + 1)});
    }
    for (const int i : wedges)
        mesh.tetrahedra.push_back({0, 1, rim(i), rim(i + 1)});
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        if (volume(mesh, t) < 0) std::swap(mesh.tetrahedra[t][2], mesh.tetrahedra[t][3]);
    return mesh;
}

} // namespace

TEST_CASE("fracture: all tetrahedra of a cut edge are halved however they are connected",
          "[A7.6][fracture]")
{
    const std::vector<int> some[] = {
        {0, 2, 3, 5}, {0, 2, 4}, {1, 3, 5}, {0, 1, 3, 4}, {0, 1, 2, 3, 4, 5}};
    for (const std::vector<int>& wedges : some) {
        CAPTURE(wedges);
        everywhere(wedges_around_edge(6, wedges), [&](const Placed& solid) {
            const SplitMesh result =
                split_element(solid.mesh, solid.vertex[4], solid.R * Vector3d::UnitY());
            check_matter(solid.mesh, result);
            INFO("the edge has vertex 4 beside it, and all of its wedges are halved");
            check_count(tetrahedron_count(result.mesh), 12 + 2 * std::ssize(wedges), "tetrahedra");
        });
    }
}

TEST_CASE("fracture: wedges with an edge in common part where nothing else holds them",
          "[A7.5][fracture]")
{
    for (int n = 2; n <= 6; ++n) { // wedges, with as many gaps between them
        std::vector<int> wedges(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i)
            wedges[i] = 2 * i;
        everywhere(wedges_around_edge(2 * n, wedges), [&](const Placed& solid) {
            // both rings are cut between the wedges, so no face that is cut has the edge
            std::set<std::array<int, 3>> cut;
            for (int i = 0; i < n; ++i)
                for (const int end : {0, 1})
                    cut.insert(face_vertices(
                        {-1, solid.vertex[end], solid.vertex[2 + end], solid.vertex[4 + 2 * i + 1]},
                        0));
            std::vector<MeshFace> faces;
            for (int t = 0; t < tetrahedron_count(solid.mesh); ++t)
                for (int f = 0; f < 4; ++f)
                    if (cut.contains(face_vertices(solid.mesh.tetrahedra[t], f)))
                        faces.push_back({t, f});
            const SplitMesh result = split_along_faces(solid.mesh, faces);
            CAPTURE(n);
            check_definition(solid.mesh, faces, result);
            check_count(piece_count(result.mesh), n, "pieces, one for each wedge");
            // four vertices have n copies, and each vertex of the rim at a cut has three
            check_count(vertex_count(result.mesh), 4 * n + n + 3 * n, "vertices");
        });
    }
}

TEST_CASE("fracture: a solid with any holes parts along its faces", "[A7.5][fracture]")
{
    // Around an edge of such a solid there may be several fans of tetrahedra.
    for (Random random : seeds(60)) {
        TetrahedralMesh some = block(2, 2, 2);
        std::erase_if(some.tetrahedra, [&](const Tetrahedron&) { return random.bits() % 5 < 2; });
        const TetrahedralMesh mesh = parted(some, {}); // only faces hold it together
        const double chance = random.uniform(0, 0.4);
        std::vector<MeshFace> faces;
        for (int t = 0; t < tetrahedron_count(mesh); ++t)
            for (int f = 0; f < 4; ++f)
                if (random.uniform(0, 1) < chance) faces.push_back({t, f});
        check_definition(mesh, faces, split_along_faces(mesh, faces));
    }
}

TEST_CASE("fracture: an edge on the other side of an earlier crack stays whole", "[A7.6][fracture]")
{
    // Two tetrahedra with one face in common come apart there. The places of its edges are still
    // the same, but the edges are others.
    const TetrahedralMesh whole = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                                   {{0, 1, 2, 3}, {4, 1, 3, 2}}};
    const SplitMesh apart = split_along_faces(whole, {{0, 0}});
    check_count(vertex_count(apart.mesh), 8, "vertices of two tetrahedra that came apart");
    const int corner = apart.mesh.tetrahedra[0][0];
    // The plane has this corner and that at (0, 0, 1), and crosses the edge between the others.
    const SplitMesh result = split_element(apart.mesh, corner, Vector3d(1, -1, 0).normalized());
    check_count(tetrahedron_count(result.mesh), 3, "tetrahedra: one of the two is halved");
    // Where the mesh is whole, both are halved.
    const SplitMesh both = split_element(whole, 0, Vector3d(1, -1, 0).normalized());
    check_count(tetrahedron_count(both.mesh), 4, "tetrahedra: both are halved at the edge");
}

TEST_CASE("fracture: a tetrahedron beside the vertex has no side", "[A7.6][fracture]")
{
    // Three tetrahedra around an edge. The last one does not have vertex 0, but its vertices are
    // those of the other two, above the plane and below it.
    const double c = -0.5, s = std::sqrt(0.75);
    const TetrahedralMesh mesh = {{{1, 0, 0}, {c, s, 0}, {c, -s, 0}, {0, 0, 1}, {0, 0, -1}},
                                  {{1, 0, 3, 4}, {0, 2, 3, 4}, {2, 1, 3, 4}}};
    for (int i = 0; i < 36; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / 36;
        const Vector3d n = Vector3d(0.1, std::cos(angle), std::sin(angle)).normalized();
        CAPTURE(n);
        if (heights(mesh, 0, n).margin > 1e-3) cut_at(mesh, 0, n);
    }
}

TEST_CASE("fracture: a small component of the normal decides between two faces", "[A7.4][fracture]")
{
    // Faces 2 and 3 have the normals (1, 2, 0)/√5 and (-1, 2, 0)/√5; y is equally near to both.
    const std::array<Vector3d, 4> x = {Vector3d(0, 0, -1), Vector3d(0, 0, 1), Vector3d(2, 1, 0),
                                       Vector3d(-2, 1, 0)};
    for (int power = 1; power <= 46; ++power)
        for (int axis = 0; axis < 3; ++axis) { // the axes x, y, z become axis, axis + 1, axis + 2
            CAPTURE(power, axis);
            Matrix3d Q;
            for (int i = 0; i < 3; ++i)
                Q.col(i) = Vector3d::Unit((axis + i) % 3);
            std::array<Vector3d, 4> turned;
            for (int i = 0; i < 4; ++i)
                turned[i] = Q * x[i];
            const Vector3d n = Vector3d(std::ldexp(1, -power), 1, 0).normalized();
            const Vector3d mirrored(-n.x(), n.y(), 0);
            REQUIRE_THAT(closest_face(turned, Q * n), IsExactly(2));
            REQUIRE_THAT(closest_face(turned, Q * mirrored), IsExactly(3));
        }
}

TEST_CASE("fracture: through elements an isolated vertex at the origin stays", "[A7.6][fracture]")
{
    const TetrahedralMesh mesh = {{{0, 0, 0}}, {}};
    check_count(vertex_count(split_element(mesh, 0, Vector3d::UnitY()).mesh), 1, "vertices");
}

TEST_CASE("fracture: along faces an isolated vertex at the origin stays", "[A7.5][fracture]")
{
    const TetrahedralMesh mesh = {{{0, 0, 0}}, {}};
    check_count(vertex_count(split_along_faces(mesh, {}).mesh), 1, "vertices");
}

TEST_CASE("fracture: with virtual nodes an isolated vertex at the origin stays", "[A7.7][fracture]")
{
    const TetrahedralMesh mesh = {{{0, 0, 0}}, {}};
    check_count(vertex_count(virtual_nodes(mesh, {}).mesh), 1, "vertices");
}

} // namespace fracture_sides_test
