// SPDX-License-Identifier: MIT
// A7: stresses with nearly equal eigenvalues, thresholds next to the stress, faces that are nearly
// equally near, unused vertices, planes exactly through a center, tiny tips.
#include "fracture_laws.hpp"
#include "support/seeds.hpp"
#include "virtual_nodes_laws.hpp"

namespace rigor::testing::fracture_ranges_test {

namespace {

Matrix3d turned_stress(const Matrix3d& R, const Vector3d& principal)
{
    const Matrix3d stress = R * principal.asDiagonal() * R.transpose();
    return (stress + stress.transpose()) / 2;
}

constexpr double h = 1.0 / 64; // [m], less than 0.05 of an edge, and a power of two

// A flat tetrahedron on the plane z = 0 with the heights 0, -h, h and 0, whose center is exactly on
// the plane. A second one is on its face above, up to vertex 4, and a third below, down to vertex
// 5.
TetrahedralMesh between_two()
{
    return {{{0, 0, 0}, {0, 1, -h}, {1, 0, h}, {1, -1, 0}, {0.25, 0.25, 1}, {0.25, -0.125, -1}},
            {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 3, 5}}};
}

const Vector3d far_away(7, 8, 9);

// The mesh with one more vertex, of this number, that no tetrahedron uses.
TetrahedralMesh with_unused_vertex(TetrahedralMesh mesh, int number)
{
    mesh.vertices.insert(mesh.vertices.begin() + number, far_away);
    for (Tetrahedron& t : mesh.tetrahedra)
        for (int& v : t)
            if (v >= number) ++v;
    return mesh;
}

// Checks that the vertex is still there, once, and no tetrahedron has it.
void check_unused(const TetrahedralMesh& mesh, int count)
{
    check_count(vertex_count(mesh), count, "vertices");
    check_count(std::count(mesh.vertices.begin(), mesh.vertices.end(), far_away), 1,
                "vertices at the place of the unused one");
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int v : t)
            check_that(mesh.vertices[v] != far_away, "no tetrahedron has the unused vertex");
}

// Checks that the unused vertex has itself as its origin.
void check_origin(const SplitMesh& result, int unused)
{
    check_count(result.origins.size(), vertex_count(result.mesh), "origins, one for each vertex");
    for (std::size_t v = 0; v < result.mesh.vertices.size(); ++v) {
        if (result.mesh.vertices[v] != far_away) continue;
        const VertexOrigin& origin = result.origins[v];
        const bool is_itself =
            (origin.first == unused && origin.fraction == 0) ||
            (origin.second == unused && (origin.fraction == 1 || origin.first == unused));
        check_that(is_itself, "the origin of an unused vertex is this vertex");
    }
}

// Checks that no tetrahedron is inverted, which would be a mistake in the test.
void require_positive(const TetrahedralMesh& mesh)
{
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        check_that(volume(mesh, t) > 0, "the test's own mesh has no inverted tetrahedron");
}

} // namespace

TEST_CASE("fracture: nearly equal eigenvalues keep their digits", "[A7.2][fracture]")
{
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        for (int power = 15; power >= 1; --power) {
            const double gap = std::pow(10.0, -power);
            for (const double last : {-0.5, 1 - 2 * gap, 1 - gap}) {
                CAPTURE(gap, last);
                const Matrix3d sigma = turned_stress(R, {1, last, 1 - gap});
                const auto [stress, d] = principal_stress(sigma);
                REQUIRE_THAT(stress, IsClose(1.0, Rounding(256, 1)));
                REQUIRE_THAT(d.norm(), IsClose(1.0, Rounding(64)));
                REQUIRE_THAT(Vector3d(sigma * d), IsClose(Vector3d(stress * d), Rounding(256, 2)));
            }
        }
    }
}

TEST_CASE("fracture: a threshold next to the stress decides", "[A7.3][fracture]")
{
    for (Random random : seeds(20)) {
        const Matrix3d sigma = turned_stress(random.rotation(), {-0.5, 1, 0.25});
        for (int power = 1; power <= 12; ++power) {
            const double off = std::pow(10.0, -power);
            CAPTURE(off);
            check_that(crack_plane(sigma, 1 - off).has_value(),
                       "a crack, where σ₁ = 1 and the strength is 1 − off");
            check_that(!crack_plane(sigma, 1 + off).has_value(),
                       "no crack, where σ₁ = 1 and the strength is 1 + off");
        }
    }
}

TEST_CASE("fracture: of faces that are nearly equally near the nearer one", "[A7.4][fracture]")
{
    // faces 1 and 2 have the normals x and y; that of face 0 is nearly z, since the tetrahedron is
    // flat
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        const std::array<Vector3d, 4> flat = {R * Vector3d(0, 0, 0), R * Vector3d(1, 0, 0),
                                              R * Vector3d(0, 1, 0), R * Vector3d(0, 0, 0.1)};
        for (int power = 1; power <= 13; ++power)
            for (const double x : {1.0, -1.0})
                for (const double y : {1.0, -1.0}) {
                    const double more = 1 + std::pow(10.0, -power);
                    CAPTURE(more, x, y);
                    REQUIRE_THAT(closest_face(flat, R * Vector3d(more * x, y, 0).normalized()),
                                 IsExactly(1));
                    REQUIRE_THAT(closest_face(flat, R * Vector3d(x, more * y, 0).normalized()),
                                 IsExactly(2));
                }
    }
}

TEST_CASE("fracture: a mesh without tetrahedra keeps its vertices", "[A7.5][fracture]")
{
    const TetrahedralMesh points = {{{1, 2, 3}, {4, 5, 6}}, {}};
    const SplitMesh result = split_along_faces(points, {});
    check_count(vertex_count(result.mesh), 2, "vertices");
    check_count(result.origins.size(), 2, "origins, one for each vertex");
}

TEST_CASE("fracture: a center exactly on the plane is above", "[A7.6][fracture]")
{
    for (const int way : {1, -1, 2, -2, 3, -3}) { // the axis that the normal is along, and its sign
        CAPTURE(way);
        const int axis = std::abs(way) - 1;
        const double sign = way > 0 ? 1 : -1;
        TetrahedralMesh mesh = between_two();
        for (Vector3d& x : mesh.vertices) // the z axis becomes this one
            x = Vector3d(x[(2 - axis) % 3], x[(3 - axis) % 3], x[(4 - axis) % 3]);
        require_positive(mesh);
        const SplitMesh result = split_element(mesh, 0, sign * Vector3d::Unit(axis));
        check_split(mesh, result);
        INFO("the flat tetrahedron stays with the one that the normal points to");
        const double flat = volume(mesh, 0), other = volume(mesh, sign > 0 ? 1 : 2),
                     alone = volume(mesh, sign > 0 ? 2 : 1);
        std::vector<double> pieces = {flat + other, alone};
        std::sort(pieces.begin(), pieces.end());
        check_piece_volumes(result.mesh, pieces, Rounding(64, 1));
    }
}

TEST_CASE("fracture: a flat tetrahedron alone does not split", "[A7.6][fracture]")
{
    TetrahedralMesh mesh = between_two();
    mesh.vertices.resize(4);
    mesh.tetrahedra.resize(1);
    const SplitMesh result = split_element(mesh, 0, Vector3d::UnitZ());
    check_split(mesh, result);
    check_count(vertex_count(result.mesh), 4, "vertices");
    check_count(tetrahedron_count(result.mesh), 1, "tetrahedra");
}

TEST_CASE("fracture: a new vertex near the end of its edge is on the plane", "[A7.6][fracture]")
{
    // the longest edge is 1.16 m, so vertex 1 at 0.06 m just does not count as on the plane
    const TetrahedralMesh mesh = {{{0, 0, 0}, {0.5, 0, 0.06}, {0.5, 0.3, -1}, {0.1, 0.5, -0.5}},
                                  {{0, 1, 2, 3}}};
    require_positive(mesh);
    const SplitMesh result = split_element(mesh, 0, Vector3d::UnitZ());
    check_split(mesh, result);
    int cut = 0;
    for (std::size_t v = 0; v < result.origins.size(); ++v)
        if (result.origins[v].first != result.origins[v].second) {
            ++cut;
            REQUIRE_THAT(result.mesh.vertices[v].z(), IsClose(0.0, Rounding(8, 1)));
        }
    // two edges, and both sides of the crack
    check_count(cut, 4, "vertices that are new");
}

TEST_CASE("fracture: the mesh around a cut stays conforming", "[A7.6][fracture]")
{
    Random random(1);
    for (const int n : {2, 4, 5}) {
        CAPTURE(n);
        const TetrahedralMesh cube = jiggled(block(n, n, n), random);
        const int middle = block_vertex(n, n, n / 2, n / 2, n / 2);
        check_split(cube, split_element(cube, middle, Vector3d(1, 2, 3).normalized()));
    }
}

TEST_CASE("fracture: the tip that a crack cuts off may be tiny", "[A7.7][fracture]")
{
    const Vector3d normal = Vector3d(-1, -1, -1).normalized(); // points to the corner 0
    for (int power = 0; power <= 13; ++power) {
        const double k = std::exp2(-power);
        CAPTURE(k);
        const EmbeddedMesh result =
            virtual_nodes(unit_tetrahedron(), {{0, {0.99 * k, 0, 0}, normal}});
        const double share = std::pow(0.99 * k, 3);
        check_shares(result, std::vector{share, 1 - share}, Rounding(64, 1));
    }
}

TEST_CASE("fracture: two corners on either side at nearly equal heights", "[A7.7][fracture]")
{
    const auto nearly = [](double height, int power) { // the same for 53
        return power == 53 ? height : height * (1 + std::ldexp(1, -power));
    };
    const std::array<int, 4> orders[] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {2, 3, 0, 1},
                                         {2, 0, 1, 3}, {3, 2, 1, 0}, {1, 0, 3, 2}};
    for (int i = 1; i <= 53; i += 4)
        for (int j = 1; j <= 53; j += 4)
            for (const auto& order : orders) {
                CAPTURE(i, j, order[0], order[1]);
                const double p = 1, q = nearly(1, i), r = 2, s = nearly(2, j); // p, q above
                const std::array<Vector3d, 4> corners = {
                    {{p, 0, 0}, {q, 1, 0.5}, {-r, 0, 1}, {-s, 1, -0.5}}};
                TetrahedralMesh mesh = {{}, {{0, 1, 2, 3}}};
                for (const int c : order)
                    mesh.vertices.push_back(corners[c]);
                // The matter above is that of three tetrahedra, with fractions of the cut edges.
                const double pr = p / (p + r), ps = p / (p + s), qr = q / (q + r), qs = q / (q + s);
                const double above = qr * qs + pr * ps * (1 - qr) + ps * qr * (1 - qs);
                std::vector<double> shares = {above, 1 - above};
                if (order[0] >= 2) std::swap(shares[0], shares[1]);
                check_shares(embedded(mesh, {{0, {0, 0, 0}, {1, 0, 0}}}), shares, Rounding(64, 1));
            }
}

TEST_CASE("fracture: along faces an unused vertex stays", "[A7.5][fracture]")
{
    for (int unused = 0; unused <= 5; ++unused) {
        CAPTURE(unused);
        const TetrahedralMesh mesh = with_unused_vertex(two_tetrahedra(), unused);
        for (const bool is_cut : {false, true}) {
            const SplitMesh result = split_along_faces(mesh, is_cut ? std::vector<MeshFace>{{0, 0}}
                                                                    : std::vector<MeshFace>());
            check_unused(result.mesh, is_cut ? 9 : 6);
            check_origin(result, unused);
        }
    }
}

TEST_CASE("fracture: through elements an unused vertex stays", "[A7.6][fracture]")
{
    for (int unused = 0; unused <= 5; ++unused) {
        CAPTURE(unused);
        const TetrahedralMesh mesh = with_unused_vertex(two_tetrahedra(), unused);
        const int vertex = unused == 0 ? 1 : 0; // the origin, a corner of one tetrahedron alone
        const Vector3d normal = Vector3d(1, -1, 0).normalized();
        // the plane has two of its corners and halves the edge between the other two
        const SplitMesh result = split_element(mesh, vertex, normal);
        check_unused(result.mesh, 6 + 1 + 1);
        check_origin(result, unused);
        const SplitMesh whole = split_element(mesh, unused, normal);
        check_unused(whole.mesh, 6);
        check_origin(whole, unused);
    }
}

TEST_CASE("fracture: with virtual nodes an unused vertex stays", "[A7.7][fracture]")
{
    for (int unused = 0; unused <= 5; ++unused) {
        CAPTURE(unused);
        const TetrahedralMesh mesh = with_unused_vertex(two_tetrahedra(), unused);
        const EmbeddedMesh result = virtual_nodes(mesh, {});
        check_unused(result.mesh, 6);
        check_count(std::count(result.vertex_parents.begin(), result.vertex_parents.end(), unused),
                    1, "vertices whose parent is the unused one");
    }
}

} // namespace rigor::testing::fracture_ranges_test
