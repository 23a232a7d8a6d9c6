// SPDX-License-Identifier: MIT
// A7: many neighbors and many elements, small neighbors under a high stress, a threshold that is
// met exactly, which edges decide what is near a plane, where a plane crosses an edge, and planes
// that are nearly along an axis.
#include "element_laws.hpp"
#include "formulas/fracture.hpp"
#include "fracture_laws.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <numeric>

namespace fracture_strata_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("fracture: an element may have any number of neighbours", "[A7.1][fracture]")
{
    for (const int n : {3, 4, 5, 12, 500}) {
        CAPTURE(n);
        const std::vector<Matrix3d> stresses(static_cast<std::size_t>(n) + 1, Matrix3d::Identity());
        std::vector<Matrix3d> one = stresses;
        std::vector<std::vector<int>> neighbours(one.size());
        for (int i = 1; i <= n; ++i)
            neighbours[0].push_back(i);
        one[n].setZero(); // the last neighbor
        const std::vector<double> volumes(one.size(), 1.0);
        REQUIRE_THAT(smooth_stress(one, neighbours, volumes)[0],
                     IsClose(Matrix3d(n / (n + 1.0) * Matrix3d::Identity()), Rounding(4.0 * n)));
    }
}

TEST_CASE("fracture: each entry among the neighbours counts", "[A7.1][fracture]")
{
    // entries that repeat others or the element itself count like further elements
    for (Random random : seeds(30)) {
        std::vector<Matrix3d> stresses;
        std::vector<double> volumes;
        for (int i = 0; i < 3; ++i) {
            stresses.push_back(random.positive_definite());
            volumes.push_back(random.mass());
        }
        std::vector<int> entries;
        Matrix3d sum = volumes[0] * stresses[0];
        double V = volumes[0], scale = sum.norm();
        for (int n = 0; n < 6; ++n) {
            const std::size_t e = random.bits() % 3;
            entries.push_back(static_cast<int>(e));
            sum += volumes[e] * stresses[e];
            V += volumes[e];
            scale += volumes[e] * stresses[e].norm();
            REQUIRE_THAT(smooth_stress(stresses, {entries, {}, {}}, volumes)[0],
                         IsClose(Matrix3d(sum / V), Rounding(128, scale / V)));
        }
        REQUIRE_THAT(smooth_stress(stresses, {{}, {1, 1}, {}}, volumes)[1],
                     IsClose(stresses[1], Rounding(32)));
    }
}

namespace {

using Lists = std::vector<std::vector<int>>;

// The neighbors of n elements. An element may name others that do not name it.
Lists one_way_lists(int n, Random& random)
{
    Lists lists(static_cast<std::size_t>(n));
    const int kind = random_index(random, 3), rounds = 1 + random_index(random, 3);
    for (int round = 0; round < rounds; ++round) {
        const std::vector<int> order = permutation(random, lists.size());
        int at = order[0]; // a walk from element to element
        for (int i = 1; i <= n; ++i) {
            const int any = random_index(random, lists.size());
            // The first kind of walk visits all elements and returns, the second one any elements
            // and returns, so that each is named as often as it names others. The third one ends
            // anywhere.
            const int next = kind == 0 || (kind == 1 && i == n) ? order[i % n] : any;
            lists[at].push_back(next);
            at = next;
        }
    }
    return lists;
}

} // namespace

TEST_CASE("fracture: an element has the neighbours that its own list names", "[A7.1][fracture]")
{
    for (Random random : seeds(60)) {
        const int n = 2 + random_index(random, 7);
        const Lists neighbours = one_way_lists(n, random);
        std::vector<Matrix3d> stresses;
        std::vector<double> volumes;
        for (int i = 0; i < n; ++i) {
            stresses.push_back(random.positive_definite());
            volumes.push_back(random.mass());
        }
        const std::vector<Matrix3d> smooth = smooth_stress(stresses, neighbours, volumes);
        check_count(smooth.size(), n, "stresses, one for each element");
        for (std::size_t e = 0; e < smooth.size(); ++e) {
            CAPTURE(e, neighbours[e]);
            Matrix3d sum = Matrix3d::Zero();
            double V = 0, scale = 0;
            for (int k = 0; k < n; ++k) { // each element as often as the list names it
                const auto& list = neighbours[e];
                const auto times = std::count(list.begin(), list.end(), k);
                const double weight =
                    volumes[k] * static_cast<double>(times + (k == static_cast<int>(e) ? 1 : 0));
                sum += weight * stresses[k];
                V += weight;
                scale += weight * stresses[k].norm();
            }
            REQUIRE_THAT(smooth[e], IsClose(Matrix3d(sum / V), Rounding(256, scale / V)));
        }
    }
}

TEST_CASE("fracture: a small neighbour under a high stress counts", "[A7.1][fracture]")
{
    for (int power = 1; power <= 48; ++power) {
        CAPTURE(power);
        const double small = std::ldexp(1, -power);
        const auto smooth =
            smooth_stress({Matrix3d::Zero(), Matrix3d::Identity() / small}, {{1}, {0}}, {1, small});
        const Matrix3d mean = Matrix3d::Identity() / (1 + small);
        REQUIRE_THAT(smooth[0], IsClose(mean, Rounding(16)));
        // A running mean begins with the high stress.
        REQUIRE_THAT(smooth[1], IsClose(mean, Rounding(16, 1 / small)));
    }
}

TEST_CASE("fracture: the stress of every element of many is smoothed", "[A7.1][fracture]")
{
    constexpr int n = 4000; // a ring, in which every second element is under stress
    std::vector<Matrix3d> stresses;
    std::vector<std::vector<int>> neighbours;
    for (int i = 0; i < n; ++i) {
        stresses.push_back((i % 2) * Matrix3d::Identity());
        neighbours.push_back({(i + 1) % n, (i + n - 1) % n});
    }
    const auto smooth = smooth_stress(stresses, neighbours, std::vector<double>(n, 1.0));
    check_count(smooth.size(), n, "stresses, one for each element");
    for (int i = 0; i < n; ++i)
        REQUIRE_THAT(smooth[i](0, 0), IsClose(i % 2 == 0 ? 2.0 / 3 : 1.0 / 3, Rounding(16)));
}

TEST_CASE("fracture: elements after one without volume are smoothed too", "[A7.1][fracture]")
{
    // Six elements in pairs of neighbors, but the element `empty` and its partner are no
    // neighbors, and `empty` has no volume.
    for (std::size_t empty : {0, 2, 4}) {
        CAPTURE(empty);
        std::vector<Matrix3d> stresses(6, Matrix3d::Zero());
        std::vector<double> volumes(6, 1.0);
        std::vector<std::vector<int>> neighbours(6);
        for (std::size_t e = 0; e < 6; ++e) {
            const bool is_pair = e / 2 != empty / 2;
            if (is_pair) neighbours[e].push_back(static_cast<int>(e % 2 == 0 ? e + 1 : e - 1));
            if (is_pair && e % 2 == 0) stresses[e].setIdentity();
        }
        stresses[empty] = 3 * Matrix3d::Identity();
        volumes[empty] = 0;
        const auto smooth = smooth_stress(stresses, neighbours, volumes);
        for (std::size_t e = 0; e < 6; ++e) {
            const double share = e / 2 != empty / 2 ? 0.5 : e == empty ? 3 : 0;
            REQUIRE_THAT(smooth[e],
                         IsClose(Matrix3d(share * Matrix3d::Identity()), Rounding(8, 1)));
        }
    }
}

TEST_CASE("fracture: a stress equal to the threshold opens no crack", "[A7.3][fracture]")
{
    for (const double stress : {0x1p-40, 1.0, 4.0, 0x1p40}) {
        CAPTURE(stress);
        const Matrix3d sigma = Vector3d(stress / 4, stress, -stress).asDiagonal();
        check_that(!crack_plane(sigma, stress).has_value(),
                   "no crack, where σ₁ is as large as the strength");
        check_that(crack_plane(sigma, stress * (1 - 0x1p-40)).has_value(),
                   "a crack, where σ₁ is a little larger than the strength");
    }
}

namespace {

// Two tetrahedra around vertex 0 with a face in common. Vertex 1 is `height` above the plane
// through vertex 0 that is perpendicular to y; the others are below it. The longest edge leads from
// vertex 0 to vertex 4.
TetrahedralMesh near_and_long(double height, double longest)
{
    TetrahedralMesh mesh = {
        {{0, 0, 0}, {0, height, 1}, {1, -2, 0}, {-1, -2, 0}, {0, -0.6 * longest, -0.8 * longest}},
        {}};
    for (const Tetrahedron& t : {Tetrahedron{0, 1, 2, 3}, Tetrahedron{0, 4, 2, 3}}) {
        mesh.tetrahedra.push_back(t);
        if (volume(mesh, mesh.tetrahedra.size() - 1) < 0)
            std::swap(mesh.tetrahedra.back()[2], mesh.tetrahedra.back()[3]);
    }
    return mesh;
}

} // namespace

TEST_CASE("fracture: the longest edge of all tetrahedra of the vertex decides", "[A7.6][fracture]")
{
    // The other tetrahedron has an edge of 20 m, or of any length near that, and that of vertex 1
    // none as long. The heights approach the limit, 0.05 of this length, from both sides. None
    // meets it: 0.05 has no exact binary form, so 0.05 · 20 is 1 in doubles and larger than 1 in a
    // type with more digits.
    std::vector<double> ratios = {0.25}; // heights, divided by the limit
    for (int power = 1; power <= 44; ++power) {
        ratios.push_back(1 - std::ldexp(1, -power));
        ratios.push_back(1 + std::ldexp(1, -power));
    }
    std::vector<double> lengths = {20};
    for (Random random : seeds(8))
        lengths.push_back(random.uniform(15, 25));
    for (const double longest : lengths)
        for (const double ratio : ratios) {
            CAPTURE(longest, ratio);
            const TetrahedralMesh mesh = near_and_long(0.05 * longest * ratio, longest);
            const SplitMesh result = split_element(mesh, 0, Vector3d::UnitY());
            const bool cuts = ratio > 1; // less than 0.05 of the edge would be on the plane
            check_that((vertex_count(result.mesh) > vertex_count(mesh)) == cuts,
                       cuts ? "new vertices, since the plane cuts" : "no new vertex");
            check_count(piece_count(result.mesh), cuts ? 2 : 1, "pieces");
        }
}

namespace {

// Cuts an edge of 1 m at the fraction t from its upper end, vertex 1. The vertices 0 and 3 lie on
// the plane.
void check_crossing(double t)
{
    const TetrahedralMesh mesh = {{{0, 0, 0}, {0.5, 0, t}, {0.5, 0, t - 1}, {0, 0.5, 0}},
                                  {{0, 1, 2, 3}}};
    for (const Vector3d& n : {Vector3d(0, 0, 1), Vector3d(0, 0, -1)}) {
        const SplitMesh result = split_element(mesh, 0, n);
        check_new_vertices(mesh, result, 0, n);
        check_count(tetrahedron_count(result.mesh), 2, "tetrahedra");
        for (std::size_t v = 0; v < result.origins.size(); ++v) {
            if (result.origins[v].first == result.origins[v].second) continue;
            INFO("the height of a new vertex above the plane [m]");
            REQUIRE_THAT(result.mesh.vertices[v].z(), IsClose(0.0, Rounding(32, 1)));
        }
    }
}

} // namespace

TEST_CASE("fracture: a plane may cross an edge anywhere", "[A7.6][fracture]")
{
    for (int whole = 2; whole <= 12; ++whole)
        for (int part = 1; part < whole; ++part)
            for (int power = 4; std::gcd(part, whole) == 1 && power <= 40; power += 2)
                for (const double off : {std::ldexp(1, -power), std::ldexp(-1, -power)}) {
                    const double t = static_cast<double>(part) / whole + off;
                    if (t < 0.07 || t > 0.93) continue; // an end would count as on the plane
                    CAPTURE(part, whole, off);
                    check_crossing(t);
                }
}

TEST_CASE("fracture: any edge of a tetrahedron may be the longest", "[A7.6][fracture]")
{
    // Vertex 1 is `height` above the plane through vertex 0, the others are below it. One edge has
    // about 20 m, and the second longest about 10 m: 0.75 is less than 0.05 of the longest alone.
    for (const double height : {0.75, 1.25})
        for (const std::array<Vector3d, 4>& x :
             {std::array{Vector3d(0, 0, 0), Vector3d(0, height, 1), Vector3d(10, -2, 0),
                         Vector3d(-10, -2, 0)},
              std::array{Vector3d(0, 0, 0), Vector3d(10, height, 0), Vector3d(-10, -2, 1),
                         Vector3d(0, -2, -2)},
              std::array{Vector3d(0, 0, 0), Vector3d(10, height, 1), Vector3d(20, -2, 0),
                         Vector3d(10, -2, -2)}}) {
            Tetrahedron corners = {0, 1, 2, 3};
            do {
                const TetrahedralMesh mesh = {{x.begin(), x.end()}, {corners}};
                if (volume(mesh, 0) < 0) continue;
                CAPTURE(height, corners);
                const SplitMesh result = split_element(mesh, 0, Vector3d::UnitY());
                const bool cuts = height > 1;
                check_that((vertex_count(result.mesh) > 4) == cuts,
                           cuts ? "new vertices, since the plane cuts" : "no new vertex");
                check_count(piece_count(result.mesh), cuts ? 2 : 1, "pieces");
            } while (std::next_permutation(corners.begin(), corners.end()));
        }
}

TEST_CASE("fracture: an edge that no tetrahedron of the vertex has is not cut", "[A7.6][fracture]")
{
    // An octahedron around vertex 0. In two of its octants, vertex 7 lies between vertex 0 and the
    // edge of vertices 1 and 3, which crosses the plane.
    TetrahedralMesh mesh = {{{0, 0, 0},
                             {1, 0, 0},
                             {-1, 0, 0},
                             {0, 1, 0},
                             {0, -1, 0},
                             {0, 0, 1},
                             {0, 0, -1},
                             {0.25, 0.25, 0}},
                            {}};
    for (const int z : {5, 6}) {
        for (const auto& [x, y] : {std::pair(1, 4), std::pair(2, 3), std::pair(2, 4)})
            mesh.tetrahedra.push_back({0, x, y, z});
        for (const auto& [a, b, c] :
             {std::array{0, 1, 7}, std::array{0, 7, 3}, std::array{1, 3, 7}})
            mesh.tetrahedra.push_back({a, b, c, z});
    }
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        if (volume(mesh, t) < 0) std::swap(mesh.tetrahedra[t][2], mesh.tetrahedra[t][3]);
    everywhere(mesh, [&](const Placed& solid) {
        const Vector3d n = solid.R * Vector3d(1, -1, 0).normalized();
        const SplitMesh result = split_element(solid.mesh, solid.vertex[0], n);
        check_matter(solid.mesh, result);
        INFO("two of the twelve tetrahedra are halved, and the others stay whole");
        check_count(tetrahedron_count(result.mesh), 14, "tetrahedra");
    });
}

TEST_CASE("fracture: a plane that is hardly tilted cuts where it is", "[A7.6][fracture]")
{
    // A plane that passes close to all vertices cuts no edge, but not all planes do so.
    int cuts = 0;
    for (Random random : seeds(2)) {
        TetrahedralMesh mesh = jiggled(block(2, 2, 2), random);
        const Matrix3d R = random.rotation(); // so that the plane crosses edges
        for (Vector3d& x : mesh.vertices)
            x = (R * x).eval();
        const int middle = block_vertex(2, 2, 1, 1, 1);
        const Vector3d& p = mesh.vertices[middle];
        for (int axis = 0; axis < 3; ++axis)
            for (int power = 1; power <= 44; ++power) {
                CAPTURE(axis, power);
                const Vector3d along = Vector3d::Unit((axis + 1) % 3);
                const Vector3d n =
                    (Vector3d::Unit(axis) + std::ldexp(1, -power) * along).normalized();
                const SplitMesh result = split_element(mesh, middle, n);
                double highest = 0; // the height above the plane that a new vertex has [m]
                for (std::size_t i = 0; i < result.origins.size(); ++i) {
                    if (result.origins[i].first == result.origins[i].second) continue;
                    ++cuts;
                    highest = std::max(highest, std::abs(n.dot(result.mesh.vertices[i] - p)));
                }
                REQUIRE_THAT(highest, IsClose(0.0, Rounding(64, 4)));
            }
    }
    check_that(cuts > 0, "one plane at least cuts edges of the element");
}

} // namespace fracture_strata_test
