// SPDX-License-Identifier: MIT
// A7.5 to A7.7: a solid is cut by the mesh and the cracks of the call alone, however much of them
// an earlier call had too: all but one tetrahedron, all but one crack, and even their sums.
#include "element_laws.hpp"
#include "fracture_laws.hpp"
#include "virtual_nodes_laws.hpp"

#include <algorithm>

namespace rigor::testing::fracture_memory_test {

namespace {

// Pairs of tetrahedra apart from each other. The two of a pair have a face in common, or lie on
// both sides of an earlier crack: then the second one has other vertices at the same places. So
// all solids with as many pairs have the same vertices, some of which may be unused. The sum of all
// indices depends only on how many pairs are joined.
struct Pairs {
    std::vector<bool> is_joined; // for each pair
    std::vector<bool> is_cut;    // whether the crack of a pair cuts it or lies beside it
    int turn = 0;                // the list of tetrahedra begins with this one
    double height = 1;           // along z [m]
    double depth = 0.5;          // where cracks cut a pair, along x [m]

    int size() const { return static_cast<int>(is_joined.size()); }
    int tetrahedron(int pair, int side) const { return (2 * pair + side + turn) % (2 * size()); }

    TetrahedralMesh mesh() const
    {
        TetrahedralMesh result;
        result.tetrahedra.resize(2 * is_joined.size());
        const std::vector<Vector3d> five = two_tetrahedra().vertices;
        for (int p = 0; p < size(); ++p) {
            const int o = 8 * p;
            for (const int v : {0, 1, 2, 3, 4, 1, 2, 3})
                result.vertices.push_back(five[v].cwiseProduct(Vector3d(1, 1, height)) +
                                          Vector3d(3 * p, 0, 0));
            const int own = is_joined[p] ? 1 : 5; // the first vertex of the face of the second one
            result.tetrahedra[tetrahedron(p, 0)] = {o, o + 1, o + 2, o + 3};
            result.tetrahedra[tetrahedron(p, 1)] = {o + 4, o + own, o + own + 2, o + own + 1};
        }
        return result;
    }
    // The face inside each pair, or another one of the same tetrahedron.
    std::vector<MeshFace> faces() const
    {
        std::vector<MeshFace> result;
        for (int p = 0; p < size(); ++p)
            result.push_back({tetrahedron(p, 0), is_cut[p] ? 0 : 1});
        return result;
    }
    // A plane through both tetrahedra of each pair, or one beside them.
    Cracks cracks() const
    {
        Cracks result;
        for (int p = 0; p < size(); ++p)
            for (const int side : {0, 1})
                result.push_back({tetrahedron(p, side),
                                  Vector3d(3 * p + (is_cut[p] ? depth : 2), 0, 0),
                                  Vector3d::UnitX()});
        return result;
    }
};

// A solid, and after it one that is equal but for a single pair, for two pairs that are exchanged,
// for all pairs but one, for its height, for the depth of its cracks, or for where its list begins;
// then the solid again, and so on.
std::vector<Pairs> similar_solids(Random& random, int size)
{
    Pairs first;
    for (int p = 0; p < size; ++p) {
        first.is_joined.push_back(random.bits() % 2 == 0);
        first.is_cut.push_back(random.bits() % 2 == 0);
    }
    first.turn = random_index(random, 2 * size);
    std::vector<Pairs> result;
    const auto add = [&](auto change) {
        Pairs other = first;
        for (int p = 0; p < size; ++p)
            change(other, p);
        result.insert(result.end(), {first, other, first});
    };
    for (int one = 0; one < size; ++one) {
        const auto flip = [](std::vector<bool>& list, int p) { list[p] = !list[p]; };
        add([&](Pairs& solid, int p) {
            if (p == one) flip(solid.is_joined, p);
        });
        add([&](Pairs& solid, int p) {
            if (p == one) flip(solid.is_cut, p);
        });
        add([&](Pairs& solid, int p) {
            if (p != one) flip(solid.is_joined, p);
        });
        const int two = random_index(random, size);
        add([&](Pairs& solid, int p) { // two pairs are exchanged
            if (p == one) solid.is_joined[p] = first.is_joined[two];
            if (p == two) solid.is_joined[p] = first.is_joined[one];
        });
        add([&](Pairs& solid, int p) {
            if (p == one) solid.is_cut[p] = first.is_cut[two];
            if (p == two) solid.is_cut[p] = first.is_cut[one];
        });
    }
    add([](Pairs& solid, int) { solid.height = 2; });
    add([](Pairs& solid, int) { solid.depth = 0.25; });
    add([](Pairs& solid, int p) { solid.turn += p == 0; });
    return result;
}

template <class Check> void for_similar_solids(Check check)
{
    for (const int size : {2, 3, 5, 12})
        for (Random random : seeds(size < 12 ? 3 : 1)) {
            int number = 0;
            for (const Pairs& solid : similar_solids(random, size)) {
                CAPTURE(size, number++);
                check(solid);
            }
        }
}

} // namespace

TEST_CASE("fracture: along faces nothing of an earlier solid is remembered", "[A7.5][fracture]")
{
    for_similar_solids([](const Pairs& solid) {
        const TetrahedralMesh mesh = solid.mesh();
        const SplitMesh result = split_along_faces(mesh, solid.faces());
        check_definition(mesh, solid.faces(), result);
        REQUIRE_THAT(corners(result.mesh), IsExactly(corners(mesh)));
    });
}

TEST_CASE("fracture: through elements nothing of an earlier solid is remembered",
          "[A7.6][fracture]")
{
    // the plane has two corners of a tetrahedron and halves the edge between the others, in both
    // tetrahedra of the pair if they are joined
    const Vector3d n = Vector3d(1, -1, 0).normalized();
    for_similar_solids([&](const Pairs& solid) {
        const TetrahedralMesh mesh = solid.mesh();
        const int p = static_cast<int>(std::find(solid.is_cut.begin(), solid.is_cut.end(), true) -
                                       solid.is_cut.begin()) %
                      solid.size();
        const SplitMesh result = split_element(mesh, 8 * p, n);
        check_new_vertices(mesh, result, 8 * p, n);
        for (std::size_t v = 0; v < result.origins.size(); ++v) {
            const auto& [first, second, t] = result.origins[v];
            const Vector3d place = (1 - t) * mesh.vertices[first] + t * mesh.vertices[second];
            INFO("where a vertex is, by its origin");
            REQUIRE_THAT(result.mesh.vertices[v], IsClose(place, Rounding(8, size_of(mesh))));
        }
        for (const int side : {0, 1})
            check_count(std::count(result.parents.begin(), result.parents.end(),
                                   solid.tetrahedron(p, side)),
                        side == 0 || solid.is_joined[p] ? 2 : 1,
                        "parts of a tetrahedron beside the plane");
        check_count(tetrahedron_count(result.mesh),
                    tetrahedron_count(mesh) + (solid.is_joined[p] ? 2 : 1), "tetrahedra");
    });
}

TEST_CASE("fracture: with virtual nodes nothing of an earlier solid is remembered",
          "[A7.7][fracture]")
{
    for_similar_solids([](const Pairs& solid) {
        const TetrahedralMesh mesh = solid.mesh();
        EmbeddedMesh result = virtual_nodes(mesh, solid.cracks());
        const auto joined = std::count(solid.is_joined.begin(), solid.is_joined.end(), true);
        check_count(tetrahedron_count(result.mesh), std::ssize(result.parents),
                    "tetrahedra, one for each parent");
        check_count(result.real.size(), std::ssize(result.parents),
                    "rows of `real`, one for each copy");
        check_that(vertex_count(result.mesh) >= vertex_count(mesh),
                   "at least the vertices of the mesh before, some of them unused");
        check_copies(mesh, solid.cracks(), result);
        const double x = solid.depth;
        const double beyond[] = // shares of the two beyond a crack
            {(1 - x) * (1 - x) * (1 - x), 1 - x * x * (3 - 2 * x)};
        std::vector<double> shares(result.parents.size(), 1.0);
        for (int p = 0; p < solid.size(); ++p)
            for (const int side : {0, 1})
                for (std::size_t i = 0; i < shares.size(); ++i) {
                    if (result.parents[i] != solid.tetrahedron(p, side) || !solid.is_cut[p])
                        continue;
                    // corner 1 of either tetrahedron is at x = 1
                    shares[i] = result.real[i][1] == 1 ? beyond[side] : 1 - beyond[side];
                }
        check_shares(result, shares, Rounding(32, 1));
        for (std::size_t i = 0; i < shares.size(); ++i)
            REQUIRE_THAT(corners_of(result.mesh, static_cast<int>(i)),
                         IsExactly(corners_of(mesh, result.parents[i])));
        result.mesh.vertices.resize(result.mesh.vertices.size() -
                                    3 * static_cast<std::size_t>(joined)); // the unused ones
        check_vertices(mesh, result);
        for (std::size_t i = 0; i < result.parents.size(); ++i)
            for (int c = 0; c < 4; ++c)
                check_that(result.vertex_parents[result.mesh.tetrahedra[i][c]] ==
                               mesh.tetrahedra[result.parents[i]][c],
                           "a corner of a copy comes from that corner of its parent");
    });
}

} // namespace rigor::testing::fracture_memory_test
