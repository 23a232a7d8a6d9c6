// SPDX-License-Identifier: MIT
// A2.13: closed surfaces of every build: with vertices that no two triangles share, with a hollow
// that is listed first, with edges that end on the side of a triangle, of several parts.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <utility>

namespace inertia_surfaces_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A solid between the corner and the three edges from there.
TriangleMesh parallelepiped(const Vector3d& corner, const Matrix3d& edges)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(corner + edges * Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TriangleMesh cube(const Vector3d& corner, double size)
{
    return parallelepiped(corner, size * Matrix3d::Identity());
}

TriangleMesh hollow(TriangleMesh mesh)
{
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

TriangleMesh both(TriangleMesh first, const TriangleMesh& second)
{
    const int n = static_cast<int>(first.vertices.size());
    for (const auto& [i, j, k] : second.triangles)
        first.triangles.push_back({n + i, n + j, n + k});
    first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
    return first;
}

// The same surface, in which each triangle has three vertices of its own.
TriangleMesh with_own_vertices(const TriangleMesh& mesh)
{
    TriangleMesh result;
    for (const auto& triangle : mesh.triangles) {
        const int n = static_cast<int>(result.vertices.size());
        for (int vertex : triangle)
            result.vertices.push_back(mesh.vertices[vertex]);
        result.triangles.push_back({n, n + 1, n + 2});
    }
    return result;
}

} // namespace

TEST_CASE("inertia: triangles need not share their vertices", "[A2.13][inertia]")
{
    for (Random random : seeds(10)) {
        const Vector3d size(1, 2, 3), X = random.vector();
        const Matrix3d R = random.rotation(),
                       I = R * Vector3d(13, 10, 5).asDiagonal() * R.transpose();
        const TriangleMesh box =
            parallelepiped(X - R * size / 2, Matrix3d(R * Matrix3d(size.asDiagonal())));
        require_mass_properties(mesh_mass_properties(with_own_vertices(box), 2), {12, X, I},
                                X.norm() + 3, 64);
    }
}

TEST_CASE("inertia: a hollow may be listed first", "[A2.13][inertia]")
{
    // I = M a²/6 for each cube: 64 · 16/6 - 8 · 4/6
    const MassProperties expected{56, Vector3d::Zero(), (1024 - 32) / 6.0 * Matrix3d::Identity()};
    const TriangleMesh mesh =
        both(hollow(cube(Vector3d::Constant(-1), 2)), cube(Vector3d::Constant(-2), 4));
    require_mass_properties(mesh_mass_properties(mesh, 1), expected, 4, 128);
}

TEST_CASE("inertia: an edge may end on the side of a triangle", "[A2.13][inertia]")
{
    // A point on an edge of the box, which one of the two triangles there has as a corner: the
    // surface is closed, with 13 triangles.
    for (Random random : seeds(10)) {
        TriangleMesh mesh =
            parallelepiped(Vector3d::Zero(), Vector3d(1, 2, 3).asDiagonal().toDenseMatrix());
        const int at = random_index(random, mesh.triangles.size());
        const auto [i, j, k] = mesh.triangles[at];
        const int middle = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back((mesh.vertices[i] + mesh.vertices[j]) / 2);
        mesh.triangles[at] = {i, middle, k};
        mesh.triangles.push_back({middle, j, k});
        const MassProperties expected{12, Vector3d(0.5, 1, 1.5), Vector3d(13, 10, 5).asDiagonal()};
        require_mass_properties(mesh_mass_properties(mesh, 2), expected, 4, 64);
    }
}

TEST_CASE("inertia: a small part beside a large one has mass", "[A2.13][inertia]")
{
    for (int power = 1; power <= 14; ++power) {
        CAPTURE(power);
        const double a = std::ldexp(1, -power), m = a * a * a;
        const TriangleMesh large = cube(Vector3d::Zero(), 1), small = cube({2, 0, 0}, a);
        for (const TriangleMesh& mesh : {both(large, small), both(small, large)}) {
            const auto [M, X, I] = mesh_mass_properties(mesh, 1);
            REQUIRE_THAT(M, IsClose(1 + m, Rounding(256)));
            REQUIRE_THAT(X.x(), IsClose((0.5 + m * (2 + a / 2)) / (1 + m), Rounding(512, 1)));
        }
    }
}

TEST_CASE("inertia: what is left of a solid with a large hole has mass", "[A2.13][inertia]")
{
    // a cube, and a hole that is nearly as large
    for (int power = 1; power <= 36; ++power) {
        CAPTURE(power);
        const double left = std::ldexp(1, -power);
        const TriangleMesh solid = cube(Vector3d::Zero(), 1),
                           hole = hollow(parallelepiped(
                               {2, 0, 0}, Vector3d(1, 1, 1 - left).asDiagonal().toDenseMatrix()));
        REQUIRE_THAT(mesh_mass_properties(both(solid, hole), 1).mass,
                     IsClose(left, Rounding(64, 4)));
    }
}

TEST_CASE("inertia: a solid that is nearly symmetric has a small product of inertia",
          "[A2.13][inertia]")
{
    // a cube of 1 m and 12 kg, sheared by h: Ixy = -M h/12
    for (int power = 1; power <= 44; ++power)
        for (int axis = 0; axis < 3; ++axis) {
            CAPTURE(power, axis);
            const int next = (axis + 1) % 3;
            const double h = std::ldexp(1, -power);
            Matrix3d edges = Matrix3d::Identity();
            edges(next, axis) = h;
            const Matrix3d I =
                mesh_mass_properties(parallelepiped(-edges * Vector3d::Ones() / 2, edges), 12)
                    .inertia;
            REQUIRE_THAT(I(axis, next), IsClose(-h, Rounding(64, 2)));
        }
}

} // namespace inertia_surfaces_test
