// SPDX-License-Identifier: MIT
// Comparisons with the reference. These tests run only where the reference is available.
#include "graded/fracture/virtual_nodes_laws.hpp"
#include "support/seeds.hpp"
#include "worker/proxy/proxy.hpp"

namespace rigor::testing {

namespace {

TetrahedralMesh random_mesh(Random& random)
{
    const auto cells = [&] { return 1 + random_index(random, 3); };
    const int nx = cells(), ny = cells(), nz = cells();
    return renumbered(jiggled(block(nx, ny, nz), random), random).mesh;
}

Vector3d point_in(const TetrahedralMesh& mesh, int t, Random& random)
{
    return center(mesh, t) + 0.2 * random.vector();
}

} // namespace

TEST_CASE("fracture: meshes come apart along faces as the reference's do",
          "[A7.9][fracture][hidden]")
{
    for (unsigned seed : seeds(30)) {
        Random random(seed + 1000);
        const TetrahedralMesh mesh = random_mesh(random);
        // the faces between the tetrahedra above and below a plane, and 5 % of the others
        std::vector<MeshFace> faces;
        const Vector3d n = random.unit_vector();
        const double middle = n.dot(center(mesh, 0));
        const auto is_above = [&](int t) { return n.dot(center(mesh, t)) > middle; };
        for (const auto& [face, sharing] : tetrahedra_of_faces(mesh)) {
            if (sharing.size() != 2) continue;
            if (is_above(sharing[0]) == is_above(sharing[1]) && random.uniform(0, 1) < 0.95)
                continue;
            const int t = sharing[random_index(random, 2)];
            for (int f = 0; f < 4; ++f)
                if (face_vertices(mesh.tetrahedra[t], f) == face) faces.push_back({t, f});
        }
        const SplitMesh expected = by_reference([&] { return split_along_faces(mesh, faces); });
        const SplitMesh actual = split_along_faces(mesh, faces);
        check_same_vertices(actual.mesh.tetrahedra, expected.mesh.tetrahedra);
        check_count(vertex_count(actual.mesh), vertex_count(expected.mesh), "vertices");
    }
}

TEST_CASE("fracture: elements are cut where the reference cuts them", "[A7.9][fracture][hidden]")
{
    for (unsigned seed : seeds(30)) {
        Random random(seed + 2000);
        const TetrahedralMesh mesh = random_mesh(random);
        const int vertex = random_index(random, mesh.vertices.size());
        const Vector3d n = random.unit_vector();
        const SplitMesh expected = by_reference([&] { return split_element(mesh, vertex, n); });
        const SplitMesh actual = split_element(mesh, vertex, n);
        check_split(mesh, actual);
        check_count(vertex_count(actual.mesh), vertex_count(expected.mesh), "vertices");
        check_piece_volumes(actual.mesh, piece_volumes(expected.mesh), Rounding(256, 27));
        REQUIRE_THAT(surface_areas(actual.mesh).cracks,
                     IsClose(surface_areas(expected.mesh).cracks, Rounding(256, 27)));
    }
}

TEST_CASE("fracture: elements are duplicated as the reference duplicates them",
          "[A7.9][fracture][hidden]")
{
    for (unsigned seed : seeds(30)) {
        Random random(seed + 3000);
        const TetrahedralMesh mesh = random_mesh(random);
        std::vector<ElementCrack> cracks;
        const Vector3d n = random.unit_vector(), x = point_in(mesh, 0, random);
        for (int t = 0; t < tetrahedron_count(mesh); ++t) {
            if (random.uniform(0, 1) < 0.8) cracks.push_back({t, x, n});
            if (random.uniform(0, 1) < 0.2)
                cracks.push_back({t, point_in(mesh, t, random), random.unit_vector()});
        }
        const EmbeddedMesh expected = by_reference([&] { return virtual_nodes(mesh, cracks); });
        const EmbeddedMesh actual = virtual_nodes(mesh, cracks);
        REQUIRE_THAT(actual.parents, IsExactly(expected.parents));
        REQUIRE_THAT(actual.real, IsExactly(expected.real));
        check_same_vertices(actual.mesh.tetrahedra, expected.mesh.tetrahedra);
        check_shares(actual, expected.fractions, Rounding(256, 1));
    }
}

} // namespace rigor::testing
