// SPDX-License-Identifier: MIT
// A2: moments of very different or nearly equal size, solids as thin as a leaf, one cell, many
// samples, a mesh that is inside out.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <numbers>

namespace inertia_ranges_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

Matrix3d turned(const Matrix3d& R, const Matrix3d& I)
{
    const Matrix3d result = R * I * R.transpose();
    return (result + result.transpose()) / 2;
}

void check_axes(const Matrix3d& I)
{
    const auto [Q, moments] = principal_axes(I);
    REQUIRE_THAT(Q, IsRotation());
    INFO("I = Q diag(moments) Qᵀ");
    REQUIRE_THAT(Matrix3d(Q * moments.asDiagonal() * Q.transpose()),
                 IsClose(I, Rounding(256, I.norm())));
}

// The twelve triangles of a box, counter-clockwise seen from outside.
TriangleMesh box_mesh(const Vector3d& low, const Vector3d& size)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(low + size.cwiseProduct(Vector3d(i & 1, i >> 1 & 1, i >> 2)));
    for (int a = 0; a < 3; ++a)
        for (int side = 0; side < 2; ++side) {
            const int b = 1 << (a + 1) % 3, c = 1 << (a + 2) % 3, first = side << a;
            int corners[4] = {first, first + b, first + b + c, first + c};
            if (side == 0) std::swap(corners[1], corners[3]);
            mesh.triangles.push_back({corners[0], corners[1], corners[2]});
            mesh.triangles.push_back({corners[0], corners[2], corners[3]});
        }
    return mesh;
}

} // namespace

TEST_CASE("inertia: an inverse with very different moments is only turned", "[A2.3][inertia]")
{
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        for (int power = 1; power <= 12; ++power) {
            const double ratio = std::pow(10.0, -power);
            CAPTURE(ratio);
            const Matrix3d inverse = Vector3d(1, ratio, 1).asDiagonal();
            REQUIRE_THAT(world_inverse_inertia(R, inverse),
                         IsClose(turned(R, inverse), Rounding(32, 3)));
        }
    }
}

TEST_CASE("inertia: principal axes of nearly a rod and of nearly a ball", "[A2.4][inertia]")
{
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation(), other = random.positive_definite();
        for (int power = 1; power <= 15; ++power) {
            const double share = std::pow(10.0, -power);
            CAPTURE(share);
            check_axes(turned(R, Vector3d(share, 1, 1 + share).asDiagonal()));
            check_axes(Matrix3d::Identity() + share * other);
        }
    }
}

TEST_CASE("inertia: a moment at the threshold counts as 0", "[A2.5][inertia]")
{
    // with a power of two, 1e-12 times the largest moment is exact
    for (int power = -500; power <= 500; power += 50)
        for (int i = 0; i < 3; ++i) {
            CAPTURE(power, i);
            const double largest = std::exp2(power);
            Vector3d moments = Vector3d::Constant(largest);
            moments[i] = 1e-12 * largest;
            Vector3d expected = Vector3d::Constant(1 / largest);
            expected[i] = 0;
            REQUIRE_THAT(invert_moments(moments), IsClose(expected, Rounding(8)));
        }
}

TEST_CASE("inertia: boxes as thin as a leaf have mass and moments", "[A2.7][inertia]")
{
    for (int power = 0; power <= 15; ++power) {
        const double c = std::pow(10.0, -power), M = 2 * 2 * 3 * c;
        CAPTURE(c);
        const MassProperties leaf = solid_box(2, {2, 3, c});
        REQUIRE_THAT(leaf.mass, IsClose(M, Rounding(8)));
        const Vector3d moments = M / 12 * Vector3d(9 + c * c, 4 + c * c, 13);
        REQUIRE_THAT(leaf.inertia, IsClose(Matrix3d(moments.asDiagonal()), Rounding(16)));
    }
}

// Solids so large or small that a power of a length above the square overflows or underflows, with
// a density that makes the mass and the moments ordinary numbers for a double.
TEST_CASE("inertia: a ball whose fifth power is no double", "[A2.6][inertia]")
{
    for (const double r : {1e62, 1e-65}) {
        CAPTURE(r);
        const double M = 4. / 3 * pi;
        const MassProperties ball = solid_sphere(1 / (r * r) / r, r);
        REQUIRE_THAT(ball.mass, IsClose(M, Rounding(32)));
        REQUIRE_THAT(ball.inertia,
                     IsClose(Matrix3d(0.4 * M * (r * r) * Matrix3d::Identity()), Rounding(64)));
    }
}

TEST_CASE("inertia: a cylinder whose fourth power is no double", "[A2.8][inertia]")
{
    const double r = 1e78, l = 2e78, M = 1e-60;
    const MassProperties cylinder = solid_cylinder(M / (pi * r * r) / l, r, l);
    REQUIRE_THAT(cylinder.mass, IsClose(M, Rounding(32)));
    const Vector3d moments = M * r * r * Vector3d(7. / 12, 0.5, 7. / 12);
    REQUIRE_THAT(cylinder.inertia, IsClose(Matrix3d(moments.asDiagonal()), Rounding(64)));
}

TEST_CASE("inertia: a rod whose cube is no double", "[A2.10][inertia]")
{
    const double l = 1e104, M = 1e-70, across = M * l * l / 12;
    const MassProperties rod = thin_rod(M / l, l);
    REQUIRE_THAT(rod.mass, IsClose(M, Rounding(8)));
    REQUIRE_THAT(rod.inertia.trace(), IsClose(2 * across, Rounding(32)));
}

TEST_CASE("inertia: cylinders as thin as a leaf have mass and moments", "[A2.8][inertia]")
{
    for (int power = 0; power <= 15; ++power) {
        const double l = std::pow(10.0, -power), M = 2 * pi * 9 * l;
        CAPTURE(l);
        const MassProperties leaf = solid_cylinder(2, 3, l);
        REQUIRE_THAT(leaf.mass, IsClose(M, Rounding(32)));
        const double across = M / 12 * (27 + l * l);
        const Vector3d moments(across, M * 4.5, across);
        REQUIRE_THAT(leaf.inertia, IsClose(Matrix3d(moments.asDiagonal()), Rounding(64)));
    }
}

TEST_CASE("inertia: ellipsoids as thin as a leaf have mass and moments", "[A2.9][inertia]")
{
    for (int power = 0; power <= 15; ++power) {
        const double c = std::pow(10.0, -power), M = 2 * 4 / 3.0 * pi * 2 * 3 * c;
        CAPTURE(c);
        const MassProperties leaf = solid_ellipsoid(2, {2, 3, c});
        REQUIRE_THAT(leaf.mass, IsClose(M, Rounding(32)));
        const Vector3d moments = M / 5 * Vector3d(9 + c * c, 4 + c * c, 13);
        REQUIRE_THAT(leaf.inertia, IsClose(Matrix3d(moments.asDiagonal()), Rounding(64)));
    }
}

TEST_CASE("inertia: a single cell has no inertia of its own", "[A2.11][inertia]")
{
    for (Random random : seeds(10)) {
        const Vector3d center = random.vector();
        const MassProperties cell = grid_mass_properties({{center, 3}}, 0.5);
        const MassProperties expected = {0.375, center, Matrix3d::Zero()};
        REQUIRE_THAT(cell, IsClose(expected, Rounding(8, 2)));
    }
}

TEST_CASE("inertia: many samples share the volume equally", "[A2.12][inertia]")
{
    for (const int n : {1, 10, 60, 1000}) {
        CAPTURE(n);
        Random random(1);
        std::vector<DensitySample> samples;
        for (int i = 0; i < n; ++i)
            samples.push_back({random.vector(), 5});
        // a sum of n terms may be wrong by n eps of their magnitudes
        REQUIRE_THAT(sampled_mass_properties(samples, 3).mass, IsClose(15.0, Rounding(8 + n, 15)));
    }
}

TEST_CASE("inertia: a mesh inside out has negative mass and inertia", "[A2.13][inertia]")
{
    for (Random random : seeds(30)) {
        const Vector3d low = random.vector(), q(random.mass(), random.mass(), random.mass());
        const Vector3d size = q / q.maxCoeff();
        TriangleMesh mesh = box_mesh(low, size);
        for (std::array<int, 3>& triangle : mesh.triangles)
            std::swap(triangle[0], triangle[1]);
        const double M = -2 * size.prod(), far = (low.cwiseAbs() + size).norm();
        const Vector3d squares = size.cwiseAbs2();
        const Matrix3d I =
            M / 12 * (squares.sum() * Matrix3d::Identity() - Matrix3d(squares.asDiagonal()));
        const MassProperties found = mesh_mass_properties(mesh, 2);
        // 12 tetrahedra about the origin have a sum of volumes of at most 12/6 far³
        const double volumes = 2 * far * far * far;
        REQUIRE_THAT(found.mass, IsClose(M, Rounding(64, volumes)));
        REQUIRE_THAT(found.center_of_mass,
                     IsClose(Vector3d(low + size / 2), Rounding(64, far * volumes / -M)));
        REQUIRE_THAT(found.inertia, IsClose(I, Rounding(64, far * far * volumes)));
    }
}

} // namespace inertia_ranges_test
