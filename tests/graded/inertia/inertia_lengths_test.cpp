// SPDX-License-Identifier: MIT
// A2.1, A2.11, A2.12, A2.13 and A2.17: lists of every length, elements that count for nothing among
// others, and meshes whose indices need more than 8 or 16 bits.
#include "formulas/inertia.hpp"
#include "graded/laws/lengths.hpp"
#include "support/close.hpp"

#include <cmath>
#include <numbers>

namespace inertia_lengths_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// Checks the mass properties of beads.
template <class Element> void check(const Beads<Element>& beads, const MassProperties& found)
{
    const double x = beads.mass == 0 ? 0 : beads.first / beads.mass;
    const double I = beads.second - x * beads.first; // Σ mᵢ (xᵢ - x)²
    // a sum of n terms may be off by n eps of their magnitudes
    const double terms = 16 + static_cast<double>(beads.list.size());
    REQUIRE_THAT(found.mass, IsClose(beads.mass, Rounding(terms)));
    REQUIRE_THAT(found.center_of_mass, IsClose(Vector3d(x, 0, 0), Rounding(terms)));
    const Matrix3d expected = Vector3d(0, I, I).asDiagonal();
    REQUIRE_THAT(found.inertia, IsClose(expected, Rounding(terms, beads.second)));
}

// A bipyramid over a regular polygon with n corners at the distance 1 from `center`, its tips 1
// above and below it: 2 n triangles.
TriangleMesh bipyramid(int n, const Vector3d& center)
{
    TriangleMesh mesh = {{center + Vector3d::UnitZ(), center - Vector3d::UnitZ()}, {}};
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        mesh.vertices.push_back(center + Vector3d(std::cos(angle), std::sin(angle), 0));
        const int here = 2 + i, next = 2 + (i + 1) % n;
        mesh.triangles.push_back({0, here, next});
        mesh.triangles.push_back({1, next, here});
    }
    return mesh;
}

const DensitySample empty_sample = {{2, -1, 4}, 0};

} // namespace

TEST_CASE("inertia: any number of particles", "[A2.1][inertia]")
{
    Beads<Particle> beads;
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        beads.grow(n);
        check(beads, particle_mass_properties(beads.list));
    }
}

TEST_CASE("inertia: any number of cells", "[A2.11][inertia]")
{
    Beads<DensitySample> beads;
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        beads.grow(n);
        check(beads, grid_mass_properties(beads.list, 1));
    }
}

TEST_CASE("inertia: any number of samples", "[A2.12][inertia]")
{
    Beads<DensitySample> beads;
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        beads.grow(n);
        check(beads, sampled_mass_properties(beads.list, n)); // a volume of 1 for each
    }
}

TEST_CASE("inertia: particles without mass count for nothing", "[A2.1][inertia]")
{
    const Beads<Particle> few(20);
    for (const int n : idle_elements) {
        CAPTURE(n);
        check(few, particle_mass_properties(among(n, Particle{0, {2, -1, 4}}, few.list)));
    }
}

TEST_CASE("inertia: empty cells count for nothing", "[A2.11][inertia]")
{
    const Beads<DensitySample> few(20);
    for (const int n : idle_elements) {
        CAPTURE(n);
        check(few, grid_mass_properties(among(n, empty_sample, few.list), 1));
    }
}

TEST_CASE("inertia: samples that miss the solid count wherever they are", "[A2.12][inertia]")
{
    const Beads<DensitySample> few(20);
    for (const int n : idle_elements) {
        CAPTURE(n);
        const std::vector<DensitySample> before = among(n, empty_sample, few.list);
        const std::vector<DensitySample> after(before.rbegin(), before.rend());
        // a volume of 1 for each sample
        check(few, sampled_mass_properties(before, 2 * n + 20));
        check(few, sampled_mass_properties(after, 2 * n + 20));
        if (n > 300) continue;
        std::vector<DensitySample> each; // n of them after each sample that hits
        for (const DensitySample& hit : few.list) {
            each.push_back(hit);
            each.insert(each.end(), static_cast<std::size_t>(n), empty_sample);
        }
        check(few, sampled_mass_properties(each, 20 * n + 20));
    }
}

TEST_CASE("inertia: triangles without area count for nothing", "[A2.13][inertia]")
{
    const TriangleMesh plain = bipyramid(5, {0.5, -1, 0.25});
    const MassProperties expected = mesh_mass_properties(plain, 3);
    for (const std::array<int, 3>& flat : {std::array{2, 3, 3}, {3, 2, 3}, {4, 4, 0}, {1, 1, 1}})
        for (const std::size_t place : {0, 1, 4, 10}) {
            CAPTURE(flat, place);
            TriangleMesh mesh = plain;
            mesh.triangles.insert(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(place),
                                  flat);
            const MassProperties found = mesh_mass_properties(mesh, 3);
            REQUIRE_THAT(found, IsClose(expected, Rounding(64, 16)));
        }
}

TEST_CASE("inertia: a mesh with any number of triangles", "[A2.13][inertia]")
{
    const Vector3d center(0.5, -1, 0.25);
    for (const int n : lengths(3, 65536)) {
        CAPTURE(n);
        const double angle = 2 * std::numbers::pi / n, area = n / 2.0 * std::sin(angle);
        const MassProperties found = mesh_mass_properties(bipyramid(n, center), 3);
        const double terms = 64 + 2.0 * n;
        REQUIRE_THAT(found.mass, IsClose(2 * area, Rounding(terms, 16)));
        REQUIRE_THAT(found.center_of_mass, IsClose(center, Rounding(terms, 16)));
        // ∫ r² dA of the polygon is area · (2 + cos angle)/6. The sections shrink towards the tips,
        // which gives the factor 2/5.
        const double along = 3 * 2 / 5.0 * area * (2 + std::cos(angle)) / 6;
        REQUIRE_THAT(found.inertia(2, 2), IsClose(along, Rounding(terms, 32)));
        REQUIRE_THAT(found.inertia(0, 1), IsClose(0.0, Rounding(terms, 32)));
    }
}

TEST_CASE("inertia: a mesh whose indices need many bits", "[A2.13][inertia]")
{
    // A tetrahedron whose vertices have indices with the same last 8 bits, two pairs of them with
    // the same last 16. A solution may sum tetrahedra with a common tip at any vertex of the mesh,
    // so distances are up to 2 m.
    for (const int first : {5, 250}) {
        CAPTURE(first);
        TriangleMesh mesh;
        mesh.vertices.assign(wide + 2 * narrow, Vector3d(1, 1, 1)); // unused
        const int v[4] = {first, first + narrow, first + wide, first + wide + narrow};
        for (int i = 1; i < 4; ++i)
            mesh.vertices[v[i]] = Vector3d::Unit(i - 1);
        mesh.vertices[v[0]].setZero();
        mesh.triangles = {
            {v[0], v[2], v[1]}, {v[0], v[1], v[3]}, {v[1], v[2], v[3]}, {v[0], v[3], v[2]}};
        const MassProperties found = mesh_mass_properties(mesh, 1);
        REQUIRE_THAT(found.mass, IsClose(1 / 6.0, Rounding(64, 16)));
        REQUIRE_THAT(found.center_of_mass, IsClose(Vector3d(0.25, 0.25, 0.25), Rounding(64, 16)));
        REQUIRE_THAT(found.inertia(0, 1), IsClose(1 / 480.0, Rounding(64, 16)));
    }
}

TEST_CASE("inertia: a box around any number of vertices", "[A2.17][inertia]")
{
    for (const int n : lengths(1, 65536)) {
        CAPTURE(n);
        std::vector<Vector3d> vertices(static_cast<std::size_t>(n), Vector3d(1, 2, 3));
        vertices.front().x() = 5; // the extremes are first, last and in the middle of the list
        vertices.back().x() = -4;
        vertices.back().y() = 8;
        vertices[n / 2].y() = -1;
        vertices[n / 3].z() = 7;
        vertices[n - 1 - n / 4].z() = -2;
        Vector3d low = vertices[0], high = vertices[0];
        for (const Vector3d& x : vertices) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        const Vector3d middle = (low + high) / 2, squares = (high - low).cwiseAbs2();
        const MassProperties found = bounding_box_mass_properties(vertices, 12);
        REQUIRE_THAT(found.center_of_mass, IsClose(middle, Rounding(8, 8)));
        const Matrix3d I = squares.sum() * Matrix3d::Identity() - Matrix3d(squares.asDiagonal());
        REQUIRE_THAT(found.inertia, IsClose(I, Rounding(16, squares.sum() + 1)));
    }
}

} // namespace inertia_lengths_test
