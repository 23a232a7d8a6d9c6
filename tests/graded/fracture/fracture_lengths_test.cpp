// SPDX-License-Identifier: MIT
// A7.1 and A7.5 to A7.7: lists of every length, and meshes whose indices need more than 8, 16 or 20
// bits, so that a key made of several indices may be the same for different faces or edges.
#include "element_laws.hpp"
#include "fracture_laws.hpp"
#include "graded/laws/lengths.hpp"
#include "virtual_nodes_laws.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace rigor::testing::fracture_lengths_test {

namespace {

// Tetrahedra that share nothing, with these vertices, far from each other in a long list. The other
// vertices are unused.
TetrahedralMesh apart(const std::vector<Tetrahedron>& tetrahedra, std::size_t vertices)
{
    TetrahedralMesh mesh = {std::vector<Vector3d>(vertices, Vector3d(-9, -9, -9)), {}};
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
        const std::vector<Vector3d> corners = unit_tetrahedron().vertices;
        for (int i = 0; i < 4; ++i)
            mesh.vertices[tetrahedra[t][i]] =
                corners[i] + Vector3d(3.0 * static_cast<double>(t), 0, 0);
        mesh.tetrahedra.push_back(tetrahedra[t]);
    }
    return mesh;
}

// Numbers of indices with 8, 16 and 20 bits; of the latter, three fit into 64 bits.
constexpr int index_counts[] = {narrow, wide, 1 << 20};
// These, other powers of two, numbers for those who think in decimals, and the root of the largest
// index of 32 bits.
constexpr int all_counts[] = {narrow,    wide,    1 << 20, 128,     512,     1024,    2048,
                              4096,      1 << 13, 1 << 14, 1 << 15, 1 << 17, 1 << 18, 1 << 19,
                              500,       1000,    2000,    5000,    10000,   50000,   100'000,
                              1'000'000, 9'999,   46'341,  20'000,  65'535};

// Pairs of tetrahedra with faces, edges or vertices that become one if an index is kept modulo B,
// or if indices are added up with a factor B between them: (a, b + B, c) and (a + 1, b, c), the
// other way round (a + B, b, c) and (a, b + 1, c), and so on. A comment below names the face or
// edge with which one of this tetrahedron may be confused; up to multiples of B, it is one of the
// next tetrahedron.
TetrahedralMesh with_similar_indices(int B)
{
    constexpr int a = 10, b = a + 20, c = a + 40, d = a + 60;
    return apart({{a, b + B, c + B, d + B}, // as (a + 1, b + 1, c)
                  {a + 1, b + 1, c, d},
                  {a + 2, b + 2, c + 2, d + 2}, // their last bits are the same
                  {a + 2 + B, b + 2 + B, c + 2 + B, d + 2 + B},
                  {a + 4, b + 4 + B, c + 4 + B, d + 4 + B}, // an edge as (a + 5, b + 4)
                  {a + 5, b + 4, c + 5, d + 5},
                  {a + 6 + B, b + 6 + B, c + 6 + B, d + 6 + B}, // as (a + 6, b + 7, c + 7)
                  {a + 6, b + 7 + B, c + 7 + B, d + 7 + B},
                  {a + 8 + B, b + 8 + B, c + 8 + B, d + 8}, // two edges, in the other order
                  {a + 8, b + 9 + B, c + 9 + B, d + 9}},
                 static_cast<std::size_t>(B) + 3 * narrow);
}

using Triple = std::array<int, 3>;

// Pairs of faces that become one if an index is kept modulo B, or if the three indices are added
// up: with the factors B², B, 1; with 1, B, B²; or with no factors.
std::vector<std::array<Triple, 2>> similar_faces(int B)
{
    std::vector<std::array<Triple, 2>> result;
    const auto add = [&](const auto& pair) {
        const int a = 10 + 9 * static_cast<int>(result.size());
        result.push_back(pair(a, a + 3, a + 6));
    };
    using Pair = std::array<Triple, 2>;
    add([B](int a, int b, int c) { return Pair{{{a, b, c + B}, {a - 1, b + B, c + B}}}; });
    add([B](int a, int b, int c) { return Pair{{{a, b, c}, {a, b - 1, c + B}}}; });
    add([B](int a, int b, int c) { return Pair{{{a, b + B, c + B}, {a + B, b + B - 1, c + B}}}; });
    add([B](int a, int b, int c) { return Pair{{{a, b, c + B}, {a, b + B, c + B - 1}}}; });
    add([B](int a, int b, int c) { return Pair{{{a, b, c}, {a, b, c + B}}}; });
    add([B](int a, int b, int c) { return Pair{{{a, b, c}, {a, b + B, c + B}}}; });
    add([B](int a, int b, int c) { return Pair{{{a, b, c}, {a + B, b + B, c + B}}}; });
    add([](int a, int b, int c) { return Pair{{{a, b, c}, {a + 1, b - 1, c}}}; });
    return result;
}

// A mesh with two tetrahedra at each of these faces, and the first or second face of each pair.
std::pair<TetrahedralMesh, std::vector<MeshFace>> beside_similar_faces(int B, bool is_second)
{
    TetrahedralMesh mesh;
    mesh.vertices.assign(static_cast<std::size_t>(B) + narrow, Vector3d(-9, -9, -9));
    std::vector<MeshFace> named;
    for (const auto& pair : similar_faces(B))
        for (const Triple& face : pair) {
            // a slanted triangle at the place of its first index, one meter high for the second
            const double x = 3.0 * (face[0] % B), y = &face == &pair[1] ? 1 : 0;
            const Vector3d corners[] = {{x, y, 0}, {x + 1, y, 0}, {x, y, 1}};
            for (int i = 0; i < 3; ++i)
                mesh.vertices[face[i]] = corners[i];
            const int tip = static_cast<int>(mesh.vertices.size());
            mesh.vertices.emplace_back(x, y - 0.4, 0);
            mesh.vertices.emplace_back(x, y + 0.4, 0);
            if ((&face == &pair[1]) == is_second)
                named.push_back({static_cast<int>(mesh.tetrahedra.size()), 0});
            mesh.tetrahedra.push_back({tip, face[0], face[2], face[1]});
            mesh.tetrahedra.push_back({tip + 1, face[0], face[1], face[2]});
        }
    return {mesh, named};
}

// A hash of three indices by Teschner et al. (2003), "Optimized spatial hashing for collision
// detection of deformable objects". Its 32 bits tell most faces apart, but not all.
constexpr std::uint32_t spatial_hash(const Triple& t)
{
    return static_cast<std::uint32_t>(t[0]) * 73856093u ^
           static_cast<std::uint32_t>(t[1]) * 19349663u ^
           static_cast<std::uint32_t>(t[2]) * 83492791u;
}

} // namespace

TEST_CASE("fracture: an element with any number of neighbours", "[A7.1][fracture]")
{
    for (const int n : lengths(0, 65536)) {
        CAPTURE(n);
        std::vector<Matrix3d> stresses = {Matrix3d::Zero()};
        std::vector<double> volumes = {1};
        std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(n) + 1);
        double sum = 0, V = 1; // sums of integers are exact
        for (int i = 1; i <= n; ++i) {
            neighbours[0].push_back(i);
            stresses.push_back((1 + i % 11) * Matrix3d::Identity());
            volumes.push_back(1 + i % 7);
            sum += volumes.back() * (1 + i % 11);
            V += volumes.back();
        }
        const std::vector<Matrix3d> smooth = smooth_stress(stresses, neighbours, volumes);
        check_count(std::ssize(smooth), n + 1, "stresses, one for each element");
        REQUIRE_THAT(smooth[0](1, 1), IsClose(sum / V, Rounding(8 + n, 11)));
        REQUIRE_THAT(smooth.back(), IsClose(stresses.back(), Rounding(8)));
    }
}

TEST_CASE("fracture: neighbours with indices of many bits", "[A7.1][fracture]")
{
    constexpr int count = wide + 2 * narrow, first = 9;
    std::vector<Matrix3d> stresses(count, Matrix3d::Zero());
    std::vector<std::vector<int>> neighbours(count);
    const int others[] = {first + narrow, first + wide, first + wide + narrow};
    for (int i = 0; i < 3; ++i) {
        stresses[others[i]] = std::exp2(i) * Matrix3d::Identity();
        neighbours[first].push_back(others[i]);
    }
    const auto smooth = smooth_stress(stresses, neighbours, std::vector<double>(count, 1.0));
    REQUIRE_THAT(smooth[first](0, 0), IsClose(7.0 / 4, Rounding(16)));
}

TEST_CASE("fracture: neighbours in a long row count with the stresses that they had",
          "[A7.1][fracture]")
{
    constexpr int count = wide + 2 * narrow;
    std::vector<Matrix3d> stresses;
    std::vector<std::vector<int>> neighbours(count);
    for (int e = 0; e < count; ++e) {
        stresses.push_back(e % 11 * Matrix3d::Identity());
        for (const int other : {e - 1, e + 1})
            if (other >= 0 && other < count) neighbours[e].push_back(other);
    }
    const auto smooth = smooth_stress(stresses, neighbours, std::vector<double>(count, 1.0));
    std::vector<double> expected, found;
    for (int e = 1; e < count - 1; ++e) {
        found.push_back(smooth[e](2, 2));
        expected.push_back(((e - 1) % 11 + e % 11 + (e + 1) % 11) / 3.0);
    }
    REQUIRE_THAT(found, IsClose(expected, Rounding(16, 10)));
}

TEST_CASE("fracture: any number of faces cuts a bar into cubes", "[A7.5][fracture]")
{
    for (int n = 1; n <= 40; ++n)
        for (const bool is_odd : {false, true}) {
            CAPTURE(n, is_odd);
            const TetrahedralMesh bar = block(n, 1, 1);
            std::vector<MeshFace> faces;
            for (int x = 1; x < n; ++x) {
                const auto across = faces_where(bar, [x](const Vector3d& p) { return p.x() == x; });
                for (const MeshFace& face : across)
                    if (face.tetrahedron / 6 == x - 1) faces.push_back(face); // from the left
            }
            if (is_odd) faces.insert(faces.begin(), {0, 0}); // again a face of the first cut
            if (is_odd && n == 1) continue;
            const SplitMesh result = split_along_faces(bar, faces);
            check_count(piece_count(result.mesh), n, "pieces");
            check_piece_volumes(result.mesh, std::vector<double>(static_cast<std::size_t>(n), 1.0),
                                Rounding(64, n));
        }
}

TEST_CASE("fracture: along faces tetrahedra with similar indices", "[A7.5][fracture]")
{
    for (const int B : index_counts) {
        CAPTURE(B);
        const TetrahedralMesh mesh = with_similar_indices(B);
        std::vector<MeshFace> surface;
        for (int t = 0; t < tetrahedron_count(mesh); t += 3)
            surface.push_back({t, t % 4});
        for (const auto& faces : {std::vector<MeshFace>(), surface}) {
            const SplitMesh result = split_along_faces(mesh, faces);
            check_count(vertex_count(result.mesh), vertex_count(mesh), "vertices");
            check_same_vertices(result.mesh.tetrahedra, mesh.tetrahedra);
            REQUIRE_THAT(corners(result.mesh), IsExactly(corners(mesh)));
        }
    }
}

TEST_CASE("fracture: along a face between tetrahedra with similar indices", "[A7.5][fracture]")
{
    // The tetrahedra share the face (1, B + 1, B + 11). With the factors 1, B and B² between the
    // indices, their faces (B + 1, B + 9, B + 11) and (1, B + 10, B + 11) have the same sum.
    for (const int B : index_counts) {
        CAPTURE(B);
        const int a = 1, b = B + 1, c = B + 11, tip = B + 9, other = B + 10;
        TetrahedralMesh mesh;
        mesh.vertices.assign(static_cast<std::size_t>(B) + 20, Vector3d(-9, -9, -9));
        mesh.vertices[a] = {1, 0, 0};
        mesh.vertices[b] = {0, 1, 0};
        mesh.vertices[c] = {0, 0, 1};
        mesh.vertices[tip] = {0, 0, 0};
        mesh.vertices[other] = {1, 1, 1};
        mesh.tetrahedra = {{tip, a, b, c}, {other, a, c, b}};
        check_count(vertex_count(split_along_faces(mesh, {{1, 0}}).mesh), vertex_count(mesh) + 3,
                    "vertices, three of them doubled");
        check_count(vertex_count(split_along_faces(mesh, {}).mesh), vertex_count(mesh), "vertices");
    }
}

TEST_CASE("fracture: of faces with similar indices only those that are named open",
          "[A7.5][fracture]")
{
    for (const int B : all_counts)
        for (const bool is_second : {false, true}) {
            CAPTURE(B, is_second);
            const auto [mesh, faces] = beside_similar_faces(B, is_second);
            check_definition(mesh, faces, split_along_faces(mesh, faces));
        }
}

TEST_CASE("fracture: along faces whose indices have the same hash", "[A7.5][fracture]")
{
    constexpr Triple a = {23628, 26552, 35121}, b = {34508, 46862, 54635};
    static_assert(spatial_hash(a) == spatial_hash(b));
    const TetrahedralMesh mesh =
        apart({{a[0], a[1], a[2], 60000}, {b[0], b[1], b[2], 60001}}, 60002);
    const SplitMesh result = split_along_faces(mesh, {});
    check_count(vertex_count(result.mesh), vertex_count(mesh), "vertices");
    REQUIRE_THAT(corners(result.mesh), IsExactly(corners(mesh)));
}

TEST_CASE("fracture: a face that is named many times opens once", "[A7.5][fracture]")
{
    for (const int times : {1, 2, 3, 255, 256, 257, 65535, 65536}) {
        CAPTURE(times);
        for (const bool from_both : {false, true}) {
            std::vector<MeshFace> faces(static_cast<std::size_t>(times), MeshFace{0, 0});
            if (from_both) faces.insert(faces.end(), faces.size(), MeshFace{1, 0});
            const SplitMesh result = split_along_faces(two_tetrahedra(), faces);
            check_count(vertex_count(result.mesh), 8, "vertices");
            check_count(piece_count(result.mesh), 2, "pieces");
        }
    }
}

TEST_CASE("fracture: through elements tetrahedra with similar indices", "[A7.6][fracture]")
{
    for (const int B : all_counts) {
        if (B == 1 << 18 || B == 1 << 19) continue; // no usual width where a key is two indices
        CAPTURE(B);
        const TetrahedralMesh mesh = with_similar_indices(B);
        // from one corner, across the edge between two others
        const SplitMesh alone =
            split_element(unit_tetrahedron(), 0, Vector3d(1, -1, 0).normalized());
        // Calls with the longest list take long: one for each pair of similar tetrahedra is enough.
        const bool is_longest = B > wide;
        for (int t = 0; t < tetrahedron_count(mesh); t += is_longest ? 2 : 1)
            for (const int axis : {t % 3, (t + 1) % 3}) {
                if (is_longest && axis != t % 3) continue;
                CAPTURE(t, axis);
                const Vector3d n =
                    (Vector3d::Unit(axis) - Vector3d::Unit((axis + 1) % 3)).normalized();
                const SplitMesh result = split_element(mesh, mesh.tetrahedra[t][0], n);
                check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh) + 1,
                            "tetrahedra");
                check_count(vertex_count(result.mesh) - vertex_count(mesh),
                            vertex_count(alone.mesh) - 4, "new vertices");
                check_count(std::count(result.parents.begin(), result.parents.end(), t), 2,
                            "halves of the tetrahedron that was cut");
            }
    }
}

TEST_CASE("fracture: through edges with similar indices at one vertex", "[A7.6][fracture]")
{
    // Three tetrahedra around the edge (0, 4). The plane cuts the edges (1, B + 3) and (2, 3). With
    // the factors B and 1, their indices have one sum.
    for (const int B : all_counts) {
        CAPTURE(B);
        TetrahedralMesh mesh;
        mesh.vertices.assign(static_cast<std::size_t>(B) + 4, Vector3d(-9, -9, -9));
        const auto at = [](double degrees) {
            const double angle = degrees * std::numbers::pi / 180;
            return Vector3d(std::cos(angle), std::sin(angle), 0.1);
        };
        mesh.vertices[0] = {0, 0, -0.5};
        mesh.vertices[4] = {0, 0, 1};
        mesh.vertices[1] = at(60);
        mesh.vertices[2] = at(120);
        mesh.vertices[3] = at(-120);
        mesh.vertices[B + 3] = at(-60);
        mesh.tetrahedra = {{0, 4, B + 3, 1}, {0, 4, 3, B + 3}, {0, 4, 2, 3}};
        for (std::size_t t = 0; t < 3; ++t)
            if (volume(mesh, t) < 0) std::swap(mesh.tetrahedra[t][2], mesh.tetrahedra[t][3]);
        const SplitMesh result = split_element(mesh, 0, Vector3d::UnitY());
        check_new_vertices(mesh, result, 0, Vector3d::UnitY());
        check_count(tetrahedron_count(result.mesh), 5, "tetrahedra, two of them in halves");
    }
}

TEST_CASE("fracture: with virtual nodes tetrahedra with similar indices", "[A7.7][fracture]")
{
    for (const int B : all_counts) {
        CAPTURE(B);
        const TetrahedralMesh mesh = with_similar_indices(B);
        const EmbeddedMesh whole = virtual_nodes(mesh, {});
        check_count(vertex_count(whole.mesh), vertex_count(mesh), "vertices");
        check_same_vertices(whole.mesh.tetrahedra, mesh.tetrahedra);
        REQUIRE_THAT(corners(whole.mesh), IsExactly(corners(mesh)));
    }
}

TEST_CASE("fracture: any number of cracked elements", "[A7.7][fracture]")
{
    for (const int n : lengths(0, 1024)) {
        CAPTURE(n);
        TetrahedralMesh row;
        std::vector<ElementCrack> cracks;
        std::vector<double> shares;
        for (int i = 0; i < n; ++i) { // apart from each other
            const Vector3d at(3.0 * i, 0, 0);
            for (const Vector3d& x : unit_tetrahedron().vertices)
                row.vertices.push_back(at + x);
            row.tetrahedra.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
            cracks.push_back({i, at + Vector3d(0.5, 0, 0), Vector3d::UnitX()}); // cuts corner 1 off
            shares.insert(shares.end(), {0.875, 0.125});
        }
        const EmbeddedMesh result = virtual_nodes(row, cracks);
        check_count(tetrahedron_count(result.mesh), 2 * n, "tetrahedra");
        check_count(vertex_count(result.mesh), 8 * n, "vertices");
        REQUIRE_THAT(result.fractions, IsClose(shares, Rounding(64, 1)));
    }
}

TEST_CASE("fracture: any number of copies hang together", "[A7.7][fracture]")
{
    // A crack along a bar, z = 1/4, through all of its cubes or the last ones alone: each of their
    // tetrahedra has two copies, and each vertex is doubled, but not those where the crack ends.
    for (const int n : {1, 2, 5, 11, 22, 43, 100, 1000, 11'000}) {
        const int cracked = n <= 1000 ? n : 500;
        CAPTURE(n, cracked);
        const TetrahedralMesh bar = block(n, 1, 1);
        const auto is_last = [&](const Vector3d& x) { return x.x() > n - cracked; };
        const EmbeddedMesh result =
            virtual_nodes(bar, plane_through(bar, {0, 0, 0.25}, Vector3d::UnitZ(), is_last));
        check_count(result.parents.size(), 6 * (n + cracked), "copies");
        check_count(vertex_count(result.mesh), 4 * (n + 1 + cracked + (cracked == n ? 1 : 0)),
                    "vertices");
        check_count(piece_count(result.mesh), cracked == n ? 2 : 1, "pieces");
        if (cracked < n) continue;
        check_piece_matter(bar, result, std::vector{0.25 * n, 0.75 * n}, Rounding(64 + 6 * n, n));
    }
}

} // namespace rigor::testing::fracture_lengths_test
