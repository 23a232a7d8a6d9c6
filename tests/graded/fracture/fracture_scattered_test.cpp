// SPDX-License-Identifier: MIT
// A7.5 to A7.7: meshes whose vertices stand at random places in a long list, where keys made of
// several indices may be the same for different faces or edges.
#include "element_laws.hpp"
#include "fracture_laws.hpp"
#include "support/in_words.hpp"
#include "virtual_nodes_laws.hpp"

#include <cstdint>

namespace rigor::testing::fracture_scattered_test {

namespace {

// The mesh with its vertices at random places in a list of `count`; the others are unused.
TetrahedralMesh scattered(const TetrahedralMesh& mesh, int count, Random& random)
{
    TetrahedralMesh result = {
        std::vector<Vector3d>(static_cast<std::size_t>(count), Vector3d(7, 7, 7)), mesh.tetrahedra};
    const std::vector<int> place = permutation(random, static_cast<std::size_t>(count));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        result.vertices[place[v]] = mesh.vertices[v];
    for (Tetrahedron& t : result.tetrahedra)
        for (int& corner : t)
            corner = place[corner];
    return result;
}

// Numbers of vertices. If indices are added up with such a number as the factor between them, the
// sums leave 32 bits, and the first index of a face counts little or nothing in the rest.
constexpr int vertex_counts[] = {128, 256, 1000, 1024, 1 << 13, 1 << 15, 1 << 16, 1 << 20};

} // namespace

TEST_CASE("fracture: along faces a mesh scattered among many vertices", "[A7.5][fracture]")
{
    const TetrahedralMesh cube = block(3, 3, 3);
    for (const int count : vertex_counts)
        for (Random random : seeds(3)) {
            CAPTURE(count);
            const TetrahedralMesh mesh = scattered(cube, count, random);
            for (const double x : {1.0, 9.0}) { // across the cube, and nowhere
                const auto at = [x](const Vector3d& p) { return p.x() == x; };
                const SplitMesh result = split_along_faces(mesh, faces_where(mesh, at));
                check_count(vertex_count(result.mesh), count + (x == 1 ? 16 : 0), "vertices");
                check_count(piece_count(result.mesh), x == 1 ? 2 : 1, "pieces");
            }
        }
}

TEST_CASE("fracture: along faces a mesh in which many faces meet", "[A7.5][fracture]")
{
    for (const int count : vertex_counts)
        for (Random random : seeds(3)) {
            CAPTURE(count);
            const TetrahedralMesh mesh = scattered(block(3, 3, 3), count, random);
            std::vector<MeshFace> faces;
            for (int n = 0; n < 40; ++n)
                faces.push_back(
                    {random_index(random, mesh.tetrahedra.size()), random_index(random, 4)});
            check_definition(mesh, faces, split_along_faces(mesh, faces));
        }
}

TEST_CASE("fracture: through elements a mesh scattered among many vertices", "[A7.6][fracture]")
{
    const TetrahedralMesh cube = block(2, 2, 2);
    const Vector3d middle(1, 1, 1), normal = Vector3d(1, 0.3, -0.2).normalized();
    const auto counts = [&](const TetrahedralMesh& mesh) {
        int vertex = 0;
        while (mesh.vertices[vertex] != middle)
            ++vertex;
        const SplitMesh result = split_element(mesh, vertex, normal);
        return std::array{vertex_count(result.mesh) - vertex_count(mesh),
                          tetrahedron_count(result.mesh), piece_count(result.mesh)};
    };
    const auto expected = counts(cube);
    for (const int count : vertex_counts)
        for (Random random : seeds(3)) {
            CAPTURE(count);
            const auto found = counts(scattered(cube, count, random));
            check_count(found[0], expected[0], "new vertices, as where none is unused");
            check_count(found[1], expected[1], "tetrahedra, as where no vertex is unused");
            check_count(found[2], expected[2], "pieces, as where no vertex is unused");
        }
}

namespace {

using Edge = std::array<int, 2>; // its vertices, above the plane and below it

// Pairs of edges whose keys, first · factor + second with this number of bits, are the same. In
// each edge of the first pair the first index is the smaller one, in the second pair the larger
// one. All indices are below count - 2; if that is impossible, there are no such pairs.
std::vector<std::array<Edge, 2>> with_one_key(std::int64_t factor, int bits, int count)
{
    const std::int64_t keys = std::int64_t(1) << bits;
    for (int step = 1; step < count; ++step)
        for (const bool is_beyond : {false, true}) {
            // (a + step, b) has the key of (a, b + rest), and (a + step, b + keys - rest) that of
            // (a, b)
            const std::int64_t rest = step * factor % keys, more = is_beyond ? keys - rest : rest;
            if (step + more + 8 >= count) continue;
            const int one = is_beyond ? static_cast<int>(more) : 0,
                      other = static_cast<int>(more) - one;
            const int a = static_cast<int>(more) + 5, b = step + 6;
            return {{Edge{2 + step, b + one}, Edge{2, b + other}},
                    {Edge{a + step, 2 + one}, Edge{a, 2 + other}}};
        }
    return {};
}

// Two or three tetrahedra around an edge from the last vertex to the one before, and with it these
// two edges from y > 0 to y < 0. The other vertices are unused.
TetrahedralMesh star_with(const std::array<Edge, 2>& edges, int count)
{
    TetrahedralMesh mesh = {
        std::vector<Vector3d>(static_cast<std::size_t>(count), Vector3d(7, 7, 7)), {}};
    const auto& [one, other] = edges;
    const int bottom = count - 1, top = count - 2;
    mesh.vertices[bottom] = {0, 0, -0.5};
    mesh.vertices[top] = {0, 0, 1};
    mesh.vertices[one[0]] = {0.5, 0.75, 0};
    mesh.vertices[other[0]] = {-0.5, 0.75, 0};
    mesh.vertices[one[1]] = {0.5, -0.75, 0};
    mesh.vertices[other[1]] = {one[1] == other[1] ? 0 : -0.5, -0.75, 0};
    mesh.tetrahedra = {{bottom, one[1], one[0], top}, {bottom, other[0], other[1], top}};
    if (one[1] != other[1]) mesh.tetrahedra.push_back({bottom, other[1], one[1], top});
    return mesh;
}

} // namespace

TEST_CASE("fracture: through two edges however their indices are put together", "[A7.6][fracture]")
{
    std::vector<std::array<int, 2>> some; // a factor, and how many vertices there may be
    for (const int count : {100'000, 1 << 17, 150'000, 200'000})
        some.push_back({count, count});
    for (const int factor : {1, 31, 1000, 10'000, 46'341, 65'535, 65'536, 65'537, 1'000'003})
        some.push_back({factor, 140'000});
    int tried = 0;
    for (const auto& [factor, most] : some)
        for (const int bits : {16, 24, 31, 32})
            for (const auto& [one, other] : with_one_key(factor, bits, most)) {
                CAPTURE(factor, bits, one, other);
                const int largest = std::max({one[0], one[1], other[0], other[1]}),
                          count = factor == most ? most : largest + 3;
                const TetrahedralMesh mesh = star_with({one, other}, count);
                for (const Vector3d& n : {Vector3d(0, 1, 0), Vector3d(0, -1, 0)}) {
                    const SplitMesh result = split_element(mesh, count - 1, n);
                    check_new_vertices(mesh, result, count - 1, n);
                    check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh) + 2,
                                "tetrahedra, two of them in halves");
                    ++tried;
                }
            }
    check_that(tried > 150, "enough edges with one key, in the test itself");
}

TEST_CASE("fracture: with virtual nodes a mesh scattered among many vertices", "[A7.7][fracture]")
{
    const TetrahedralMesh cube = block(3, 3, 3);
    const auto cracked = [](const TetrahedralMesh& mesh) {
        const Vector3d normal = Vector3d(1, 0.3, -0.2).normalized();
        return virtual_nodes(mesh, plane_through(mesh, {1.4, 1.5, 1.6}, normal)).mesh;
    };
    const auto expected = vertex_count(cracked(cube)) - vertex_count(cube);
    for (const int count : vertex_counts)
        for (Random random : seeds(3)) {
            CAPTURE(count);
            const TetrahedralMesh result = cracked(scattered(cube, count, random));
            check_count(piece_count(result), 2, "pieces");
            check_count(vertex_count(result) - count, expected,
                        "new vertices, as where none is unused");
        }
}

TEST_CASE("fracture: the cracks of an element may stand anywhere in the list", "[A7.7][fracture]")
{
    for (Random random : seeds(20)) {
        const TetrahedralMesh mesh = jiggled(block(2, 1, 1), random);
        Cracks grouped; // up to three of each tetrahedron
        for (int t = 0; t < tetrahedron_count(mesh); ++t)
            for (std::uint64_t n = random.bits() % 4; n > 0; --n)
                grouped.push_back({t, center(mesh, t), random.unit_vector()});
        // the same, the first ones of all tetrahedra before the second ones, and so on
        Cracks by_rank;
        for (int rank = 0; rank < 3; ++rank) {
            std::vector<int> seen(mesh.tetrahedra.size(), 0);
            for (const ElementCrack& crack : grouped)
                if (seen[crack.tetrahedron]++ == rank) by_rank.push_back(crack);
        }
        const EmbeddedMesh one = embedded(mesh, grouped), two = embedded(mesh, by_rank);
        REQUIRE_THAT(two.real, IsExactly(one.real));
        check_count(vertex_count(two.mesh), vertex_count(one.mesh), "vertices");
        check_shares(two, one.fractions, Rounding(16, 1));
    }
}

} // namespace rigor::testing::fracture_scattered_test
