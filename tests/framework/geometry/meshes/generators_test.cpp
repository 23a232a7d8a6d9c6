// SPDX-License-Identifier: MIT
#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "geometry/meshes/triangle.hpp"
#include "support/close.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

// The volume of a polygon turned in n steps, divided by that of the smooth solid of revolution.
double in_steps(int n)
{
    return n / (2 * pi) * std::sin(2 * pi / n);
}

} // namespace

TEST_CASE("generators: every mesh is a solid", "[geometry]")
{
    for (const TriangleMesh& mesh :
         {box_mesh({1, 2, 3}), icosphere(1, 0), icosphere(2, 3), torus_mesh(1, 0.3, 3, 3),
          torus_mesh(1, 0.3, 48, 24), ring_mesh(0.5, 1, 0.3, 48), ring_mesh(0.1, 1, 3, 3),
          cross_mesh(3, 1), bowl_mesh(1, 0.1, 48), bowl_mesh(1, 0.9, 3), gear_mesh(4, 1, 0.2, 0.3),
          gear_mesh(24, 1, 0, 0.3), gear_mesh(200, 1, 0.9, 0.1), angle_mesh({1, 2, 0.5}, 0.3),
          voussoir_mesh(1, 1.3, 15, 0.5), voussoir_mesh(1, 2, 90, 0.5)})
        REQUIRE_NOTHROW(check_mesh(mesh));
}

TEST_CASE("generators: volumes are those of their closed forms", "[geometry]")
{
    const auto volume = [](const TriangleMesh& mesh) { return signed_volume(mesh); };
    CHECK_THAT(volume(box_mesh({1, 2, 3})), IsClose(6.0, Rounding(16)));
    CHECK_THAT(volume(cross_mesh(3, 1)), IsClose(3 * 3.0 - 2, Rounding(64)));
    CHECK_THAT(volume(angle_mesh({1, 2, 0.5}, 0.3)),
               IsClose((2 * 0.3 + 0.7 * 0.3) * 0.5, Rounding(64)));
    CHECK_THAT(volume(ring_mesh(0.5, 1, 0.3, 48)),
               IsClose(in_steps(48) * pi * 0.75 * 0.3, Rounding(256)));
    // Pappus: the volume is the area of the section times the path length of its center.
    CHECK_THAT(volume(torus_mesh(2, 0.5, 64, 32)),
               IsClose(in_steps(64) * 2 * pi * 2 * (in_steps(32) * pi * 0.25), Rounding(1024)));
    const double half = 15 * pi / 360;
    CHECK_THAT(volume(voussoir_mesh(1, 1.3, 15, 0.5)),
               IsClose((1.69 - 1) * std::sin(half) * std::cos(half) * 0.5, Rounding(64)));
    // A gear: one triangle for each two neighboring points of the outline, minus the polygon of
    // the bore.
    const int teeth = 12;
    const double pitch = 2 * pi / teeth, depth = pi / teeth, root = 1 - 0.6 * depth,
                 tip = 1 + 0.5 * depth;
    const auto triangle = [&](double r, double s, double angle) {
        return r * s * std::sin(angle * pitch) / 2;
    };
    const double bore =
        2 * triangle(0.3, 0.3, 0.18) + triangle(0.3, 0.3, 0.3) + triangle(0.3, 0.3, 0.34);
    const double tooth =
        2 * triangle(root, tip, 0.18) + triangle(tip, tip, 0.3) + triangle(root, root, 0.34) - bore;
    CHECK_THAT(volume(gear_mesh(teeth, 1, 0.3, 0.25)),
               IsClose(teeth * tooth * 0.25, Rounding(256)));
}

TEST_CASE("generators: a finer torus comes nearer to the round one", "[geometry]")
{
    std::vector<double> errors; // R = 2, a = 0.5: V = 9.86960440108936
    for (const int n : {12, 24, 48, 96})
        errors.push_back(std::abs(signed_volume(torus_mesh(2, 0.5, 2 * n, n)) - 9.86960440108936));
    check_order(errors, 2);
    CHECK(errors.back() < 0.02);
}

TEST_CASE("generators: a bowl holds what lies between two half balls", "[geometry]")
{
    std::vector<double> errors;
    for (const int n : {24, 48, 96, 192})
        errors.push_back(
            std::abs(signed_volume(bowl_mesh(1, 0.2, n)) - 2.0 / 3 * pi * (1 - 0.8 * 0.8 * 0.8)));
    check_order(errors, 2);
    CHECK_THAT(bounds_of(bowl_mesh(1, 0.2, 48)).low, IsClose(Vector3d(-1, -1, -1), Rounding(4)));
    CHECK_THAT(bounds_of(bowl_mesh(1, 0.2, 48)).high, IsClose(Vector3d(1, 0, 1), Rounding(4)));
}

TEST_CASE("generators: sizes are those asked for", "[geometry]")
{
    const auto has = [](const TriangleMesh& mesh, const Vector3d& low, const Vector3d& high) {
        CHECK_THAT(bounds_of(mesh).low, IsClose(low, Rounding(4)));
        CHECK_THAT(bounds_of(mesh).high, IsClose(high, Rounding(4)));
    };
    has(cross_mesh(3, 1), {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5});
    has(ring_mesh(0.5, 1, 0.3, 48), {-1, -0.15, -1}, {1, 0.15, 1});
    has(angle_mesh({1, 2, 0.5}, 0.3), {-0.5, -1, -0.25}, {0.5, 1, 0.25});
    has(torus_mesh(1, 0.25, 48, 24), {-1.25, -0.25, -1.25}, {1.25, 0.25, 1.25});
    const double s = std::sin(pi / 24), c = std::cos(pi / 24);
    has(voussoir_mesh(1, 1.3, 15, 0.5), {-1.3 * s, c, -0.25}, {1.3 * s, 1.3 * c, 0.25});
}

TEST_CASE("generators: an outline that crosses itself makes no solid", "[geometry]")
{
    CHECK_THROWS_AS(check_mesh(extruded({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1)), MeshError);
}
