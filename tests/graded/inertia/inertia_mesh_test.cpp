// SPDX-License-Identifier: MIT
// A2.13: solids enclosed by triangles.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

// A box of edges `size`, one corner at `corner`, as 12 triangles.
TriangleMesh box(const Vector3d& corner, const Vector3d& size)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(corner +
                                size.cwiseProduct(Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1)));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TriangleMesh tetrahedron(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d)
{
    if ((b - a).cross(c - a).dot(d - a) < 0) return tetrahedron(b, a, c, d);
    return {{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

// Four particles with the mass and the first and second moments of a tetrahedron (Hammer & Stroud
// 1956, "Numerical integration over simplexes").
std::vector<Particle> gauss_points(const TriangleMesh& t, double density)
{
    const std::vector<Vector3d>& v = t.vertices;
    const double volume = (v[1] - v[0]).cross(v[2] - v[0]).dot(v[3] - v[0]) / 6;
    const double inner = (5 - std::sqrt(5.0)) / 20; // weight of each of the three other vertices
    const Vector3d all = inner * (v[0] + v[1] + v[2] + v[3]);
    std::vector<Particle> points;
    for (const Vector3d& vertex : v)
        points.push_back({density * volume / 4, all + (1 - 4 * inner) * vertex});
    return points;
}

// A torus of radius R about y whose section is a circle of radius a, made of n × n quadrilaterals.
TriangleMesh torus(double R, double a, int n)
{
    TriangleMesh mesh;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = 2 * pi * i / n, v = 2 * pi * j / n;
            const double r = R + a * std::cos(v);
            mesh.vertices.push_back({r * std::cos(u), a * std::sin(v), r * std::sin(u)});
            const int i1 = (i + 1) % n, j1 = (j + 1) % n;
            const int p = i * n + j, q = i1 * n + j, s = i1 * n + j1, t = i * n + j1;
            mesh.triangles.push_back({p, t, s});
            mesh.triangles.push_back({p, s, q});
        }
    return mesh;
}

TriangleMesh icosahedron()
{
    const double g = std::numbers::phi;
    TriangleMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (Vector3d& vertex : mesh.vertices)
        vertex.normalize();
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return mesh;
}

// Splits each triangle into four and moves the new vertices out to the unit sphere.
TriangleMesh refined(const TriangleMesh& mesh)
{
    TriangleMesh result{mesh.vertices, {}};
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int i, int j) {
        const auto [at, is_new] = middles.try_emplace({std::min(i, j), std::max(i, j)},
                                                      static_cast<int>(result.vertices.size()));
        if (is_new) result.vertices.push_back((mesh.vertices[i] + mesh.vertices[j]).normalized());
        return at->second;
    };
    for (const auto& [i, j, k] : mesh.triangles) {
        const int a = middle(i, j), b = middle(j, k), c = middle(k, i);
        for (const std::array<int, 3>& triangle :
             {std::array{i, a, c}, {a, j, b}, {c, b, k}, {a, b, c}})
            result.triangles.push_back(triangle);
    }
    return result;
}

TriangleMesh moved(TriangleMesh mesh, const Matrix3d& R, const Vector3d& X)
{
    for (Vector3d& vertex : mesh.vertices)
        vertex = R * vertex + X;
    return mesh;
}

// The same mesh with its vertices in reverse order, and with the list of its triangles, and the
// corners of each triangle, rotated by random numbers.
TriangleMesh renumbered(TriangleMesh mesh, Random& random)
{
    const int last = static_cast<int>(mesh.vertices.size()) - 1;
    std::reverse(mesh.vertices.begin(), mesh.vertices.end());
    for (std::array<int, 3>& triangle : mesh.triangles) {
        for (int& v : triangle)
            v = last - v;
        std::rotate(triangle.begin(), triangle.begin() + random.bits() % 3, triangle.end());
    }
    std::rotate(mesh.triangles.begin(),
                mesh.triangles.begin() + random.bits() % mesh.triangles.size(),
                mesh.triangles.end());
    return mesh;
}

} // namespace

TEST_CASE("inertia: a box of twelve triangles", "[A2.13][inertia]")
{
    const MassProperties expected{12, Vector3d(0.5, 1, 1.5), Vector3d(13, 10, 5).asDiagonal()};

    const MassProperties found = mesh_mass_properties(box(Vector3d::Zero(), Vector3d(1, 2, 3)), 2);

    require_mass_properties(found, expected, 4, 64);
}

TEST_CASE("inertia: a right tetrahedron", "[A2.13][inertia]")
{
    const TriangleMesh mesh =
        tetrahedron(Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ());
    MassProperties expected{1.0 / 6, Vector3d(0.25, 0.25, 0.25), Matrix3d::Constant(1.0 / 480)};
    expected.inertia.diagonal().setConstant(1.0 / 80);

    require_mass_properties(mesh_mass_properties(mesh, 1), expected, 1, 16);
    INFO("the same, turned, scaled and moved");
    for (Random random : seeds(5)) {
        const Matrix3d R = random.rotation();
        const double length = random.uniform(0.5, 2), density = random.mass();
        const double M = density / 6 * length * length * length;
        const Vector3d X = length / 2 * random.vector(),
                       center = length * R * Vector3d(1, 1, 1) / 4;
        const Matrix3d I = 6 * M * length * length * R * expected.inertia * R.transpose();
        const TriangleMesh other = renumbered(moved(mesh, length * R, X), random);

        require_mass_properties(mesh_mass_properties(other, density), {M, center + X, I},
                                X.norm() + length, 64);
    }
}

TEST_CASE("inertia: a square pyramid", "[A2.13][inertia]")
{
    // base 2 × 2 at y = 0, height 3: M = 4, the center is at a quarter of the height, Iyy = M a²/10
    // and Ixx = M (a²/20 + 3 h²/80)
    const TriangleMesh mesh{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 3, 0}},
                            {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}}};
    const MassProperties expected{4, Vector3d(0, 0.75, 0), Vector3d(2.15, 1.6, 2.15).asDiagonal()};

    require_mass_properties(mesh_mass_properties(mesh, 1), expected, 3, 16);
}

TEST_CASE("inertia: any tetrahedron is as heavy to turn as its four Gauss points",
          "[A2.13][inertia]")
{
    for (Random random : seeds(100)) {
        const Vector3d a = random.vector(), b = random.vector(), c = random.vector();
        const TriangleMesh mesh = tetrahedron(a, b, c, random.vector());
        const double density = 100 * random.mass();
        const MassProperties expected = sum_of(gauss_points(mesh, density));
        if (expected.mass < 0.1 * density) continue; // rounding dominates in a sliver

        const MassProperties found = mesh_mass_properties(mesh, density);

        require_mass_properties(found, expected, 3, 64);
    }
}

TEST_CASE("inertia: a mesh that moves and turns takes its inertia along", "[A2.13][inertia]")
{
    for (Random random : seeds(100)) {
        const Vector3d size(1, 2, 3), X = 3 * random.vector();
        const Matrix3d R = random.rotation();
        const TriangleMesh mesh = moved(box(-size / 2, size), R, X);
        const Matrix3d I_body = Vector3d(13, 10, 5).asDiagonal();

        const MassProperties found = mesh_mass_properties(mesh, 2);

        require_mass_properties(found, {12, X, R * I_body * R.transpose()}, X.norm() + 3, 128);
    }
}

TEST_CASE("inertia: a box with a hollow is a box less a box", "[A2.13][inertia]")
{
    TriangleMesh mesh = box(Vector3d(-2, -2, -2), Vector3d(4, 4, 4));
    TriangleMesh hollow = box(Vector3d(-1, -1, -1), Vector3d(2, 2, 2));
    for (const auto& [i, j, k] : hollow.triangles) // reversed, since its outside is the hollow
        mesh.triangles.push_back({i + 8, k + 8, j + 8});
    mesh.vertices.insert(mesh.vertices.end(), hollow.vertices.begin(), hollow.vertices.end());

    // I = M a²/6 for each cube: 64 · 16/6 - 8 · 4/6
    const MassProperties expected{56, Vector3d::Zero(), (1024 - 32) / 6.0 * Matrix3d::Identity()};
    require_mass_properties(mesh_mass_properties(mesh, 1), expected, 4, 128);
}

TEST_CASE("inertia: a torus of triangles converges to second order", "[A2.13][inertia]")
{
    // V = 2 π² R a²; I/M is R² + ¾ a² about the axis of the torus and ½ R² + ⅝ a² about a diameter
    const double R = 2, a = 0.5;
    std::vector<double> volume_errors, axial_errors, across_errors;
    for (const int n : {16, 32, 64}) {
        const MassProperties found = mesh_mass_properties(torus(R, a, n), 1);

        volume_errors.push_back(std::abs(found.mass - 9.86960440108936));
        axial_errors.push_back(std::abs(found.inertia(1, 1) / found.mass - 4.1875));
        across_errors.push_back(std::abs(found.inertia(0, 0) / found.mass - 2.15625));
    }
    check_order(volume_errors, 2);
    check_order(axial_errors, 2);
    check_order(across_errors, 2);
    check_at_most(volume_errors.back(), 0.04, "error of the volume with 64 sections [m³]");
}

TEST_CASE("inertia: icospheres fill the sphere", "[A2.13][inertia]")
{
    TriangleMesh mesh = icosahedron();
    for (const double share :
         {0.6054613829125256, 0.8734532000030632, 0.9661607485985871, 0.9913938426297548}) {
        CAPTURE(mesh.triangles.size());

        const MassProperties found = mesh_mass_properties(mesh, 1);

        REQUIRE_THAT(found.mass / (4 * pi / 3), IsClose(share, Rounding(512, 1)));
        INFO("its symmetry leaves no axis apart");
        const Matrix3d round = found.inertia.trace() / 3 * Matrix3d::Identity();
        REQUIRE_THAT(found.inertia, IsClose(round, Rounding(256, share * 4 * pi / 3)));
        mesh = refined(mesh);
    }
}

TEST_CASE("inertia: a mesh without volume is nothing", "[A2.13][inertia]")
{
    REQUIRE_THAT(mesh_mass_properties({}, 1000), IsExactly(MassProperties{}));
    INFO("vertices alone");
    REQUIRE_THAT(mesh_mass_properties({{{1, 2, 3}}, {}}, 1000), IsExactly(MassProperties{}));
    INFO("a triangle with two sides");
    const TriangleMesh flat{{{0, 0, 1}, {3, 0, 1}, {0, 3, 1}}, {{0, 1, 2}, {0, 2, 1}}};
    REQUIRE_THAT(mesh_mass_properties(flat, 1000), IsExactly(MassProperties{}));
}

TEST_CASE("inertia: an open mesh gives something finite", "[A2.13][inertia]")
{
    for (Random random : seeds(20)) {
        TriangleMesh mesh =
            moved(box(-Vector3d::Ones(), Vector3d(1, 2, 3)), random.rotation(), random.vector());
        mesh.triangles.resize(11); // leaves a hole

        const MassProperties found = mesh_mass_properties(mesh, 1000);

        CAPTURE(found);
        check_that(std::isfinite(found.mass) && found.center_of_mass.allFinite() &&
                       found.inertia.allFinite(),
                   "numbers that are finite, also for a mesh with a hole");
    }
}

TEST_CASE("inertia: a plate however thin has the mass of its volume", "[A2.13][inertia]")
{
    // the plate is 1 m from the origin, so tetrahedra with the origin are much larger than the
    // plate
    for (int power = 1; power <= 40; ++power)
        for (int axis = 0; axis < 3; ++axis) {
            CAPTURE(power, axis);
            const double thickness = std::ldexp(1, -power);
            Vector3d size = Vector3d::Ones(), corner = Vector3d::Zero();
            size[axis] = thickness;
            corner[axis] = 1;
            const MassProperties found = mesh_mass_properties(box(corner, size), 8);
            REQUIRE_THAT(found.mass, IsClose(8 * thickness, Rounding(16, 8)));
        }
}

TEST_CASE("inertia: a small mesh and a needle have the mass of their volume", "[A2.13][inertia]")
{
    // one corner of the box is the origin, or all are as far from it as the box is long
    for (int power = 0; power <= 60; power += 3)
        for (const bool is_needle : {false, true})
            for (const double shift : {0.0, 1.0}) {
                CAPTURE(power, is_needle, shift);
                const double small = std::ldexp(1, is_needle ? -power / 3 : -power);
                const Vector3d size(is_needle ? 1 : small, small, small);
                const Vector3d corner = shift * Vector3d(size.x(), 0, 0);
                const double M = 8 * size.prod();
                const MassProperties found = mesh_mass_properties(box(corner, size), 8);
                REQUIRE_THAT(found.mass, IsClose(M, Rounding(64)));
                REQUIRE_THAT(found.inertia(1, 1),
                             IsClose(M / 12 * (size.x() * size.x() + small * small),
                                     Rounding(64, 4 * M * size.x() * size.x())));
            }
}

TEST_CASE("inertia: a vertex that no triangle uses changes nothing", "[A2.13][inertia]")
{
    // The vertex may move the point about which a sum is taken, but not far: that would cost
    // digits.
    for (const double distance : {1.0, 4.0}) {
        CAPTURE(distance);
        TriangleMesh mesh = box({0, 0, 0}, {1, 2, 4});
        const MassProperties expected = mesh_mass_properties(mesh, 3);
        mesh.vertices.emplace_back(distance, -distance, 2 * distance);
        const MassProperties found = mesh_mass_properties(mesh, 3);
        REQUIRE_THAT(found.mass, IsClose(expected.mass, Rounding(256)));
        REQUIRE_THAT(found.center_of_mass, IsClose(expected.center_of_mass, Rounding(256)));
        REQUIRE_THAT(found.inertia, IsClose(expected.inertia, Rounding(256)));
    }
}
