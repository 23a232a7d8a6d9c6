// SPDX-License-Identifier: MIT
// A2.6 to A2.10: solids whose mass properties have a closed form.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

MassProperties centered(double M, double Ixx, double Iyy, double Izz)
{
    return {M, Vector3d::Zero(), Vector3d(Ixx, Iyy, Izz).asDiagonal()};
}

// A solid that is scaled by `factor`: its mass grows by factor³ and its inertia by factor⁵.
MassProperties enlarged(const MassProperties& solid, double factor)
{
    const double cube = factor * factor * factor;
    return {cube * solid.mass, factor * solid.center_of_mass,
            cube * factor * factor * solid.inertia};
}

// Edges or radii of which one, two or all are 0.
const Vector3d without_thickness[] = {{0, 2, 3}, {1, 0, 3}, {1, 2, 0}, {1, 0, 0},
                                      {0, 2, 0}, {0, 0, 3}, {0, 0, 0}};

} // namespace

TEST_CASE("inertia: a solid sphere by hand", "[A2.6][inertia]")
{
    // M = ρ 4/3 π 27 = 72 π for ρ = 2 and r = 3;  I = 2/5 · 72 π · 9
    const double I = 1296 * pi / 5;

    require_mass_properties(solid_sphere(2, 3), centered(72 * pi, I, I, I), 3, 8);
}

TEST_CASE("inertia: spheres scale with the fifth power of their size", "[A2.6][inertia]")
{
    for (Random random : seeds(20)) {
        const double density = 1000 * random.mass(), r = random.uniform(0.1, 1);

        require_mass_properties(solid_sphere(density, 2 * r), enlarged(solid_sphere(density, r), 2),
                                2 * r, 16);
    }
}

TEST_CASE("inertia: a sphere without size weighs nothing", "[A2.6][inertia]")
{
    REQUIRE_THAT(solid_sphere(1000, 0), IsExactly(MassProperties{}));
}

TEST_CASE("inertia: a box of 1 by 2 by 3 meters and 12 kg", "[A2.7][inertia]")
{
    require_mass_properties(solid_box(2, Vector3d(1, 2, 3)), centered(12, 13, 10, 5), 3, 8);
}

TEST_CASE("inertia: the moments of a box add up to its second moments", "[A2.7][inertia]")
{
    for (Random random : seeds(20)) {
        const double density = 1000 * random.mass();
        const double a = random.mass(), b = random.mass(), c = random.mass();

        const MassProperties box = solid_box(density, Vector3d(a, b, c));

        // Ixx + Iyy - Izz = 2 ∫ ρ z² dV = M c²/6, and so on
        const Vector3d I = box.inertia.diagonal();
        const Vector3d second = Vector3d::Constant(I.sum()) - 2 * I;
        const double M = density * a * b * c;
        REQUIRE_THAT(box.mass, IsClose(M, Rounding(32, M)));
        REQUIRE_THAT(second, IsClose(Vector3d(M / 6 * Vector3d(a * a, b * b, c * c)),
                                     Rounding(64, M * (a * a + b * b + c * c))));
    }
}

TEST_CASE("inertia: a box without thickness weighs nothing", "[A2.7][inertia]")
{
    for (const Vector3d& size : without_thickness)
        REQUIRE_THAT(solid_box(1000, size), IsExactly(MassProperties{}));
}

TEST_CASE("inertia: a solid cylinder by hand", "[A2.8][inertia]")
{
    // M = ρ π r² h = 24 π for ρ = 1, r = 2, h = 6;  Iyy = ½ M 4;  Ixx = Izz = M/12 (12 + 36)
    const double M = 24 * pi;

    require_mass_properties(solid_cylinder(1, 2, 6), centered(M, 4 * M, 2 * M, 4 * M), 6, 8);
}

TEST_CASE("inertia: a cylinder is a pile of cylinders", "[A2.8][inertia]")
{
    for (Random random : seeds(20)) {
        const double density = 1000 * random.mass(), r = random.mass(), h = random.mass();

        const MassProperties whole = solid_cylinder(density, r, 2 * h);
        const MassProperties half = solid_cylinder(density, r, h); // two of these, at ±h/2

        const double shift = 2 * half.mass * h * h / 4;
        const Matrix3d I = 2 * half.inertia + Matrix3d(Vector3d(shift, 0, shift).asDiagonal());
        require_mass_properties(whole, {2 * half.mass, Vector3d::Zero(), I}, r + 2 * h, 16);
    }
}

TEST_CASE("inertia: a cylinder without size weighs nothing", "[A2.8][inertia]")
{
    REQUIRE_THAT(solid_cylinder(1000, 0, 2), IsExactly(MassProperties{}));
    REQUIRE_THAT(solid_cylinder(1000, 1, 0), IsExactly(MassProperties{}));
    REQUIRE_THAT(solid_cylinder(1000, 0, 0), IsExactly(MassProperties{}));
}

TEST_CASE("inertia: a solid ellipsoid by hand", "[A2.9][inertia]")
{
    // M = ρ 4/3 π 1 2 3 = 40 π for ρ = 5;  I = M/5 (4 + 9), M/5 (9 + 1), M/5 (1 + 4)
    const MassProperties expected = centered(40 * pi, 104 * pi, 80 * pi, 40 * pi);

    require_mass_properties(solid_ellipsoid(5, Vector3d(1, 2, 3)), expected, 3, 8);
}

TEST_CASE("inertia: an ellipsoid with equal axes is a sphere", "[A2.9][inertia]")
{
    for (Random random : seeds(20)) {
        const double density = 1000 * random.mass(), r = random.mass();
        const double M = density * 4 / 3 * pi * r * r * r, I = 2 * M * r * r / 5;

        require_mass_properties(solid_ellipsoid(density, Vector3d(r, r, r)), centered(M, I, I, I),
                                r, 16);
    }
}

TEST_CASE("inertia: a flat ellipsoid weighs nothing", "[A2.9][inertia]")
{
    for (const Vector3d& radii : without_thickness)
        REQUIRE_THAT(solid_ellipsoid(1000, radii), IsExactly(MassProperties{}));
}

TEST_CASE("inertia: a thin rod by hand", "[A2.10][inertia]")
{
    // M = λ l = 6 for λ = 3, l = 2;  I = 6 · 4 / 12
    require_mass_properties(thin_rod(3, 2), centered(6, 2, 0, 2), 2, 8);
    INFO("its own axis is exactly without inertia");
    REQUIRE_THAT(thin_rod(3, 2).inertia(1, 1), IsExactly(0.0));
}

TEST_CASE("inertia: a rod is two rods in a row", "[A2.10][inertia]")
{
    for (Random random : seeds(20)) {
        const double line_density = random.mass(), l = random.mass();

        const MassProperties whole = thin_rod(line_density, 2 * l);
        const MassProperties half = thin_rod(line_density, l); // two of these, at ±l/2

        const double shift = 2 * half.mass * l * l / 4;
        const Matrix3d I = 2 * half.inertia + Matrix3d(Vector3d(shift, 0, shift).asDiagonal());
        require_mass_properties(whole, {2 * half.mass, Vector3d::Zero(), I}, 2 * l, 16);
    }
}

TEST_CASE("inertia: a rod without length weighs nothing", "[A2.10][inertia]")
{
    REQUIRE_THAT(thin_rod(3, 0), IsExactly(MassProperties{}));
}

namespace {

// Checks that a solid of negative density, a hole, has the opposite mass and inertia.
template <class Solid> void check_hole(const Solid& solid)
{
    for (Random random : seeds(10)) {
        const Vector3d size = random.vector().cwiseAbs();
        const double density = random.uniform(0.1, 20);
        const MassProperties full = solid(density, size), hole = solid(-density, size);
        REQUIRE_THAT(hole.mass, IsClose(-full.mass, Rounding(8)));
        REQUIRE_THAT(hole.inertia, IsClose(Matrix3d(-full.inertia), Rounding(8)));
        REQUIRE_THAT(hole.center_of_mass, IsClose(full.center_of_mass, Rounding(8)));
    }
}

} // namespace

TEST_CASE("inertia: a spherical hole", "[A2.6][inertia]")
{
    check_hole([](double density, const Vector3d& s) { return solid_sphere(density, s.x()); });
}

TEST_CASE("inertia: a hole that is a box", "[A2.7][inertia]")
{
    check_hole([](double density, const Vector3d& s) { return solid_box(density, s); });
}

TEST_CASE("inertia: a drilled hole", "[A2.8][inertia]")
{
    check_hole(
        [](double density, const Vector3d& s) { return solid_cylinder(density, s.x(), s.y()); });
}

TEST_CASE("inertia: a hole that is an ellipsoid", "[A2.9][inertia]")
{
    check_hole([](double density, const Vector3d& s) { return solid_ellipsoid(density, s); });
}

TEST_CASE("inertia: a rod that is taken away", "[A2.10][inertia]")
{
    check_hole([](double density, const Vector3d& s) { return thin_rod(density, s.x()); });
}
