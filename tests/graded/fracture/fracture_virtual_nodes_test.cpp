// SPDX-License-Identifier: MIT
// A7.7: cracked elements are duplicated, and the crack is embedded in the copies.
#include "support/seeds.hpp"
#include "virtual_nodes_laws.hpp"

namespace rigor::testing {

namespace {

// The share of a tetrahedron's volume above a plane, by the heights hᵢ of its corners, which all
// differ: Σ hᵢ³ / Π (hᵢ - hⱼ) over the corners above.
struct Share {
    double value = 0, scale = 0;
};

Share share_above(const std::array<Vector3d, 4>& x, const ElementCrack& crack)
{
    std::array<double, 4> h;
    for (int c = 0; c < 4; ++c)
        h[c] = crack.normal.dot(x[c] - crack.point);
    Share share;
    for (int i = 0; i < 4; ++i) {
        double term = std::max(h[i], 0.0) * std::max(h[i], 0.0) * std::max(h[i], 0.0);
        for (int j = 0; j < 4; ++j)
            if (j != i) term /= h[i] - h[j];
        share.value += term;
        share.scale += std::abs(term);
    }
    return share;
}

Cracks random_cracks(const TetrahedralMesh& mesh, Random& random, double chance)
{
    Cracks result;
    for (int t = 0; t < tetrahedron_count(mesh); ++t)
        while (random.uniform(0, 1) < chance)
            result.push_back({t, center(mesh, t) + 0.2 * random.vector(), random.unit_vector()});
    return result;
}

} // namespace

TEST_CASE("fracture: without cracks nothing is duplicated", "[A7.7][fracture]")
{
    for (const TetrahedralMesh& mesh : {unit_tetrahedron(), two_tetrahedra(), block(2, 2, 1)}) {
        const EmbeddedMesh result = embedded(mesh, {});
        REQUIRE_THAT(canonical(result.mesh.tetrahedra), IsExactly(canonical(mesh.tetrahedra)));
        for (double fraction : result.fractions)
            REQUIRE_THAT(fraction, IsClose(1.0, Rounding(4, 1)));
    }
    REQUIRE(embedded({}, {}).parents.empty());
}

TEST_CASE("fracture: a plane cuts c cubed off the unit tetrahedron", "[A7.7][fracture]")
{
    for (const double c : {0.125, 0.3, 0.5, 0.77, 0.999})
        for (const double sign : {1.0, -1.0}) {
            CAPTURE(c, sign);
            const EmbeddedMesh result = embedded(unit_tetrahedron(), {corner_cut(0, c, sign)});
            REQUIRE_THAT(result.real,
                         IsExactly(std::vector<Tetrahedron>{{1, 0, 0, 0}, {0, 1, 1, 1}}));
            REQUIRE_THAT(result.fractions,
                         IsClose(std::vector{c * c * c, 1 - c * c * c}, Rounding(32, 1)));
            REQUIRE(vertex_count(result.mesh) == 8);
            REQUIRE_THAT(piece_matter(unit_tetrahedron(), result),
                         IsClose(sorted(std::vector{c * c * c / 6, 1.0 / 6 - c * c * c / 6}),
                                 Rounding(32, 1)));
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
        REQUIRE_THAT(result.fractions, IsClose(std::vector{share, 1 - share}, Rounding(32, 1)));
    }
}

TEST_CASE("fracture: a plane beside a tetrahedron does not crack it", "[A7.7][fracture]")
{
    const TetrahedralMesh mesh = unit_tetrahedron();
    for (const double c : {-0.5, 1.5}) {
        const EmbeddedMesh result = embedded(mesh, {corner_cut(0, c), corner_cut(0, c, -1)});
        REQUIRE_THAT(result.fractions, IsClose(std::vector{1.0}, Rounding(4, 1)));
    }
}

TEST_CASE("fracture: a corner on the plane is on the side of the normal", "[A7.7][fracture]")
{
    const TetrahedralMesh mesh = unit_tetrahedron();
    // the plane lies in the face x = 0: all corners are at x ≥ 0, but only one is at x > 0
    REQUIRE(embedded(mesh, {{0, {0, 0, 0}, {1, 0, 0}}}).parents.size() == 1);
    const EmbeddedMesh other = embedded(mesh, {{0, {0, 0, 0}, {-1, 0, 0}}});
    REQUIRE_THAT(other.real, IsExactly(std::vector<Tetrahedron>{{1, 0, 1, 1}, {0, 1, 0, 0}}));
    REQUIRE_THAT(other.fractions, IsClose(std::vector{0.0, 1.0}, Rounding(16, 1)));
}

TEST_CASE("fracture: of two cracks the second ends at the first", "[A7.7][fracture]")
{
    const TetrahedralMesh mesh = unit_tetrahedron();
    const ElementCrack half = corner_cut(0, 0.5), quarter = {0, {0.25, 0, 0}, {1, 0, 0}};
    // corner 0 is alone, corner 1 is alone, and 2 and 3 are left; the planes cross inside
    const std::vector<Tetrahedron> real = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 1}};
    const EmbeddedMesh one = embedded(mesh, {half, quarter});
    REQUIRE_THAT(one.real, IsExactly(real));
    REQUIRE_THAT(one.fractions, IsClose(std::vector{0.125, 0.40625, 0.46875}, Rounding(64, 1)));
    const EmbeddedMesh two = embedded(mesh, {quarter, half});
    REQUIRE_THAT(two.real, IsExactly(real));
    REQUIRE_THAT(two.fractions, IsClose(std::vector{0.109375, 0.421875, 0.46875}, Rounding(64, 1)));
}

TEST_CASE("fracture: a second crack beside the first takes nothing away", "[A7.7][fracture]")
{
    // both cracks separate corner 0; the matter between them has no corner and stays with the rest
    const EmbeddedMesh result =
        embedded(unit_tetrahedron(), {corner_cut(0, 0.5), corner_cut(0, 0.25)});
    REQUIRE_THAT(result.fractions, IsClose(std::vector{0.125, 0.875}, Rounding(32, 1)));
}

TEST_CASE("fracture: three cracks leave each corner alone", "[A7.7][fracture]")
{
    const double c = 0.25; // share of each edge, measured from corners 1, 2 and 3
    const EmbeddedMesh result = embedded(unit_tetrahedron(), {{0, {1 - c, 0, 0}, {1, 0, 0}},
                                                              {0, {0, 1 - c, 0}, {0, 1, 0}},
                                                              {0, {0, 0, 1 - c}, {0, 0, 1}}});
    const double tip = c * c * c;
    REQUIRE_THAT(result.fractions,
                 IsClose(std::vector{1 - 3 * tip, tip, tip, tip}, Rounding(64, 1)));
    REQUIRE(vertex_count(result.mesh) == 16);
    REQUIRE(piece_count(result.mesh) == 4);
}

TEST_CASE("fracture: a crack beside the common face leaves the neighbour alone", "[A7.7][fracture]")
{
    // corner 0 comes off; the other three keep the whole face to the second tetrahedron
    const TetrahedralMesh mesh = two_tetrahedra();
    const EmbeddedMesh result = embedded(mesh, {corner_cut(0, 0.5)});
    REQUIRE(vertex_count(result.mesh) == 4 + 5);
    REQUIRE(piece_count(result.mesh) == 2);
    REQUIRE_THAT(piece_matter(mesh, result),
                 IsClose(std::vector{0.125 / 6, 0.875 / 6 + volume(mesh, 1)}, Rounding(32, 1)));
}

TEST_CASE("fracture: a crack that ends at a face does not open there", "[A7.7][fracture]")
{
    // corner 1 comes off in the first tetrahedron only: both copies are joined to the second
    const TetrahedralMesh mesh = two_tetrahedra();
    const EmbeddedMesh result = embedded(mesh, {{0, {0.5, 0, 0}, {1, 0, 0}}});
    REQUIRE(result.parents.size() == 3);
    REQUIRE(vertex_count(result.mesh) == 5 + 1); // only vertex 0 is doubled
    REQUIRE(piece_count(result.mesh) == 1);
}

TEST_CASE("fracture: a crack through both of two tetrahedra parts them", "[A7.7][fracture]")
{
    const TetrahedralMesh mesh = two_tetrahedra();
    // corner 1 and the vertex 4, both at x = 1, are on the same side
    const EmbeddedMesh result = embedded(mesh, plane_through(mesh, {0.5, 0, 0}, {1, 0, 0}));
    REQUIRE(vertex_count(result.mesh) == 2 * 5);
    REQUIRE(piece_count(result.mesh) == 2);
    // The first loses 0.5³ of itself. The second, between x = 0 and 1, has half of itself on either
    // side.
    REQUIRE_THAT(piece_matter(mesh, result),
                 IsClose(sorted(std::vector{0.125 / 6 + volume(mesh, 1) / 2,
                                            0.875 / 6 + volume(mesh, 1) / 2}),
                         Rounding(64, 1)));
}

TEST_CASE("fracture: a bar is cracked across in the middle of its elements", "[A7.7][fracture]")
{
    const TetrahedralMesh bar = block(4, 1, 1);
    for (const double place : {0.3, 1.5, 3.75}) {
        CAPTURE(place);
        const EmbeddedMesh result = embedded(bar, plane_through(bar, {place, 0, 0}, {1, 0, 0}));
        REQUIRE(result.parents.size() == 24 + 6);
        REQUIRE(vertex_count(result.mesh) == 20 + 8);
        REQUIRE(piece_count(result.mesh) == 2);
        REQUIRE_THAT(piece_matter(bar, result),
                     IsClose(sorted(std::vector{place, 4 - place}), Rounding(256, 4)));
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
        REQUIRE(piece_count(result.mesh) == (cells < 3 ? 1 : 2));
        // the vertices between the side and the tip are doubled, on either side of the plane
        REQUIRE(vertex_count(result.mesh) == 32 + (cells < 3 ? 4 * cells : 16));
    }
}

TEST_CASE("fracture: the share of the volume above a plane", "[A7.7][fracture][property]")
{
    int tried = 0;
    for (Random random : seeds(200)) {
        TetrahedralMesh mesh = unit_tetrahedron();
        for (Vector3d& x : mesh.vertices)
            x += 0.2 * random.vector();
        const ElementCrack crack = {0, center(mesh, 0) + 0.15 * random.vector(),
                                    random.unit_vector()};
        const EmbeddedMesh result = embedded(mesh, {crack});
        if (result.parents.size() == 1) continue;
        const Share above = share_above(corners_of(mesh, 0), crack);
        if (above.scale > 100) continue; // two corners are almost at one height
        ++tried;
        const bool first_is_above =
            crack.normal.dot(mesh.vertices[0] - crack.point) >= 0; // the first copy has corner 0
        const double fraction = result.fractions[first_is_above ? 0 : 1];
        REQUIRE_THAT(fraction, IsClose(above.value, Rounding(256, 1 + above.scale)));
    }
    REQUIRE(tried > 100);
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
        REQUIRE(vertex_count(two.mesh) == vertex_count(one.mesh));
        REQUIRE(piece_count(two.mesh) == piece_count(one.mesh));
        REQUIRE_THAT(piece_matter(other.mesh, two),
                     IsClose(piece_matter(mesh, one), Rounding(256, 4)));
    }
}

TEST_CASE("fracture: a large mesh is cracked through", "[A7.7][fracture]")
{
    const TetrahedralMesh cube = block(16, 16, 16); // 24576 tetrahedra
    const EmbeddedMesh result =
        virtual_nodes(cube, plane_through(cube, {0, 0, 8.25}, Vector3d::UnitZ()));
    REQUIRE(result.parents.size() == cube.tetrahedra.size() + 6 * 256);
    REQUIRE(vertex_count(result.mesh) == vertex_count(cube) + 2 * 17 * 17);
    REQUIRE(piece_count(result.mesh) == 2);
}

} // namespace rigor::testing
