// SPDX-License-Identifier: MIT
// A7.5: the mesh comes apart along its own faces.
#include "fracture_laws.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

namespace {

using Faces = std::vector<MeshFace>;

// Splits a mesh and checks what holds for every split along faces: no tetrahedron has changed.
SplitMesh split(const TetrahedralMesh& mesh, const Faces& faces)
{
    const SplitMesh result = split_along_faces(mesh, faces);
    check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh), "tetrahedra");
    check_indices(result.mesh);
    REQUIRE_THAT(corners(result.mesh), IsExactly(corners(mesh)));
    check_count(result.origins.size(), vertex_count(result.mesh), "origins, one for each vertex");
    check_count(result.parents.size(), tetrahedron_count(mesh),
                "parents, one for each tetrahedron");
    for (int t = 0; t < tetrahedron_count(mesh); ++t) {
        check_that(result.parents[t] == t, "the parent of a tetrahedron is this tetrahedron");
        for (int c = 0; c < 4; ++c) {
            const VertexOrigin& origin = result.origins[result.mesh.tetrahedra[t][c]];
            check_that(origin.first == mesh.tetrahedra[t][c] && origin.second == origin.first,
                       "the origin of a corner's vertex names, twice, the vertex before");
            REQUIRE_THAT(origin.fraction, IsExactly(0.0));
        }
    }
    return result;
}

void check_unchanged(const TetrahedralMesh& mesh, const Faces& faces)
{
    const SplitMesh result = split(mesh, faces);
    check_same_vertices(result.mesh.tetrahedra, mesh.tetrahedra);
}

// Random faces: each face is taken from each of its sides with the probability `chance`.
Faces random_faces(const TetrahedralMesh& mesh, Random& random, double chance)
{
    Faces result;
    for (int t = 0; t < tetrahedron_count(mesh); ++t)
        for (int f = 0; f < 4; ++f)
            if (random.uniform(0, 1) < chance) result.push_back({t, f});
    return result;
}

// The faces of several cracks.
Faces joined(const std::vector<Faces>& cracks)
{
    Faces result;
    for (const Faces& crack : cracks)
        result.insert(result.end(), crack.begin(), crack.end());
    return result;
}

Faces moved(const Faces& faces, const TetrahedralMesh& mesh, const Placed& at)
{
    Faces result;
    for (const auto& [t, f] : faces)
        result.push_back({at.tetrahedron[t], at.corner(t, mesh.tetrahedra[t][f])});
    return result;
}

// Four cracks that begin at one edge of a plate and end inside it.
void check_star()
{
    const TetrahedralMesh wide = block(4, 4, 1);
    const auto one = [](const Vector3d& x) { return x.x() == 2 && std::abs(x.y() - 2) <= 1; };
    const auto other = [](const Vector3d& x) { return x.y() == 2 && std::abs(x.x() - 2) <= 1; };
    const Faces star = joined({faces_where(wide, one), faces_where(wide, other)});
    everywhere(wide, [&](const Placed& at) {
        INFO("the ends of the edge in the middle are fourfold, and no other vertex is doubled");
        const SplitMesh result = split(at.mesh, moved(star, wide, at));
        check_count(vertex_count(result.mesh), vertex_count(wide) + 2 * 3, "vertices");
        check_count(piece_count(result.mesh), 1, "pieces");
        check_split(at.mesh, result);
    });
}

} // namespace

TEST_CASE("fracture: without faces a mesh stays as it is", "[A7.5][fracture]")
{
    check_unchanged(unit_tetrahedron(), {});
    check_unchanged(two_tetrahedra(), {});
    check_unchanged(block(2, 2, 1), {});
    check_unchanged({}, {});
}

TEST_CASE("fracture: a face of the surface changes nothing", "[A7.5][fracture]")
{
    check_unchanged(unit_tetrahedron(), {{0, 0}, {0, 1}, {0, 2}, {0, 3}});
    check_unchanged(two_tetrahedra(), {{0, 1}, {0, 2}, {0, 3}, {1, 1}, {1, 2}, {1, 3}});
    const TetrahedralMesh cube = block(2, 2, 2);
    check_unchanged(cube, faces_where(cube, [](const Vector3d& x) { return x.x() == 0; }));
}

TEST_CASE("fracture: two tetrahedra part at the face between them", "[A7.5][fracture]")
{
    // the face is named from one side, from the other, from both, and twice
    for (const Faces& faces :
         {Faces{{0, 0}}, Faces{{1, 0}}, Faces{{0, 0}, {1, 0}}, Faces{{1, 0}, {1, 0}, {0, 2}}}) {
        const SplitMesh result = split(two_tetrahedra(), faces);
        check_count(vertex_count(result.mesh), 8, "vertices");
        check_count(piece_count(result.mesh), 2, "pieces");
    }
}

TEST_CASE("fracture: a bar is cut across", "[A7.5][fracture]")
{
    const TetrahedralMesh bar = block(3, 1, 1);
    const Faces faces = faces_where(bar, [](const Vector3d& x) { return x.x() == 1; });
    everywhere(bar, [&](const Placed& at) {
        const SplitMesh result = split(at.mesh, moved(faces, bar, at));
        check_count(vertex_count(result.mesh), vertex_count(bar) + 4, "vertices");
        check_count(piece_count(result.mesh), 2, "pieces");
        const double cube = std::pow(at.length, 3);
        check_piece_volumes(result.mesh, std::vector{cube, 2 * cube},
                            Rounding(16, volume_scale(at.mesh)));
        check_split(at.mesh, result);
    });

    // a cut in steps: faces on the plane of one step that are not in the cut hold
    const TetrahedralMesh wide = block(3, 2, 1);
    const auto lower = [](const Vector3d& x) { return x.x() == 1 && x.y() <= 1; };
    const auto middle = [](const Vector3d& x) { return x.y() == 1 && x.x() >= 1 && x.x() <= 2; };
    const auto upper = [](const Vector3d& x) { return x.x() == 2 && x.y() >= 1; };
    const Faces steps =
        joined({faces_where(wide, lower), faces_where(wide, middle), faces_where(wide, upper)});
    everywhere(wide, [&](const Placed& at) {
        INFO("a cut in steps, whose pieces have equal volumes");
        const SplitMesh result = split(at.mesh, moved(steps, wide, at));
        check_count(vertex_count(result.mesh), vertex_count(wide) + 8, "vertices");
        check_count(piece_count(result.mesh), 2, "pieces");
        check_piece_volumes(result.mesh, std::vector<double>(2, 3 * std::pow(at.length, 3)),
                            Rounding(16, volume_scale(at.mesh)));
        check_split(at.mesh, result);
    });
}

TEST_CASE("fracture: one face inside a solid stays closed", "[A7.5][fracture]")
{
    const TetrahedralMesh cube = block(3, 3, 3);
    const Faces inside = faces_where(cube, [](const Vector3d& x) {
        return x.minCoeff() >= 1 && x.maxCoeff() <= 2; // a face of the cell in the middle
    });
    check_count(inside.size(), 24 + 12, "faces of the cell in the middle");
    for (const MeshFace& face : inside)
        check_unchanged(cube, {face});
}

TEST_CASE("fracture: the rim of a crack stays closed", "[A7.5][fracture]")
{
    // a disc of all faces around one inner vertex: only that vertex is doubled
    const TetrahedralMesh block_of_32 = block(2, 4, 4);
    const int middle = block_vertex(2, 4, 1, 2, 2);
    Faces disc;
    for (const MeshFace& face :
         faces_where(block_of_32, [](const Vector3d& x) { return x.x() == 1; })) {
        const auto vertices = face_vertices(block_of_32.tetrahedra[face.tetrahedron], face.face);
        if (std::count(vertices.begin(), vertices.end(), middle) == 1) disc.push_back(face);
    }
    const SplitMesh opened = split(block_of_32, disc);
    check_count(vertex_count(opened.mesh), vertex_count(block_of_32) + 1, "vertices");
    check_count(piece_count(opened.mesh), 1, "pieces");
    check_split(block_of_32, opened);

    const TetrahedralMesh cube = block(2, 2, 2);
    // the crack goes from the side y = 0 half way: the three vertices of that side are doubled
    const SplitMesh half =
        split(cube, faces_where(cube, [](const Vector3d& x) { return x.x() == 1 && x.y() <= 1; }));
    check_count(vertex_count(half.mesh), 30, "vertices");
    check_count(piece_count(half.mesh), 1, "pieces");
    std::set<int> doubled, seen;
    for (const VertexOrigin& origin : half.origins)
        if (!seen.insert(origin.first).second) doubled.insert(origin.first);
    check_that(doubled == std::set<int>{block_vertex(2, 2, 1, 0, 0), block_vertex(2, 2, 1, 0, 1),
                                        block_vertex(2, 2, 1, 0, 2)},
               "the three vertices of the crack on the side y = 0 are doubled, and no other");
    check_split(cube, half);
}

TEST_CASE("fracture: cracks that cross make a vertex fourfold", "[A7.5][fracture]")
{
    const TetrahedralMesh plate = block(2, 2, 1);
    const Faces across = faces_where(plate, [](const Vector3d& x) { return x.x() == 1; });
    const Faces cross =
        joined({across, faces_where(plate, [](const Vector3d& x) { return x.y() == 1; })});
    const Faces branch = joined(
        {across, faces_where(plate, [](const Vector3d& x) { return x.y() == 1 && x.x() <= 1; })});
    everywhere(plate, [&](const Placed& at) {
        const double cube = std::pow(at.length, 3);
        const Tolerance rounding = Rounding(16, volume_scale(at.mesh));
        const SplitMesh crossed = split(at.mesh, moved(cross, plate, at));
        check_count(vertex_count(crossed.mesh), 4 * 8, "vertices");
        check_count(piece_count(crossed.mesh), 4, "pieces");
        check_piece_volumes(crossed.mesh, std::vector<double>(4, cube), rounding);

        INFO("where a crack ends at another one, a vertex is threefold");
        const SplitMesh branched = split(at.mesh, moved(branch, plate, at));
        check_count(vertex_count(branched.mesh), 2 * 8 + 12, "vertices");
        check_count(piece_count(branched.mesh), 3, "pieces");
        check_piece_volumes(branched.mesh, std::vector{cube, cube, 2 * cube}, rounding);
    });
    check_star();
}

TEST_CASE("fracture: a crack that turns a corner frees a quarter", "[A7.5][fracture]")
{
    const TetrahedralMesh plate = block(2, 2, 1);
    const SplitMesh result =
        split(plate, faces_where(plate, [](const Vector3d& x) {
                  return (x.x() == 1 && x.y() <= 1) || (x.y() == 1 && x.x() <= 1);
              }));
    check_count(piece_count(result.mesh), 2, "pieces");
    check_count(vertex_count(result.mesh), 18 + 6, "vertices");
    check_piece_volumes(result.mesh, std::vector{1.0, 3.0}, Rounding(16, 3));
}

TEST_CASE("fracture: an edge does not hold tetrahedra together", "[A7.5][fracture]")
{
    // eight tetrahedra are around the middle; all faces on x = 0 and on y = 0 leave four pairs
    const TetrahedralMesh mesh = octahedron();
    Faces faces = faces_where(mesh, [](const Vector3d& x) { return x.x() == 0; });
    const Faces other = faces_where(mesh, [](const Vector3d& x) { return x.y() == 0; });
    faces.insert(faces.end(), other.begin(), other.end());
    const SplitMesh result = split(mesh, faces);
    check_count(piece_count(result.mesh), 4, "pieces");
    check_count(vertex_count(result.mesh), 4 * 5, "vertices");
}

TEST_CASE("fracture: with every face cut each tetrahedron is alone", "[A7.5][fracture]")
{
    const TetrahedralMesh cube = block(2, 1, 1);
    const SplitMesh result = split(cube, faces_where(cube, [](const Vector3d&) { return true; }));
    check_count(vertex_count(result.mesh), 4 * 12, "vertices");
    check_count(piece_count(result.mesh), 12, "pieces");
}

TEST_CASE("fracture: what is cut out of the inside comes off", "[A7.5][fracture]")
{
    // One or several tetrahedra, the first of which has no vertex on the surface: all faces between
    // those that are cut out and the others are cut.
    const TetrahedralMesh mesh = block(3, 3, 3);
    std::vector<int> inside;
    for (int t = 0; t < tetrahedron_count(mesh); ++t)
        if (std::all_of(mesh.tetrahedra[t].begin(), mesh.tetrahedra[t].end(), [&](int v) {
                const Vector3d& x = mesh.vertices[v];
                return x.minCoeff() > 0.5 && x.maxCoeff() < 2.5;
            }))
            inside.push_back(t);
    for (Random random : seeds(60)) {
        const int wanted = 1 + random_index(random, 4);
        std::set<int> out = {inside[random_index(random, inside.size())]};
        const auto neighbours = links_through_faces(mesh, [](const auto&) { return true; });
        for (int tries = 0; std::ssize(out) < wanted && tries < 1000; ++tries) {
            const auto& [one, other] = neighbours[random_index(random, neighbours.size())];
            if (out.contains(one / 4)) out.insert(other / 4);
        }
        std::map<std::array<int, 3>, int> sides; // how many sides of a face are cut out
        for (const int t : out)
            for (int f = 0; f < 4; ++f)
                ++sides[face_vertices(mesh.tetrahedra[t], f)];
        Faces faces;
        for (const int t : out)
            for (int f = 0; f < 4; ++f)
                if (sides[face_vertices(mesh.tetrahedra[t], f)] == 1) faces.push_back({t, f});
        const SplitMesh result = split(mesh, faces);
        CAPTURE(wanted);
        check_definition(mesh, faces, result);
        check_split(mesh, result);
    }
}

TEST_CASE("fracture: what faces hold together is one vertex and nothing else is",
          "[A7.5][fracture][property]")
{
    for (Random random : seeds(40)) {
        const TetrahedralMesh mesh = jiggled(block(2, 2, 2), random);
        const Faces faces = random_faces(mesh, random, random.uniform(0, 0.5));
        const SplitMesh result = split(mesh, faces);
        check_definition(mesh, faces, result);
        check_split(mesh, result);
    }
}

TEST_CASE("fracture: one or two faces of a solid that has cracks already",
          "[A7.5][fracture][property]")
{
    // A face may have edges on the surface although no face of its tetrahedra is on the surface.
    for (Random random : seeds(3)) {
        const TetrahedralMesh whole = block(3, 3, 2);
        const TetrahedralMesh mesh =
            parted(whole, random_faces(whole, random, random.uniform(0, 0.2)));
        const Faces inside = random_faces(mesh, random, 0.5);
        for (std::size_t i = 0; i + 1 < inside.size(); ++i)
            for (const Faces& faces : {Faces{inside[i]}, Faces{inside[i], inside[i + 1]}}) {
                CAPTURE(i, faces.size());
                check_definition(mesh, faces, split_along_faces(mesh, faces));
            }
    }
}

TEST_CASE("fracture: cutting again changes nothing", "[A7.5][fracture][property]")
{
    for (Random random : seeds(20)) {
        const TetrahedralMesh mesh = jiggled(block(2, 2, 2), random);
        const Faces faces = random_faces(mesh, random, 0.3);
        check_unchanged(split(mesh, faces).mesh, faces);
    }
}

TEST_CASE("fracture: a face that stayed closed is no crack the next time", "[A7.5][fracture]")
{
    // the mesh splits along one of the two faces across a bar, and then along the other
    const TetrahedralMesh bar = block(2, 1, 1);
    const Faces across = faces_where(bar, [](const Vector3d& x) { return x.x() == 1; });
    check_count(across.size(), 4, "sides of the two faces across the bar");
    Faces first, second;
    for (const MeshFace& face : across)
        (face_vertices(bar.tetrahedra[face.tetrahedron], face.face) ==
                 face_vertices(bar.tetrahedra[across[0].tetrahedron], across[0].face)
             ? first
             : second)
            .push_back(face);
    // each face has one vertex that the other has not; the diagonal that both share stays closed
    // until both are open
    const SplitMesh once = split(bar, first);
    check_count(vertex_count(once.mesh), vertex_count(bar) + 1, "vertices");
    const SplitMesh twice = split(once.mesh, second);
    check_count(vertex_count(twice.mesh), vertex_count(bar) + 4, "vertices");
    check_count(piece_count(twice.mesh), 2, "pieces");
}

TEST_CASE("fracture: the way a mesh is numbered does not matter to its faces",
          "[A7.5][fracture][property]")
{
    for (Random random : seeds(20)) {
        const TetrahedralMesh mesh = jiggled(block(2, 2, 2), random);
        const Faces faces = random_faces(mesh, random, 0.3);
        const Renumbered other = renumbered(mesh, random);
        Faces same;
        for (const MeshFace& face : faces)
            same.push_back({other.tetrahedron[face.tetrahedron], face.face});
        std::reverse(same.begin(), same.end());

        const SplitMesh result = split(mesh, faces), renamed = split(other.mesh, same);
        std::vector<Tetrahedron> back(mesh.tetrahedra.size());
        for (std::size_t t = 0; t < back.size(); ++t)
            back[t] = renamed.mesh.tetrahedra[other.tetrahedron[t]];
        check_same_vertices(back, result.mesh.tetrahedra);
    }
}

TEST_CASE("fracture: a large mesh is cut through", "[A7.5][fracture]")
{
    const TetrahedralMesh cube = block(16, 16, 16); // 24576 tetrahedra
    const SplitMesh result =
        split_along_faces(cube, faces_where(cube, [](const Vector3d& x) { return x.z() == 8; }));
    check_count(vertex_count(result.mesh), 18 * 17 * 17, "vertices");
    check_count(tetrahedron_count(result.mesh), tetrahedron_count(cube), "tetrahedra");
    check_count(piece_count(result.mesh), 2, "pieces");
}

} // namespace rigor::testing
