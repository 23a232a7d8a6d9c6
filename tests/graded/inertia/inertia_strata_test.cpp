// SPDX-License-Identifier: MIT
// A2: equal elements of a list, light and dense parts beside each other, parts that nearly
// coincide, and solids that are nearly of a simpler kind.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <numbers>

namespace inertia_strata_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::size_t many = 1 << 12; // repetitions

template <class T> std::vector<T> repeated(const std::vector<T>& list, std::size_t times)
{
    std::vector<T> result;
    for (std::size_t i = 0; i < times; ++i)
        result.insert(result.end(), list.begin(), list.end());
    return result;
}

std::vector<DensitySample> samples(Random& random)
{
    std::vector<DensitySample> result;
    for (int i = 0; i < 3; ++i)
        result.push_back({random.vector(), random.uniform(0.1, 1)});
    return result;
}

// The same body with `times` its density.
MassProperties heavier(MassProperties body, double times)
{
    body.mass *= times;
    body.inertia *= times;
    return body;
}

// The surface of the unit tetrahedron. A vertex at the share s of the edge from (1, 0, 0) to
// (0, 1, 0) divides the two triangles that meet there.
TriangleMesh tetrahedron_with_slivers(double s)
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1 - s, s, 0}},
            {{0, 2, 4}, {0, 4, 1}, {1, 4, 3}, {4, 2, 3}, {0, 1, 3}, {0, 3, 2}}};
}

} // namespace

TEST_CASE("inertia: equal particles count each time", "[A2.1][inertia]")
{
    for (Random random : seeds(2)) {
        const std::vector<Particle> three = random.particles(3);
        require_mass_properties(particle_mass_properties(repeated(three, many)),
                                heavier(sum_of(three), many), 2, 8 * many);
    }
}

TEST_CASE("inertia: equal cells count each time", "[A2.11][inertia]")
{
    for (Random random : seeds(2)) {
        const std::vector<DensitySample> three = samples(random);
        require_mass_properties(grid_mass_properties(repeated(three, many), 0.5),
                                heavier(grid_mass_properties(three, 0.5), many), 2, 8 * many);
    }
}

TEST_CASE("inertia: equal samples share the volume", "[A2.12][inertia]")
{
    for (Random random : seeds(2)) {
        std::vector<DensitySample> three = samples(random);
        three.push_back(three[0]); // counts twice
        std::vector<Particle> particles;
        for (const auto& [position, density] : three)
            particles.push_back({density / 8, position});
        require_mass_properties(sampled_mass_properties(three, 0.5), sum_of(particles), 2, 64);
        require_mass_properties(sampled_mass_properties(repeated(three, many), 0.5),
                                sum_of(particles), 2, 16 * many);
    }
}

TEST_CASE("inertia: a solid that is there twice weighs twice", "[A2.13][inertia]")
{
    TriangleMesh mesh = tetrahedron_with_slivers(0.5);
    const MassProperties once = mesh_mass_properties(mesh, 2);
    mesh.triangles = repeated(mesh.triangles, 2);
    require_mass_properties(mesh_mass_properties(mesh, 2), heavier(once, 2), 1, 64);
}

TEST_CASE("inertia: thin triangles belong to the surface", "[A2.13][inertia]")
{
    const MassProperties expected = mesh_mass_properties(tetrahedron_with_slivers(0.5), 1);
    for (int power = 1; power <= 40; ++power) {
        CAPTURE(power);
        for (const double s : {std::ldexp(1, -power), 1 - std::ldexp(1, -power)})
            require_mass_properties(mesh_mass_properties(tetrahedron_with_slivers(s), 1), expected,
                                    1, 256);
    }
}

TEST_CASE("inertia: a solid as thin as a leaf has mass", "[A2.13][inertia]")
{
    // the tetrahedron between the origin and the points h, 1, 1 on the axes: M = ρ h/6
    for (int power = 1; power <= 40; ++power) {
        CAPTURE(power);
        TriangleMesh mesh = tetrahedron_with_slivers(0.5);
        const double h = std::ldexp(1, -power);
        mesh.vertices[1].x() = h;
        mesh.vertices[4].x() = h / 2;
        const auto [M, X, I] = mesh_mass_properties(mesh, 6);
        REQUIRE_THAT(M, IsClose(h, Rounding(64)));
        REQUIRE_THAT(X, IsClose(Vector3d(h / 4, 0.25, 0.25), Rounding(256, 1)));
        REQUIRE_THAT(I(0, 0), IsClose(3 * h / 40, Rounding(256, h)));
    }
}

TEST_CASE("inertia: a light particle counts beside heavy ones", "[A2.1][inertia]")
{
    for (Random random : seeds(5))
        for (int power = 1; power <= 36; ++power) {
            CAPTURE(power);
            std::vector<Particle> particles = random.particles(3);
            particles[0].mass = 1;
            const double light = std::ldexp(1, -power);
            particles[1].mass = random.bits() % 2 == 0 ? 1 + light : light / 2; // also nearly equal
            particles[2].mass = light;
            if (random.bits() % 2 == 0) particles.pop_back();
            require_mass_properties(particle_mass_properties(particles), sum_of(particles), 2, 64);
        }
}

TEST_CASE("inertia: particles near the center count if they are heavy", "[A2.1][inertia]")
{
    // two heavy particles at ±d on x, and two of 1 kg at ±1 m on y, without any rounding error
    for (int power = 1; power <= 24; ++power) {
        CAPTURE(power);
        const double d = std::ldexp(1, -power), heavy = 1 / (d * d);
        const MassProperties all = particle_mass_properties(
            {{heavy, {d, 0, 0}}, {heavy, {-d, 0, 0}}, {1, {0, 1, 0}}, {1, {0, -1, 0}}});
        REQUIRE_THAT(all.inertia, IsClose(Matrix3d(Vector3d(2, 2, 4).asDiagonal()), Rounding(16)));
    }
}

namespace {

// A dense sample and a thin one, with the particles that they stand for if each has a volume of ⅛.
template <class Properties> void check_thin_beside_dense(const Properties& properties_of)
{
    for (Random random : seeds(5))
        for (int power = 1; power <= 36; ++power) {
            CAPTURE(power);
            std::vector<DensitySample> cells = samples(random);
            cells[1].density = std::ldexp(cells[0].density, -power);
            std::vector<Particle> particles;
            for (const auto& [position, density] : cells)
                particles.push_back({density / 8, position});
            require_mass_properties(properties_of(cells), sum_of(particles), 2, 64);
        }
}

} // namespace

TEST_CASE("inertia: thin matter counts beside dense one", "[A2.11][inertia]")
{
    check_thin_beside_dense(
        [](const std::vector<DensitySample>& cells) { return grid_mass_properties(cells, 0.5); });
}

TEST_CASE("inertia: thin samples count beside dense ones", "[A2.12][inertia]")
{
    check_thin_beside_dense([](const std::vector<DensitySample>& samples) {
        return sampled_mass_properties(samples, static_cast<double>(samples.size()) / 8);
    });
}

TEST_CASE("inertia: bodies that nearly coincide are still apart", "[A2.14][inertia]")
{
    // two point masses of nearly the same mass: I = M₁ M₂ / M (dᵀd δ - d dᵀ)
    for (Random random : seeds(5)) {
        const Vector3d X = 0.5 * random.vector(), direction = random.unit_vector();
        for (int power = 1; power <= 21; ++power) {
            CAPTURE(power);
            const double small = std::ldexp(1, -power), M2 = 1 + small;
            const MassProperties a = {1, X, Matrix3d::Zero()},
                                 b = {M2, X + small * direction, Matrix3d::Zero()};
            const Vector3d d = b.center_of_mass - X;
            const MassProperties both = combine(a, b);
            const Matrix3d I =
                M2 / (1 + M2) * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
            REQUIRE_THAT(both.center_of_mass,
                         IsClose(Vector3d(X + M2 / (1 + M2) * d), Rounding(16, 1)));
            REQUIRE_THAT(both.inertia, IsClose(I, Rounding(32, 2 * X.squaredNorm() + small)));
        }
    }
}

TEST_CASE("inertia: the distance between bodies counts however large they are", "[A2.14][inertia]")
{
    // two round bodies of 1 kg and 1 kg m²: I = 2 + d²/2 across d
    for (int power = 1; power <= 22; ++power) {
        CAPTURE(power);
        const double d = std::ldexp(1, -power);
        const MassProperties both =
            combine({1, {0, 0, 0}, Matrix3d::Identity()}, {1, {d, 0, 0}, Matrix3d::Identity()});
        const double across = 2 + d * d / 2;
        const Matrix3d I = Vector3d(2, across, across).asDiagonal();
        REQUIRE_THAT(both.inertia, IsClose(I, Rounding(8, 2)));
    }
}

TEST_CASE("inertia: of nearly equal masses the heavier one is nearer", "[A2.14][inertia]")
{
    for (int power = 1; power <= 40; ++power) {
        CAPTURE(power);
        const double M2 = 1 + std::ldexp(1, -power);
        const MassProperties both =
            combine({1, {-1, 0, 0}, Matrix3d::Identity()}, {M2, {1, 0, 0}, Matrix3d::Identity()});
        REQUIRE_THAT(both.center_of_mass.x(), IsClose((M2 - 1) / (M2 + 1), Rounding(8, 1)));
    }
}

namespace {

// A turn in two parts gives the same as both at once, also where both are nearly no turn, or nearly
// half a turn.
void check_two_turns(Matrix3d (*in_world)(const Matrix3d&, const Matrix3d&))
{
    for (Random random : seeds(5))
        for (int power = 1; power <= 44; ++power) {
            CAPTURE(power);
            const double half = random.bits() % 2 == 0 ? std::numbers::pi : 0;
            const Matrix3d R = Eigen::AngleAxisd(half + std::ldexp(1, -power), random.unit_vector())
                                   .toRotationMatrix();
            const Matrix3d S = random.rotation(), A = random.positive_definite();
            const Matrix3d both = R * S.transpose();
            REQUIRE_THAT(in_world(R, A),
                         IsClose(in_world(both, in_world(S, A)), Rounding(128, A.norm())));
        }
}

} // namespace

TEST_CASE("inertia: two turns in a row turn an inertia as one", "[A2.2][inertia]")
{
    check_two_turns(world_inertia);
}

TEST_CASE("inertia: two turns in a row turn an inverse inertia as one", "[A2.3][inertia]")
{
    check_two_turns(world_inverse_inertia);
}

TEST_CASE("inertia: a needle turns about its axis", "[A2.8][inertia]")
{
    // A solution may compute I = Tr(C) δ - C from the second moments C. Then Iyy is a difference of
    // terms as large as M l².
    for (int power = 1; power <= 24; ++power) {
        CAPTURE(power);
        const double r = std::ldexp(1, -power);
        const auto [M, X, I] = solid_cylinder(1, r, 1);
        REQUIRE_THAT(I(1, 1), IsClose(M * r * r / 2, Rounding(16, M)));
        REQUIRE_THAT(I(0, 0), IsClose(M / 12 * (3 * r * r + 1), Rounding(16)));
    }
}

TEST_CASE("inertia: what is nearly a ball is an ellipsoid", "[A2.9][inertia]")
{
    for (int power = 1; power <= 40; ++power) {
        CAPTURE(power);
        const double a = 1 + std::ldexp(1, -power);
        for (int axis = 0; axis < 3; ++axis) {
            Vector3d radii(1, 1, 1);
            radii[axis] = a;
            const auto [M, X, I] = solid_ellipsoid(1, radii);
            REQUIRE_THAT(M, IsClose(4 * std::numbers::pi / 3 * a, Rounding(16)));
            REQUIRE_THAT(I(axis, axis), IsClose(M / 5 * 2, Rounding(16)));
            const int other = (axis + 1) % 3;
            REQUIRE_THAT(I(other, other), IsClose(M / 5 * (1 + a * a), Rounding(16)));
        }
    }
}

} // namespace inertia_strata_test
