// SPDX-License-Identifier: MIT
// A2.1 to A2.3 and A2.14: inertia tensors of particles, in world space, and of unions of bodies.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// The rotation that takes x to y, y to z and z to x: a third of a turn about (1, 1, 1).
Matrix3d third_of_a_turn()
{
    Matrix3d R;
    R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    return R;
}

Matrix3d diagonal(double x, double y, double z)
{
    return Vector3d(x, y, z).asDiagonal();
}

MassProperties moved(const MassProperties& body, const Matrix3d& R, const Vector3d& X)
{
    return {body.mass, R * body.center_of_mass + X, R * body.inertia * R.transpose()};
}

std::vector<Particle> moved(std::vector<Particle> particles, const Matrix3d& R, const Vector3d& X)
{
    for (Particle& particle : particles)
        particle.position = R * particle.position + X;
    return particles;
}

// Half of a ball about the origin, of mass M and radius R, on one side of the plane y = 0.
MassProperties hemisphere(double M, double R, double side)
{
    const double across = 83.0 / 320 * M * R * R; // about its own center, 3/8 R above the disc
    const double axial = 2.0 / 5 * M * R * R;
    return {M, Vector3d(0, side * 3 / 8 * R, 0), diagonal(across, axial, across)};
}

} // namespace

TEST_CASE("inertia: two points on a line", "[A2.1][inertia]")
{
    const double m = 3, L = 2;
    const MassProperties expected{2 * m, Vector3d::Zero(),
                                  diagonal(m * L * L / 2, m * L * L / 2, 0)};

    const MassProperties found =
        particle_mass_properties({{m, Vector3d(0, 0, L / 2)}, {m, Vector3d(0, 0, -L / 2)}});

    require_mass_properties(found, expected, L, 8);
}

TEST_CASE("inertia: two points of different mass", "[A2.1][inertia]")
{
    const MassProperties expected{4, Vector3d(3, 1, 0), diagonal(0, 12, 12)};

    const MassProperties found =
        particle_mass_properties({{1, Vector3d(0, 1, 0)}, {3, Vector3d(4, 1, 0)}});

    require_mass_properties(found, expected, 4, 8);
}

TEST_CASE("inertia: products of inertia are negative along a diagonal", "[A2.1][inertia]")
{
    MassProperties expected;
    expected.mass = 2;
    expected.inertia << 2, -2, 0, -2, 2, 0, 0, 0, 4;

    const MassProperties found =
        particle_mass_properties({{1, Vector3d(1, 1, 0)}, {1, Vector3d(-1, -1, 0)}});

    require_mass_properties(found, expected, 2, 8);
}

TEST_CASE("inertia: one point has none about itself", "[A2.1][inertia]")
{
    const Vector3d X(1, 2, 3);

    const MassProperties found = particle_mass_properties({{0.3, X}});

    require_mass_properties(found, {0.3, X, Matrix3d::Zero()}, X.norm(), 16);
}

TEST_CASE("inertia: without mass all is zero", "[A2.1][inertia]")
{
    REQUIRE_THAT(particle_mass_properties({}), IsExactly(MassProperties{}));
    INFO("particles of mass 0");
    REQUIRE_THAT(particle_mass_properties({{0, Vector3d(1, 2, 3)}, {0, Vector3d(4, 5, 6)}}),
                 IsExactly(MassProperties{}));
}

TEST_CASE("inertia: particles that move and turn take their inertia along", "[A2.1][inertia]")
{
    for (Random random : seeds(100)) {
        const std::vector<Particle> particles = random.particles(5);
        const Matrix3d R = random.rotation();
        const Vector3d X = random.vector();

        const auto [M, c, I] = particle_mass_properties(particles);
        const MassProperties after = particle_mass_properties(moved(particles, R, X));

        require_mass_properties(after, {M, R * c + X, R * I * R.transpose()}, 4, 32);
    }
}

TEST_CASE("inertia: I ω is the angular momentum of the particles", "[A2.1][inertia]")
{
    for (Random random : seeds(100)) {
        const std::vector<Particle> particles = random.particles(5);
        const Vector3d w = random.vector();

        const auto [M, X, I] = particle_mass_properties(particles);

        Vector3d L = Vector3d::Zero();
        for (const auto& [m, p] : particles)
            L += m * (p - X).cross(w.cross(p - X));
        REQUIRE_THAT(Vector3d(I * w), IsClose(L, Rounding(32, 4 * M * w.norm())));
    }
}

TEST_CASE("inertia: a third of a turn passes the moments on", "[A2.2][inertia]")
{
    // the moment about x becomes the one about y
    REQUIRE_THAT(world_inertia(third_of_a_turn(), diagonal(1, 2, 3)),
                 IsClose(diagonal(3, 1, 2), Rounding(8, 4)));
    INFO("not turned");
    REQUIRE_THAT(world_inertia(Matrix3d::Identity(), diagonal(1, 2, 3)),
                 IsClose(diagonal(1, 2, 3), Rounding(8, 4)));
}

TEST_CASE("inertia: in world space it is that of the turned particles", "[A2.2][inertia]")
{
    for (Random random : seeds(100)) {
        const Matrix3d R = random.rotation();
        Matrix3d I_body = Matrix3d::Zero(), I = Matrix3d::Zero();
        double scale = 0;
        for (const auto& [m, p] : random.particles(5)) {
            const Vector3d x = R * p;
            I_body += m * (p.squaredNorm() * Matrix3d::Identity() - p * p.transpose());
            I += m * (x.squaredNorm() * Matrix3d::Identity() - x * x.transpose());
            scale += 2 * m * p.squaredNorm();
        }

        REQUIRE_THAT(world_inertia(R, I_body), IsClose(I, Rounding(64, scale)));
    }
}

TEST_CASE("inertia: a third of a turn passes the inverse moments on", "[A2.3][inertia]")
{
    REQUIRE_THAT(world_inverse_inertia(third_of_a_turn(), diagonal(1, 0.5, 0.25)),
                 IsClose(diagonal(0.25, 1, 0.5), Rounding(8, 2)));
}

TEST_CASE("inertia: the inverse of a rod stays finite in world space", "[A2.3][inertia]")
{
    REQUIRE_THAT(world_inverse_inertia(third_of_a_turn(), diagonal(0.2, 0, 0.2)),
                 IsClose(diagonal(0.2, 0.2, 0), Rounding(8, 0.3)));
    INFO("a static body");
    REQUIRE_THAT(world_inverse_inertia(third_of_a_turn(), Matrix3d::Zero()),
                 IsExactly(Matrix3d(Matrix3d::Zero())));
}

TEST_CASE("inertia: the inverse in world space inverts", "[A2.3][inertia]")
{
    for (Random random : seeds(100)) {
        const Matrix3d R = random.rotation(), I_body = random.inertia();
        const Matrix3d I_body_inverse = I_body.inverse();
        const Matrix3d I = R * I_body * R.transpose();

        const Matrix3d one = world_inverse_inertia(R, I_body_inverse) * I;

        REQUIRE_THAT(one, IsClose(Matrix3d(Matrix3d::Identity()),
                                  Rounding(128, I_body.norm() * I_body_inverse.norm())));
    }
}

TEST_CASE("inertia: two hemispheres make a sphere", "[A2.14][inertia]")
{
    const auto sphere = [](double M, double R, const Vector3d& X) {
        return MassProperties{M, X, 2.0 / 5 * M * R * R * Matrix3d::Identity()};
    };
    const MassProperties found = combine(hemisphere(3, 2, 1), hemisphere(3, 2, -1));

    require_mass_properties(found, sphere(6, 2, Vector3d::Zero()), 2, 8);
    INFO("the same, turned, scaled and moved");
    for (Random random : seeds(5)) {
        const double M = random.mass(), radius = random.uniform(0.5, 2);
        const Matrix3d R = random.rotation();
        const Vector3d X = random.vector();
        const MassProperties up = moved(hemisphere(M / 2, radius, 1), R, X);
        const MassProperties down = moved(hemisphere(M / 2, radius, -1), R, X);

        require_mass_properties(combine(up, down), sphere(M, radius, X), radius + X.norm(), 32);
    }
}

TEST_CASE("inertia: eight boxes make a box", "[A2.14][inertia]")
{
    // a box of 1 m × 2 m × 3 m and 12 kg, in octants of 1.5 kg
    const Matrix3d octant = diagonal(13, 10, 5) / 32;
    const Vector3d center(5, -3, 2);
    MassProperties sum;
    for (int i = 0; i < 8; ++i) {
        const Vector3d side(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        sum = combine(sum, {1.5, center + side.cwiseProduct(Vector3d(0.25, 0.5, 0.75)), octant});
    }

    require_mass_properties(sum, {12, center, diagonal(13, 10, 5)}, center.norm() + 2, 8);
}

TEST_CASE("inertia: two points make a dumbbell", "[A2.14][inertia]")
{
    const MassProperties a{1, Vector3d(0, 0, 0), Matrix3d::Zero()};
    const MassProperties b{3, Vector3d(4, 0, 0), Matrix3d::Zero()};

    require_mass_properties(combine(a, b), {4, Vector3d(3, 0, 0), diagonal(0, 12, 12)}, 4, 8);
}

TEST_CASE("inertia: a body without mass adds nothing", "[A2.14][inertia]")
{
    Random random(3);
    const MassProperties body{2, random.vector(), random.inertia()};
    const MassProperties nothing{0, Vector3d(7, 8, 9), Matrix3d::Zero()};

    require_mass_properties(combine(body, nothing), body, 12, 8);
    require_mass_properties(combine(nothing, body), body, 12, 8);
    INFO("nothing and nothing");
    REQUIRE_THAT(combine(nothing, nothing), IsExactly(MassProperties{}));
}

TEST_CASE("inertia: the union of two swarms has the mass properties of all particles",
          "[A2.14][inertia]")
{
    for (Random random : seeds(100)) {
        const std::vector<Particle> one = random.particles(4), two = random.particles(3);
        std::vector<Particle> all = one;
        all.insert(all.end(), two.begin(), two.end());

        const MassProperties found = combine(sum_of(one), sum_of(two));

        require_mass_properties(found, sum_of(all), 2, 32);
    }
}
