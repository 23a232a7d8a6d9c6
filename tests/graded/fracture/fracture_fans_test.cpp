// SPDX-License-Identifier: MIT
// A7.5 to A7.7: thousands of tetrahedra around a vertex and thousands of copies of it, wherever
// they stand in the lists.
#include "element_laws.hpp"
#include "support/seeds.hpp"
#include "virtual_nodes_laws.hpp"

#include <cmath>
#include <numbers>

namespace fracture_fans_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// The face of tetrahedron i in `ring_around_edge` that it shares with tetrahedron i - 1.
MeshFace face_before(const Placed& at, int i)
{
    const int other = static_cast<int>(at.mesh.tetrahedra.size()); // as many as rim vertices
    return {at.tetrahedron[i], at.corner(i, 2 + (i + 1) % other)};
}

// Appends tetrahedra with the last vertex over a part of a polygon, from vertex i to vertex k. Each
// has two neighbours that halve the rest, so twice as many wait in each round of a search.
void add_halves(TetrahedralMesh& mesh, int i, int k)
{
    if (k - i < 2) return;
    const int middle = (i + k) / 2, tip = static_cast<int>(mesh.vertices.size()) - 1;
    mesh.tetrahedra.push_back({i, middle, k, tip});
    add_halves(mesh, i, middle);
    add_halves(mesh, middle, k);
}

// A pyramid over a regular polygon.
TetrahedralMesh pyramid(int corners)
{
    TetrahedralMesh mesh;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    mesh.vertices.emplace_back(0, 0, 1);
    add_halves(mesh, 0, corners - 1);
    return mesh;
}

} // namespace

TEST_CASE("fracture: a vertex has as many copies as groups of tetrahedra", "[A7.5][fracture]")
{
    for (const int n : {5, 9, 17, 33, 40, 100, 300})
        everywhere(ring_around_edge(n), [&](const Placed& at) {
            for (const int groups : {2, n / 2, n - 1, n}) {
                CAPTURE(n, groups);
                std::vector<MeshFace> faces;
                for (int i = 0; i < groups; ++i)
                    faces.push_back(face_before(at, i));
                const SplitMesh result = split_along_faces(at.mesh, faces);
                REQUIRE_THAT(corners(result.mesh), IsExactly(corners(at.mesh)));
                check_conforms(result.mesh);
                // a copy of both ends of the edge for each group, and one more rim vertex each
                check_count(vertex_count(result.mesh), 2 * groups + n + groups, "vertices");
                check_count(piece_count(result.mesh), groups, "pieces");
            }
        });
}

TEST_CASE("fracture: thousands of tetrahedra around an edge stay together or part at two faces",
          "[A7.5][fracture]")
{
    Random random(1);
    for (const Placed& at : {Placed(ring_around_edge(2000)), Placed(ring_around_edge(70'000)),
                             Placed(ring_around_edge(5000), random)}) {
        const int n = static_cast<int>(at.mesh.tetrahedra.size());
        check_count(vertex_count(split_along_faces(at.mesh, {}).mesh), n + 2, "vertices");
        const std::vector<MeshFace> faces = {face_before(at, n - 300), face_before(at, n - 100)};
        const SplitMesh result = split_along_faces(at.mesh, faces);
        // both ends of the edge are doubled, and a vertex at each cut
        check_count(vertex_count(result.mesh), n + 2 + 4, "vertices");
        check_count(piece_count(result.mesh), 2, "pieces");
    }
}

TEST_CASE("fracture: thousands of tetrahedra that branch from one stay together",
          "[A7.5][fracture]")
{
    Random random(2);
    for (const int corners : {40, 500, 9000})
        for (const Placed& at : {Placed(pyramid(corners)), Placed(pyramid(corners), random)}) {
            CAPTURE(corners);
            const SplitMesh whole = split_along_faces(at.mesh, {});
            check_count(vertex_count(whole.mesh), corners + 1, "vertices");
            // the face over the diagonal from the first corner to the middle
            const std::vector<MeshFace> faces = {{at.tetrahedron[0], at.corner(0, corners - 1)}};
            const SplitMesh result = split_along_faces(at.mesh, faces);
            check_count(vertex_count(result.mesh), corners + 1 + 3, "vertices");
            check_count(piece_count(result.mesh), 2, "pieces");
        }
}

TEST_CASE("fracture: a plane along an edge cuts any number of tetrahedra around it",
          "[A7.6][fracture]")
{
    for (const int n : {12, 40, 70, 130, 300, 2000})
        for (Random random : seeds(4)) {
            CAPTURE(n);
            const Placed at(ring_around_edge(n), random);
            const double angle = random.uniform(-3, 3);
            const Vector3d normal = at.R * Vector3d(std::cos(angle), std::sin(angle), 0);
            if (heights(at.mesh, at.vertex[0], normal).margin < 1e-6) continue; // too close to call
            check_count(piece_count(cut_at(at.mesh, at.vertex[0], normal).mesh), 2, "pieces");
        }
}

TEST_CASE("fracture: a tilted plane cuts any number of tetrahedra around a vertex",
          "[A7.6][fracture]")
{
    for (const int n : {12, 40, 70, 130, 300, 2000})
        for (Random random : seeds(4)) {
            CAPTURE(n);
            const Placed at(ring_around_edge(n), random);
            // at an angle of 45° to the edge and less, so that all matter is on both sides
            const double angle = random.uniform(-3, 3), tilt = random.uniform(-0.7, 0.7);
            const Vector3d normal =
                (at.R * Vector3d(std::cos(angle), std::sin(angle), tilt)).normalized();
            if (heights(at.mesh, at.vertex[0], normal).margin < 1e-6) continue; // too close to call
            const SplitMesh result = cut_at(at.mesh, at.vertex[0], normal);
            check_that(vertex_count(result.mesh) > n + 4, "new vertices where edges are cut");
        }
}

TEST_CASE("fracture: with virtual nodes a vertex has any number of copies", "[A7.7][fracture]")
{
    // Three cracks leave each corner of each tetrahedron alone. A rim vertex holds two copies
    // together, and with them a virtual copy of each end of the edge.
    for (const int n : {5, 40, 100, 300, 2000}) {
        CAPTURE(n);
        const TetrahedralMesh ring = ring_around_edge(n);
        Cracks cracks;
        for (int t = 0; t < n; ++t) {
            const std::array<Vector3d, 4> x = corners_of(ring, t);
            for (int c = 0; c < 3; ++c) { // halfway between a corner and the face opposite to it
                const Vector3d &p = x[(c + 1) % 4], &q = x[(c + 2) % 4], &r = x[(c + 3) % 4];
                const Vector3d normal = (q - p).cross(r - p).normalized();
                cracks.push_back({t, (x[c] + p) / 2, normal});
            }
        }
        const EmbeddedMesh result = embedded(ring, cracks);
        check_count(result.parents.size(), 4 * n, "copies, one for each corner");
        check_count(piece_count(result.mesh), n + 2, "pieces, one for each vertex");
    }
}

} // namespace fracture_fans_test
