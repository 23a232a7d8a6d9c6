// SPDX-License-Identifier: MIT
// A2: solids of every proportion, from leaves to needles, with sizes that are multiples of each
// other or nearly equal, and of every density.
#include "formulas/inertia.hpp"
#include "support/close.hpp"

#include <numbers>

namespace inertia_proportions_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

void check_solid(const MassProperties& solid, double mass, const Vector3d& moments)
{
    REQUIRE_THAT(solid.mass, IsClose(mass, Rounding(16)));
    REQUIRE_THAT(solid.center_of_mass, IsClose(Vector3d(0, 0, 0), Rounding(8, 0)));
    REQUIRE_THAT(solid.inertia,
                 IsClose(Matrix3d(moments.asDiagonal()), Rounding(32, moments.norm())));
}

void check_box(const Vector3d& a)
{
    CAPTURE(a);
    const double m = 3 * a.prod();
    const Vector3d q = a.cwiseAbs2();
    check_solid(solid_box(3, a), m, m / 12 * Vector3d(q.y() + q.z(), q.z() + q.x(), q.x() + q.y()));
}

void check_ellipsoid(const Vector3d& a)
{
    CAPTURE(a);
    const double m = 3 * 4 * pi / 3 * a.prod();
    const Vector3d q = a.cwiseAbs2();
    check_solid(solid_ellipsoid(3, a), m,
                m / 5 * Vector3d(q.y() + q.z(), q.z() + q.x(), q.x() + q.y()));
}

// Lengths of which some are multiples of others, some nearly equal to others, and some far larger.
template <class Check> void for_all_sizes(Check check)
{
    for (const double x : {1, 2, 3, 4, 6, 9})
        for (const double y : {1, 2, 3, 4, 6, 9})
            for (const double z : {1, 2, 3, 4, 6, 9})
                check(Vector3d(x, y, z));
    for (const double size : {10., 100., 1000., 2000., 4096., 65535., 65536., 1e6, 1e9})
        for (const double other : {1., 2., 3.}) // whole numbers whose products are large
            check(Vector3d(size, other * size, size));
    for (int axis = 0; axis < 3; ++axis)
        for (int power = -60; power <= 60; power += 4) {
            Vector3d a(1, 1.5, 2);
            a[axis] = std::ldexp(1, power);
            check(a);
        }
    for (int power = -4; power >= -44; power -= 4)
        for (int axis = 0; axis < 3; ++axis)
            for (const double other : {0, 1, -1}) {
                Vector3d a(1, 1, 1);
                a[axis] += std::ldexp(1, power);
                a[(axis + 1) % 3] += other * std::ldexp(1, power);
                check(a);
            }
}

// The solid of a density from next to nothing to next to infinity has the same multiple of the mass
// and the inertia.
template <class Solid> void check_densities(Solid solid)
{
    const MassProperties one = solid(1.0);
    for (const int power : {-400, -360, 360, 400}) {
        CAPTURE(power);
        const double density = std::ldexp(1, power);
        const MassProperties found = solid(density);
        REQUIRE_THAT(found.mass / density, IsClose(one.mass, Rounding(16)));
        REQUIRE_THAT(Matrix3d(found.inertia / density), IsClose(one.inertia, Rounding(32)));
    }
}

} // namespace

TEST_CASE("inertia: boxes of all proportions", "[A2.7][inertia]")
{
    for_all_sizes(check_box);
}

TEST_CASE("inertia: ellipsoids of all proportions", "[A2.9][inertia]")
{
    for_all_sizes(check_ellipsoid);
}

TEST_CASE("inertia: cylinders of all proportions", "[A2.8][inertia]")
{
    for_all_sizes([](const Vector3d& a) {
        const double r = a.x(), l = a.y(), m = 3 * pi * r * r * l;
        CAPTURE(r, l);
        const MassProperties solid = solid_cylinder(3, r, l);
        const double across = m / 12 * (3 * r * r + l * l), along = m * r * r / 2;
        check_solid(solid, m, {across, along, across});
    });
}

TEST_CASE("inertia: spheres of all sizes", "[A2.6][inertia]")
{
    for_all_sizes([](const Vector3d& a) {
        const double density = a.x(), r = a.y(), m = density * 4 * pi / 3 * r * r * r;
        CAPTURE(density, r);
        check_solid(solid_sphere(density, r), m, 2 * m / 5 * r * r * Vector3d(1, 1, 1));
    });
}

TEST_CASE("inertia: rods of all lengths", "[A2.10][inertia]")
{
    for_all_sizes([](const Vector3d& a) {
        const double line_density = a.x(), l = a.y(), m = line_density * l, across = m / 12 * l * l;
        CAPTURE(line_density, l);
        check_solid(thin_rod(line_density, l), m, {across, 0, across});
    });
}

TEST_CASE("inertia: spheres of all densities", "[A2.6][inertia]")
{
    check_densities([](double density) { return solid_sphere(density, 2); });
}

TEST_CASE("inertia: boxes of all densities", "[A2.7][inertia]")
{
    check_densities([](double density) { return solid_box(density, {1, 2, 3}); });
}

TEST_CASE("inertia: cylinders of all densities", "[A2.8][inertia]")
{
    check_densities([](double density) { return solid_cylinder(density, 2, 3); });
}

TEST_CASE("inertia: ellipsoids of all densities", "[A2.9][inertia]")
{
    check_densities([](double density) { return solid_ellipsoid(density, {1, 2, 3}); });
}

TEST_CASE("inertia: rods of all densities", "[A2.10][inertia]")
{
    check_densities([](double density) { return thin_rod(density, 3); });
}

} // namespace inertia_proportions_test
