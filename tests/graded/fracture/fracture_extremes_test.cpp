// SPDX-License-Identifier: MIT
// A7: parts of very different sizes beside each other, many tetrahedra around an edge, many
// vertices, many cracks in an element, and degenerate tetrahedra.
#include "fracture_laws.hpp"
#include "support/in_words.hpp"
#include "virtual_nodes_laws.hpp"

#include <algorithm>
#include <map>

namespace rigor::testing::fracture_extremes_test {

namespace {

// The mesh with its vertices listed behind `count` vertices that no tetrahedron uses.
TetrahedralMesh behind_unused(const TetrahedralMesh& mesh, int count)
{
    TetrahedralMesh result;
    result.vertices.assign(static_cast<std::size_t>(count), Vector3d(7, 7, 7));
    result.vertices.insert(result.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Tetrahedron& t : mesh.tetrahedra)
        result.tetrahedra.push_back({t[0] + count, t[1] + count, t[2] + count, t[3] + count});
    return result;
}

constexpr int many = 70'000; // more than indices of 16 bits can number

const Vector3d oblique(0.48, 0.64, 0.6); // a unit vector

// The moved mesh. Its coordinates are exact if those of the mesh have few digits.
TetrahedralMesh moved_far(TetrahedralMesh mesh, const Vector3d& by)
{
    for (Vector3d& x : mesh.vertices)
        x += by;
    return mesh;
}

Vector3d far_by(int power)
{
    return std::ldexp(1, power) * Vector3d(1.25, -0.75, 1.5);
}

// For each edge that was cut, its ends and where it was cut, from the end with the smaller number.
std::map<std::pair<int, int>, double> cut_edges(const SplitMesh& split)
{
    std::map<std::pair<int, int>, double> cuts;
    for (const auto& [first, second, fraction] : split.origins)
        if (first < second)
            cuts[{first, second}] = fraction;
        else if (second < first)
            cuts[{second, first}] = 1 - fraction;
    return cuts;
}

} // namespace

TEST_CASE("fracture: only an element and its neighbours count in its average", "[A7.1][fracture]")
{
    // a third element, which is nobody's neighbor, may be as large or small as it likes
    const Matrix3d one = Matrix3d::Identity();
    for (int power = -200; power <= 200; power += 8) {
        CAPTURE(power);
        const auto smooth =
            smooth_stress({one, 3 * one, 5 * one}, {{1}, {0}, {}}, {1, 1, std::ldexp(1, power)});
        REQUIRE_THAT(smooth,
                     IsClose(std::vector<Matrix3d>{2 * one, 2 * one, 5 * one}, Rounding(8)));
    }
}

TEST_CASE("fracture: a pull opens a crack however strong the pressure across it is",
          "[A7.3][fracture]")
{
    for (int axis = 0; axis < 3; ++axis)
        for (int power = 0; power <= 44; ++power) {
            CAPTURE(axis, power);
            Vector3d principal = Vector3d::Constant(-1);
            principal[axis] = std::ldexp(1, -power);
            const auto normal = crack_plane(principal.asDiagonal(), 0);
            check_that(normal.has_value(), "a crack, since a principal stress is positive");
            REQUIRE_THAT(std::abs((*normal)[axis]), IsClose(1.0, Rounding(64)));
        }
}

TEST_CASE("fracture: a face of a flat tetrahedron and those that hardly lean against it",
          "[A7.4][fracture]")
{
    // the face opposite the low tip is level; the others lean by about the height of the tip
    for (int tip = 0; tip < 4; ++tip)
        for (int power = 1; power <= 20; ++power)
            for (const double sign : {1.0, -1.0}) {
                CAPTURE(tip, power, sign);
                const Vector3d level[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
                std::array<Vector3d, 4> flat;
                for (int i = 0; i < 3; ++i)
                    flat[(tip + 1 + i) % 4] = level[i];
                flat[tip] = {0.25, 0.25, std::ldexp(sign, -power)};
                REQUIRE_THAT(closest_face(flat, {0, 0, 1}), IsExactly(tip));
            }
}

TEST_CASE("fracture: no face of a flat tetrahedron is near a crack across it", "[A7.4][fracture]")
{
    // All vertices lie in the plane z = 0, so every |n_f·n| is 0, with or without an area.
    for (Random random : seeds(60)) {
        std::array<Vector3d, 4> flat;
        for (Vector3d& x : flat) // on few places, so that some are equal or in one line
            x = {1.0 * random_index(random, 3), 1.0 * random_index(random, 3), 0};
        CAPTURE(flat[0], flat[1], flat[2], flat[3]);
        REQUIRE_THAT(closest_face(flat, Vector3d(0.6, 0.8, 0)), IsExactly(0));
    }
}

TEST_CASE("fracture: any number of tetrahedra around an edge part at two faces", "[A7.5][fracture]")
{
    for (const int n : {8, 30, 70, 130, 300})
        for (Random random : seeds(6)) {
            const TetrahedralMesh ring = ring_around_edge(n);
            const int one = random_index(random, n), size = 2 + random_index(random, n - 3);
            CAPTURE(n, one, size);
            // face 2 of tetrahedron i has the vertex 2 + i
            const SplitMesh result = split_along_faces(ring, {{one, 2}, {(one + size) % n, 2}});
            check_split(ring, result);
            // both ends of the edge are doubled, and a vertex at each cut
            check_count(vertex_count(result.mesh), n + 2 + 4, "vertices");
            check_count(piece_count(result.mesh), 2, "pieces");
        }
}

TEST_CASE("fracture: along faces a mesh with many vertices", "[A7.5][fracture]")
{
    const TetrahedralMesh cube = block(2, 2, 2), mesh = behind_unused(cube, many);
    for (const double x : {1.0, 3.0}) { // in the middle, and outside of the mesh
        const auto at = [x](const Vector3d& p) { return p.x() == x; };
        const SplitMesh result = split_along_faces(mesh, faces_where(cube, at));
        check_count(vertex_count(result.mesh), many + 27 + (x == 1 ? 9 : 0), "vertices");
        check_count(piece_count(result.mesh), x == 1 ? 2 : 1, "pieces");
    }
}

TEST_CASE("fracture: along faces a small mesh far from the origin", "[A7.5][fracture]")
{
    const TetrahedralMesh blocks = block(2, 1, 1);
    TetrahedralMesh near = blocks;
    for (Vector3d& x : near.vertices) // a parallelepiped, with exact coordinates
        x = x + Vector3d(x.y() / 4 + x.z() / 8, x.z() / 4 + x.x() / 8, x.x() / 4 + x.y() / 8);
    for (int power = 0; power <= 48; power += 2) {
        CAPTURE(power);
        const TetrahedralMesh far = moved_far(near, far_by(power));
        const SplitMesh result = split_along_faces(
            far, faces_where(blocks, [](const Vector3d& x) { return x.x() == 1; }));
        check_count(vertex_count(result.mesh), 12 + 4, "vertices");
        for (std::size_t t = 0; t < result.mesh.tetrahedra.size(); ++t)
            REQUIRE_THAT(volume(result.mesh, t), IsClose(volume(far, t), Rounding(16, 1)));
    }
}

TEST_CASE("fracture: through elements a small mesh far from the origin", "[A7.6][fracture]")
{
    const auto near = cut_edges(split_element(octahedron(), 0, oblique));
    for (int power = 0; power <= 44; power += 2) {
        CAPTURE(power);
        const auto far =
            cut_edges(split_element(moved_far(octahedron(), far_by(power)), 0, oblique));
        check_count(far.size(), static_cast<int>(near.size()), "edges that are cut");
        for (const auto& [edge, fraction] : near) {
            check_count(far.count(edge), 1, "cuts of an edge that is cut near the origin");
            REQUIRE_THAT(far.at(edge), IsClose(fraction, Rounding(16, 1)));
        }
    }
}

TEST_CASE("fracture: with virtual nodes a small mesh far from the origin", "[A7.7][fracture]")
{
    const auto shares = [](const Vector3d& by) {
        const TetrahedralMesh cube = block(2, 2, 2);
        Cracks cracks = plane_through(cube, {0.875, 1.125, 0.75}, oblique);
        for (ElementCrack& crack : cracks)
            crack.point += by;
        const EmbeddedMesh result = virtual_nodes(moved_far(cube, by), cracks);
        std::vector<double> all;
        for (std::size_t i = 0; i < result.parents.size(); ++i)
            all.push_back(result.parents[i] + result.fractions[i]);
        std::sort(all.begin(), all.end());
        return all;
    };
    const std::vector<double> near = shares({0, 0, 0});
    for (int power = 0; power <= 44; power += 2) {
        CAPTURE(power);
        REQUIRE_THAT(shares(far_by(power)),
                     IsClose(near, Rounding(16, static_cast<double>(near.size()))));
    }
}

TEST_CASE("fracture: through elements a mesh with many vertices", "[A7.6][fracture]")
{
    const SplitMesh small = split_element(octahedron(), 0, diagonal),
                    large = split_element(behind_unused(octahedron(), many), many, diagonal);
    check_count(vertex_count(large.mesh), many + vertex_count(small.mesh), "vertices");
    check_count(piece_count(large.mesh), piece_count(small.mesh), "pieces");
}

TEST_CASE("fracture: with virtual nodes a mesh with many vertices", "[A7.7][fracture]")
{
    const TetrahedralMesh cube = block(2, 2, 2), mesh = behind_unused(cube, many);
    const Cracks cracks = plane_through(cube, {0.5, 0, 0}, {1, 0, 0});
    const EmbeddedMesh small = virtual_nodes(cube, cracks), large = virtual_nodes(mesh, cracks);
    check_count(vertex_count(large.mesh), many + vertex_count(small.mesh), "vertices");
    check_count(piece_count(large.mesh), piece_count(small.mesh), "pieces");
}

TEST_CASE("fracture: any number of cracks beside an element changes nothing", "[A7.7][fracture]")
{
    for (const int count : {1, 31, 32, 63, 64, 130}) {
        CAPTURE(count);
        Cracks cracks = {corner_cut(0, 0.5)};
        for (int i = 0; i < count; ++i)
            cracks.push_back(corner_cut(0, 2 + i, i % 2 == 0 ? 1 : -1));
        check_shares(embedded(unit_tetrahedron(), cracks), std::vector{0.125, 0.875},
                     Rounding(16, 1));
        std::reverse(cracks.begin(), cracks.end());
        check_shares(embedded(unit_tetrahedron(), cracks), std::vector{0.125, 0.875},
                     Rounding(16, 1));
    }
}

TEST_CASE("fracture: a crack through corners cuts the same beside others", "[A7.7][fracture]")
{
    // The last crack passes through one corner or two; the others leave the element whole.
    const Vector3d normals[] = {{1, -1, 0}, {1, -2, 0.5}, {0, 1, -3}, {2, -1, -1}};
    for (const Vector3d& n : normals)
        for (const int count : {1, 2, 3, 10}) {
            CAPTURE(n, count);
            const ElementCrack crack = {0, Vector3d::Zero(), n.normalized()};
            Cracks cracks;
            for (int i = 0; i < count; ++i)
                cracks.push_back(corner_cut(0, 2 + i, i % 2 == 0 ? 1 : -1));
            cracks.push_back(crack);
            const EmbeddedMesh alone = embedded(unit_tetrahedron(), {crack}),
                               beside = embedded(unit_tetrahedron(), cracks);
            check_shares(beside, alone.fractions, Rounding(16, 1));
        }
}

TEST_CASE("fracture: two cracks in one plane with opposite normals", "[A7.7][fracture]")
{
    // The corners 0 and 3 lie in the plane x = y, so they are on the side of either normal. After
    // the first crack, their part has no matter on the side of the second normal. So the second
    // crack leaves these corners without a share.
    const Vector3d n = Vector3d(1, -1, 0).normalized(), zero = Vector3d::Zero();
    for (const double sign : {1.0, -1.0}) {
        const EmbeddedMesh result =
            embedded(unit_tetrahedron(), {{0, zero, sign * n}, {0, zero, -sign * n}});
        REQUIRE_THAT(result.real,
                     IsExactly(std::vector<Tetrahedron>{{1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}}));
        check_shares(result, std::vector<double>{0, 0.5, 0.5}, Rounding(16, 1));
    }
}

TEST_CASE("fracture: the slice that a crack cuts off may be thin", "[A7.7][fracture]")
{
    // z < c has the share 1 - (1 - c)³
    for (int power = 1; power <= 40; ++power) {
        CAPTURE(power);
        const double c = std::ldexp(1, -power), share = c * (3 - 3 * c + c * c);
        const EmbeddedMesh result = embedded(unit_tetrahedron(), {{0, {0, 0, c}, {0, 0, 1}}});
        REQUIRE_THAT(result.real, IsExactly(std::vector<Tetrahedron>{{1, 1, 1, 0}, {0, 0, 0, 1}}));
        check_shares(result, std::vector{share, 1 - share}, Rounding(16, 1));
    }
}

TEST_CASE("fracture: a corner whose height is a negative zero is on the side of the normal",
          "[A7.7][fracture]")
{
    // the height of corner 0 is 0 or, where all products are negative zeros, -0.0
    for (const Vector3d& n : {Vector3d(1, 1, 1), Vector3d(-1, -1, -1), Vector3d(-1, 0, 0)}) {
        CAPTURE(n);
        const Vector3d normal = n.normalized();
        const EmbeddedMesh result = embedded(unit_tetrahedron(), {{0, {0, 0, 0}, normal}});
        std::vector<Tetrahedron> real = {{1, 1, 1, 1}};
        if (n.sum() == -3) real = {{1, 0, 0, 0}, {0, 1, 1, 1}};
        if (n.sum() == -1) real = {{1, 0, 1, 1}, {0, 1, 0, 0}};
        REQUIRE_THAT(result.real, IsExactly(real));
    }
}

TEST_CASE("fracture: shares of a flat element follow from its heights alone", "[A7.7][fracture]")
{
    // One corner has the height 1/2, the others -1/2, -1/2 and t - 1/4: its side has the share
    // (1/2)³/(1 · 1 · (3/4 - t)), whatever the volume is.
    for (int power = 2; power <= 44; ++power) {
        CAPTURE(power);
        const double t = std::ldexp(1, -power);
        TetrahedralMesh flat = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25 + t, 0.25 + t, 0.5 + t}},
                                {{0, 1, 2, 3}}};
        const double share = 0.125 / (0.75 - t);
        check_shares(embedded(flat, {{0, {0.5, 0, 0}, {1, 0, 0}}}), std::vector{share, 1 - share},
                     Rounding(32, 1));
    }
}

TEST_CASE("fracture: a little more tension than the strength in all directions", "[A7.3][fracture]")
{
    // the eigenvalues are p + d, p and p - d: the largest along the diagonal of the shear
    for (int axis = 0; axis < 3; ++axis)
        for (int power = 1; power <= 44; ++power) {
            CAPTURE(axis, power);
            const int next = (axis + 1) % 3;
            const double p = 0x1p20, d = std::ldexp(p, -power);
            Matrix3d stress = p * Matrix3d::Identity();
            stress(axis, next) = stress(next, axis) = d;
            check_that(!crack_plane(stress, p + 1.5 * d), "the strength is not exceeded: no crack");
            const std::optional<Vector3d> n = crack_plane(stress, p + 0.5 * d);
            check_that(n.has_value(), "the strength is exceeded: a crack");
            const Vector3d diagonal = (Vector3d::Unit(axis) + Vector3d::Unit(next)).normalized();
            REQUIRE_THAT(std::abs(n->dot(diagonal)), IsClose(1.0, Rounding(64, std::exp2(power))));
        }
}

TEST_CASE("fracture: the closest face of tiny and of huge tetrahedra", "[A7.4][fracture]")
{
    for (int power = -200; power <= 200; power += 10) {
        CAPTURE(power);
        std::array<Vector3d, 4> corners = corners_of(unit_tetrahedron(), 0);
        for (Vector3d& x : corners)
            x *= std::ldexp(1, power);
        for (int axis = 0; axis < 3; ++axis) // face 1 + axis is perpendicular to the axis
            REQUIRE_THAT(closest_face(corners, Vector3d::Unit(axis)), IsExactly(1 + axis));
        REQUIRE_THAT(closest_face(corners, Vector3d(1, 1, 1).normalized()), IsExactly(0));
    }
}

TEST_CASE("fracture: the closest face of a small tetrahedron far from the origin",
          "[A7.4][fracture]")
{
    for (int distance = 0; distance <= 30; ++distance) {
        CAPTURE(distance);
        std::array<Vector3d, 4> corners = corners_of(unit_tetrahedron(), 0);
        for (Vector3d& x : corners) // exact
            x = 0x1p-10 * x + std::ldexp(1, distance) * Vector3d(1.25, -0.75, 1.5);
        for (int axis = 0; axis < 3; ++axis)
            REQUIRE_THAT(closest_face(corners, Vector3d::Unit(axis)), IsExactly(1 + axis));
        REQUIRE_THAT(closest_face(corners, Vector3d(1, 1, 1).normalized()), IsExactly(0));
    }
}

} // namespace rigor::testing::fracture_extremes_test
