// SPDX-License-Identifier: MIT
// A7.5 to A7.7: meshes whose vertices stand at random places in a long list, where keys made of
// several indices may be the same for different faces or edges.
#include "fracture_laws.hpp"
#include "support/in_words.hpp"
#include "virtual_nodes_laws.hpp"

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
