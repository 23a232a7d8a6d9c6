// SPDX-License-Identifier: MIT
// A7.7: cracked elements are duplicated, and the crack is embedded in the copies.
#include "support/seeds.hpp"
#include "virtual_nodes_laws.hpp"

namespace rigor::testing {

namespace {

// The share of a tetrahedron's volume that is above a plane, computed by a crack along the plane.
double share_above(const std::array<Vector3d, 4>& x, const Vector3d& point, const Vector3d& normal)
{
    TetrahedralMesh mesh = unit_tetrahedron();
    mesh.vertices.assign(x.begin(), x.end());
    const EmbeddedMesh result = embedded(mesh, {{0, point, normal}});
    double share = 0;
    for (std::size_t i = 0; i < result.parents.size(); ++i)
        for (int c = 0; c < 4; ++c)
            if (result.real[i][c] == 1) { // the copy is on the side of its first real corner
                if (normal.dot(x[c] - point) >= 0) share += result.fractions[i];
                break;
            }
    return share;
}

// The least difference in height between two of the points.
double least_difference(const std::vector<Vector3d>& points, const Vector3d& normal)
{
    double least = 1;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::abs(normal.dot(points[i] - points[j])));
    return least;
}

Cracks random_cracks(const TetrahedralMesh& mesh, Random& random, double chance)
{
    Cracks result;
    for (int t = 0; t < tetrahedron_count(mesh); ++t)
        while (random.uniform(0, 1) < chance)
            result.push_back({t, center(mesh, t) + 0.2 * random.vector(), random.unit_vector()});
    return result;
}

// The corners of the unit tetrahedron that are real in one of its copies, and the copy's share.
using Part = std::pair<Tetrahedron, double>;

// Cracks the unit tetrahedron and checks its copies.
EmbeddedMesh check_parts(const Placed& at, const Cracks& cracks, const std::vector<Part>& parts,
                         double k)
{
    Cracks moved;
    for (const ElementCrack& crack : cracks)
        moved.push_back(at.crack(crack));
    const EmbeddedMesh result = embedded(at.mesh, moved);
    std::vector<Part> expected = parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (int v = 0; v < 4; ++v)
            expected[i].first[at.corner(0, v)] = parts[i].first[v];
    std::sort(expected.rbegin(), expected.rend()); // by their first real corners
    std::vector<Tetrahedron> real;
    std::vector<double> shares;
    for (const auto& [corners, share] : expected) {
        real.push_back(corners);
        shares.push_back(share);
    }
    REQUIRE_THAT(result.real, IsExactly(real));
    check_shares(result, shares, Rounding(k, volume_scale(at.mesh) / std::pow(at.length, 3)));
    return result;
}

} // namespace

TEST_CASE("fracture: without cracks nothing is duplicated", "[A7.7][fracture]")
{
    for (const TetrahedralMesh& mesh : {unit_tetrahedron(), two_tetrahedra(), block(2, 2, 1)}) {
        const EmbeddedMesh result = embedded(mesh, {});
        check_same_vertices(result.mesh.tetrahedra, mesh.tetrahedra);
        for (double fraction : result.fractions)
            REQUIRE_THAT(fraction, IsClose(1.0, Rounding(4, 1)));
    }
    check_count(embedded({}, {}).parents.size(), 0, "copies");
}

TEST_CASE("fracture: a plane cuts c cubed off the unit tetrahedron", "[A7.7][fracture]")
{
    const auto check = [](const Placed& at, double c) {
        for (const double sign : {1.0, -1.0}) {
            CAPTURE(c, sign);
            const double share = c * c * c, whole = std::pow(at.length, 3) / 6;
            const EmbeddedMesh result =
                check_parts(at, {corner_cut(0, c, sign)},
                            {{{1, 0, 0, 0}, share}, {{0, 1, 1, 1}, 1 - share}}, 32);
            check_count(vertex_count(result.mesh), 8, "vertices");
            check_piece_matter(at.mesh, result,
                               sorted(std::vector{share * whole, whole - share * whole}),
                               Rounding(32, volume_scale(at.mesh)));
        }
    };
    for (const double c : {0.125, 0.3, 0.5, 0.77, 0.999})
        check(Placed(unit_tetrahedron()), c);
    for (Random random : seeds(5)) {
        const double c = random.uniform(0.1, 0.9);
        check(Placed(unit_tetrahedron(), random), c);
    }
}

TEST_CASE("fracture: a plane between two edges of the unit tetrahedron", "[A7.7][fracture]")
{
    // x + y < c has the share 3 c² - 2 c³
    for (const double c : {0.1, 0.5, 0.8}) {
        CAPTURE(c);
        const EmbeddedMesh result =
            embedded(unit_tetrahedron(), {{0, Vector3d(c, 0, 9), Vector3d(1, 1, 0).normalized()}});
        const double share = 3 * c * c - 2 * c * c * c;
        REQUIRE_THAT(result.real, IsExactly(std::vector<Tetrahedron>{{1, 0, 0, 1}, {0, 1, 1, 0}}));
        check_shares(result, std::vector{share, 1 - share}, Rounding(32, 1));
    }
}

TEST_CASE("fracture: a plane beside a tetrahedron does not crack it", "[A7.7][fracture]")
{
    const TetrahedralMesh mesh = unit_tetrahedron();
    for (const double c : {-0.5, 1.5}) {
        const EmbeddedMesh result = embedded(mesh, {corner_cut(0, c), corner_cut(0, c, -1)});
        check_shares(result, std::vector{1.0}, Rounding(4, 1));
    }
}

TEST_CASE("fracture: a corner on the plane is on the side of the normal", "[A7.7][fracture]")
{
    const TetrahedralMesh mesh = unit_tetrahedron();
    // the plane lies in the face x = 0: all corners are at x ≥ 0, but only one is at x > 0
    check_count(embedded(mesh, {{0, {0, 0, 0}, {1, 0, 0}}}).parents.size(), 1, "copies");
    const EmbeddedMesh other = embedded(mesh, {{0, {0, 0, 0}, {-1, 0, 0}}});
    REQUIRE_THAT(other.real, IsExactly(std::vector<Tetrahedron>{{1, 0, 1, 1}, {0, 1, 0, 0}}));
    check_shares(other, std::vector{0.0, 1.0}, Rounding(16, 1));
}

TEST_CASE("fracture: of two cracks the second ends at the first", "[A7.7][fracture]")
{
    // One crack separates corner 0, the other one corner 1, and 2 and 3 stay together. The planes
    // x + y + z = c and x = b cross inside. The share (c - b)³ that both cut off goes to the corner
    // that the first crack separates.
    const auto check = [](const Placed& at, double c, double b) {
        CAPTURE(c, b);
        const ElementCrack first = corner_cut(0, c), second = {0, {b, 0, 0}, {1, 0, 0}};
        const double at0 = std::pow(c, 3), at1 = std::pow(1 - b, 3), both = std::pow(c - b, 3);
        const auto parts = [&](double share0, double share1) {
            return std::vector<Part>{{{1, 0, 0, 0}, share0},
                                     {{0, 1, 0, 0}, share1},
                                     {{0, 0, 1, 1}, 1 - share0 - share1}};
        };
        check_parts(at, {first, second}, parts(at0, at1 - both), 64);
        check_parts(at, {second, first}, parts(at0 - both, at1), 64);
    };
    check(Placed(unit_tetrahedron()), 0.5, 0.25);
    for (Random random : seeds(5)) {
        const double c = random.uniform(0.3, 0.9), b = c * random.uniform(0.2, 0.8);
        check(Placed(unit_tetrahedron(), random), c, b);
    }
}

TEST_CASE("fracture: a second crack beside the first takes nothing away", "[A7.7][fracture]")
{
    // both cracks separate corner 0; the matter between them has no corner and stays with the rest
    const EmbeddedMesh result =
        embedded(unit_tetrahedron(), {corner_cut(0, 0.5), corner_cut(0, 0.25)});
    check_shares(result, std::vector{0.125, 0.875}, Rounding(32, 1));
}

TEST_CASE("fracture: three cracks leave each corner alone", "[A7.7][fracture]")
{
    const double c = 0.25; // share of each edge, measured from corners 1, 2 and 3
    const EmbeddedMesh result = embedded(unit_tetrahedron(), {{0, {1 - c, 0, 0}, {1, 0, 0}},
                                                              {0, {0, 1 - c, 0}, {0, 1, 0}},
                                                              {0, {0, 0, 1 - c}, {0, 0, 1}}});
    const double tip = c * c * c;
    check_shares(result, std::vector{1 - 3 * tip, tip, tip, tip}, Rounding(64, 1));
    check_count(vertex_count(result.mesh), 16, "vertices");
    check_count(piece_count(result.mesh), 4, "pieces");
}

TEST_CASE("fracture: a crack beside the common face leaves the neighbour alone", "[A7.7][fracture]")
{
    // corner 0 comes off; the other three keep the whole face to the second tetrahedron
    const TetrahedralMesh mesh = two_tetrahedra();
    const EmbeddedMesh result = embedded(mesh, {corner_cut(0, 0.5)});
    check_count(vertex_count(result.mesh), 4 + 5, "vertices");
    check_count(piece_count(result.mesh), 2, "pieces");
    check_piece_matter(mesh, result, std::vector{0.125 / 6, 0.875 / 6 + volume(mesh, 1)},
                       Rounding(32, 1));
}

TEST_CASE("fracture: a crack that ends at a face does not open there", "[A7.7][fracture]")
{
    // corner 1 comes off in the first tetrahedron only: both copies are joined to the second
    const TetrahedralMesh mesh = two_tetrahedra();
    const EmbeddedMesh result = embedded(mesh, {{0, {0.5, 0, 0}, {1, 0, 0}}});
    check_count(result.parents.size(), 3, "copies");
    check_count(vertex_count(result.mesh), 5 + 1, "vertices"); // only vertex 0 is doubled
    check_count(piece_count(result.mesh), 1, "pieces");
}

TEST_CASE("fracture: a copy without a share is joined like any other", "[A7.7][fracture]")
{
    // corner 1 lies on the plane and the others on the other side
    const TetrahedralMesh mesh = two_tetrahedra();
    const EmbeddedMesh result = embedded(mesh, {{0, mesh.vertices[1], {1, 0, 0}}});
    check_count(result.parents.size(), 3, "copies");
    check_count(vertex_count(result.mesh), 5 + 1, "vertices"); // only vertex 0 is doubled
    check_count(piece_count(result.mesh), 1, "pieces");
    check_shares(result, std::vector{1.0, 0.0, 1.0}, Rounding(16, 1));
}

TEST_CASE("fracture: two copies without a share are joined like any others", "[A7.7][fracture]")
{
    // vertices 1 and 4 lie on the plane and the others on the other side
    const TetrahedralMesh mesh = two_tetrahedra();
    const EmbeddedMesh result =
        embedded(mesh, plane_through(mesh, mesh.vertices[1], Vector3d::UnitX()));
    check_count(result.parents.size(), 4, "copies");
    check_count(vertex_count(result.mesh), 2 * 5, "vertices"); // all are doubled
    check_count(piece_count(result.mesh), 2, "pieces");
    check_shares(result, std::vector{1.0, 0.0, 0.0, 1.0}, Rounding(16, 1));
}

TEST_CASE("fracture: a crack through both of two tetrahedra parts them", "[A7.7][fracture]")
{
    const auto check = [](const Placed& at, double x) {
        CAPTURE(x);
        // corner 1 and the vertex 4, both at x = 1, are on the same side
        const EmbeddedMesh result =
            embedded(at.mesh, plane_through(at.mesh, at.point({x, 0, 0}), at.R.col(0)));
        check_count(vertex_count(result.mesh), 2 * 5, "vertices");
        check_count(piece_count(result.mesh), 2, "pieces");
        // The first tetrahedron, of 1/6 m³, loses (1 - x)³ of itself. The second, of 1/3 m³ between
        // x = 0 and 1, has 3 x² - 2 x³ of itself, a half at x = 0.5, on the lower side.
        const double cube = std::pow(at.length, 3), lost = std::pow(1 - x, 3);
        const double lower = 3 * x * x - 2 * x * x * x;
        check_piece_matter(at.mesh, result,
                           sorted(std::vector{cube * (lost / 6 + (1 - lower) / 3),
                                              cube * ((1 - lost) / 6 + lower / 3)}),
                           Rounding(64, volume_scale(at.mesh)));
    };
    check(Placed(two_tetrahedra()), 0.5);
    for (Random random : seeds(5)) {
        const double x = random.uniform(0.2, 0.8);
        check(Placed(two_tetrahedra(), random), x);
    }
}

TEST_CASE("fracture: a bar is cracked across in the middle of its elements", "[A7.7][fracture]")
{
    const TetrahedralMesh bar = block(4, 1, 1);
    for (const double place : {0.3, 1.5, 3.75}) {
        CAPTURE(place);
        const EmbeddedMesh result = embedded(bar, plane_through(bar, {place, 0, 0}, {1, 0, 0}));
        check_count(result.parents.size(), 24 + 6, "copies");
        check_count(vertex_count(result.mesh), 20 + 8, "vertices");
        check_count(piece_count(result.mesh), 2, "pieces");
        check_piece_matter(bar, result, sorted(std::vector{place, 4 - place}), Rounding(256, 4));
    }
}

TEST_CASE("fracture: the tip of a crack in a plate stays closed", "[A7.7][fracture]")
{
    const TetrahedralMesh plate = block(3, 3, 1);
    // the crack goes from the side y = 0 through one cell, two cells and all three
    for (int cells = 1; cells <= 3; ++cells) {
        CAPTURE(cells);
        const EmbeddedMesh result =
            embedded(plate, plane_through(plate, {1.4, 0, 0}, {1, 0, 0},
                                          [&](const Vector3d& x) { return x.y() < cells; }));
        check_count(piece_count(result.mesh), (cells < 3 ? 1 : 2), "pieces");
        // the vertices between the side and the tip are doubled, on either side of the plane
        check_count(vertex_count(result.mesh), 32 + (cells < 3 ? 4 * cells : 16), "vertices");
    }
}

TEST_CASE("fracture: both parts of a tetrahedron have its matter above a plane",
          "[A7.7][fracture][property]")
{
    int tried = 0;
    for (Random random : seeds(300)) {
        std::array<Vector3d, 4> x = corners_of(unit_tetrahedron(), 0);
        for (Vector3d& corner : x)
            corner += 0.2 * random.vector();
        // the tetrahedron is cut in two at a point of the edge between corners 1 and 2
        const double t = random.uniform(0.2, 0.8);
        const Vector3d on_edge = (1 - t) * x[1] + t * x[2];
        const std::array<Vector3d, 4> half = {x[0], x[1], on_edge, x[3]};
        const std::array<Vector3d, 4> other = {x[0], on_edge, x[2], x[3]};
        const Vector3d n = random.unit_vector();
        const Vector3d point = (x[0] + x[1] + x[2] + x[3]) / 4 + 0.15 * random.vector();
        // The formula for a share may divide by differences of heights.
        const double d = least_difference({x[0], x[1], x[2], x[3], on_edge}, n);
        if (d < 0.03) continue;
        ++tried;
        const double sum = t * share_above(half, point, n) + (1 - t) * share_above(other, point, n);
        REQUIRE_THAT(share_above(x, point, n), IsClose(sum, Rounding(256, 1 + 1 / (d * d * d))));
    }
    check_that(tried > 100, "more than 100 random cases could be judged");
}

TEST_CASE("fracture: the share above a plane does not change if all is stretched and sheared",
          "[A7.7][fracture][property]")
{
    for (Random random : seeds(100)) {
        const double c = random.uniform(0.05, 0.95), b = random.uniform(0.05, 0.95);
        Matrix3d A = Matrix3d::Identity();
        for (int i = 0; i < 3; ++i)
            A.col(i) += 0.25 * random.vector();
        std::array<Vector3d, 4> x = corners_of(unit_tetrahedron(), 0);
        for (Vector3d& corner : x)
            corner = A * corner;
        const auto below = [&](const Vector3d& point, const Vector3d& normal) {
            return share_above(x, A * point, (-A.inverse().transpose() * normal).normalized());
        };
        REQUIRE_THAT(below({c, 0, 0}, {1, 1, 1}), IsClose(c * c * c, Rounding(1024, 1)));
        REQUIRE_THAT(below({b, 0, 0}, {1, 1, 0}),
                     IsClose(3 * b * b - 2 * b * b * b, Rounding(1024, 1)));
    }
}

TEST_CASE("fracture: any cracks through any elements share out vertices and matter",
          "[A7.7][fracture][property]")
{
    for (Random random : seeds(40)) {
        const TetrahedralMesh mesh = jiggled(block(2, 2, 1), random);
        const Cracks cracks = random_cracks(mesh, random, random.uniform(0, 0.7));
        const EmbeddedMesh result = embedded(mesh, cracks);
        double matter = 0;
        for (double piece : piece_matter(mesh, result))
            matter += piece;
        REQUIRE_THAT(matter, IsClose(volume(mesh), Rounding(256, 4)));
    }
}

TEST_CASE("fracture: neither numbering nor the cracks' order among elements matters",
          "[A7.7][fracture][property]")
{
    for (Random random : seeds(20)) {
        const TetrahedralMesh mesh = jiggled(block(2, 2, 1), random);
        const Cracks cracks = random_cracks(mesh, random, 0.5);
        const Renumbered other = renumbered(mesh, random);
        Cracks same;
        for (const ElementCrack& crack : cracks)
            same.push_back({other.tetrahedron[crack.tetrahedron], crack.point, crack.normal});
        std::stable_sort(same.begin(), same.end(), [](const auto& a, const auto& b) {
            return a.tetrahedron < b.tetrahedron;
        });

        const EmbeddedMesh one = embedded(mesh, cracks), two = embedded(other.mesh, same);
        check_count(vertex_count(two.mesh), vertex_count(one.mesh), "vertices");
        check_count(piece_count(two.mesh), piece_count(one.mesh), "pieces");
        check_piece_matter(other.mesh, two, piece_matter(mesh, one), Rounding(256, 4));
    }
}

TEST_CASE("fracture: a large mesh is cracked through", "[A7.7][fracture]")
{
    const TetrahedralMesh cube = block(16, 16, 16); // 24576 tetrahedra
    const EmbeddedMesh result =
        virtual_nodes(cube, plane_through(cube, {0, 0, 8.25}, Vector3d::UnitZ()));
    check_count(result.parents.size(), cube.tetrahedra.size() + 6 * 256, "copies");
    check_count(vertex_count(result.mesh), vertex_count(cube) + 2 * 17 * 17, "vertices");
    check_count(piece_count(result.mesh), 2, "pieces");
}

} // namespace rigor::testing
