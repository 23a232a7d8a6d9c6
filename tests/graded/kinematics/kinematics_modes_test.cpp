// SPDX-License-Identifier: MIT
// A1.6, A1.7, A1.12 and A1.13: velocity modes, virtual work, generalized mass, and the change of
// the modes.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>

namespace kinematics_modes_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

// The matrix w*, column by column: w × eᵢ.
Matrix3d star(const Vector3d& w)
{
    Matrix3d w_x;
    for (int i = 0; i < 3; ++i)
        w_x.col(i) = w.cross(Vector3d::Unit(i));
    return w_x;
}

// Six particles of 0.5 kg with the moments 13, 10 and 5, as in the handout.
std::vector<Particle> six_particles()
{
    std::vector<Particle> particles;
    for (int i = 0; i < 3; ++i)
        for (const double side : {-1.0, 1.0})
            particles.push_back({0.5, side * (i + 1) * Vector3d::Unit(i)});
    return particles;
}

Vector6d stacked(const Vector3d& V, const Vector3d& w)
{
    Vector6d u;
    u << V, w;
    return u;
}

} // namespace

TEST_CASE("kinematics: velocity modes by hand", "[A1.6][kinematics]")
{
    Matrix36d expected;
    expected << 1, 0, 0, 0, 3, -2, //
        0, 1, 0, -3, 0, 1,         //
        0, 0, 1, 2, -1, 0;

    REQUIRE_THAT(velocity_modes(Vector3d::Zero(), Vector3d(1, 2, 3)), IsExactly(expected));
    INFO("about X = (1, 1, 1) and at x = (2, 3, 4) they are the same");
    REQUIRE_THAT(velocity_modes(Vector3d(1, 1, 1), Vector3d(2, 3, 4)), IsExactly(expected));
}

TEST_CASE("kinematics: turning does not move the center", "[A1.6][kinematics]")
{
    Matrix36d expected = Matrix36d::Zero();
    expected.leftCols<3>().setIdentity();
    const Vector3d X(1, 2, 3);

    REQUIRE_THAT(velocity_modes(X, X), IsExactly(expected));
}

TEST_CASE("kinematics: the modes give the velocity of every point", "[A1.6][kinematics]")
{
    for (Random random : seeds(100)) {
        const Vector3d V = random.vector(), w = random.vector();
        const Vector3d X = random.vector(), x = random.vector();

        const Vector3d v = velocity_modes(X, x) * stacked(V, w);

        REQUIRE_THAT(v, IsClose(Vector3d(w.cross(x - X) + V),
                                Rounding(16, V.norm() + w.norm() * (x.norm() + X.norm()))));
    }
}

TEST_CASE("kinematics: forces along the line between two points do no virtual work",
          "[A1.6][kinematics]")
{
    for (Random random : seeds(100)) {
        const Vector3d X = random.vector(), x1 = random.vector(), x2 = random.vector();
        const Vector3d f = x2 - x1; // acts on point 1, and -f acts on point 2

        const Vector6d work =
            velocity_modes(X, x1).transpose() * f - velocity_modes(X, x2).transpose() * f;

        const double arms = 1 + X.norm() + x1.norm() + x2.norm();
        REQUIRE_THAT(work, IsClose(Vector6d(Vector6d::Zero()), Rounding(16, arms * f.norm())));
    }
}

TEST_CASE("kinematics: generalized mass of one particle by hand", "[A1.7][kinematics]")
{
    Matrix6d expected = Matrix6d::Zero();
    expected.diagonal() << 2, 2, 2, 0, 2, 2;
    expected(1, 5) = expected(5, 1) = 2; // -m x*
    expected(2, 4) = expected(4, 2) = -2;

    const Matrix6d found = generalized_mass({{2, Vector3d(1, 0, 0)}}, Vector3d::Zero());

    REQUIRE_THAT(found, IsClose(expected, Rounding(32, 2)));
    INFO("the same, turned, scaled and moved");
    for (Random random : seeds(5)) {
        const Matrix3d R = random.rotation();
        const double length = random.uniform(0.5, 2), m = random.mass();
        const Vector3d X = random.vector(), x = X + length * R.col(0);
        Matrix6d T = Matrix6d::Zero();
        T.topLeftCorner<3, 3>() = R;
        T.bottomRightCorner<3, 3>() = length * R;

        const Matrix6d mass = generalized_mass({{m, x}}, X);

        const double reach = X.norm() + x.norm();
        REQUIRE_THAT(mass, IsClose(Matrix6d(m / 2 * T * expected * T.transpose()),
                                   Rounding(64, m * (1 + reach * reach))));
    }
}

TEST_CASE("kinematics: no particle has no generalized mass", "[A1.7][kinematics]")
{
    REQUIRE_THAT(generalized_mass({}, Vector3d(1, 2, 3)), IsExactly(Matrix6d(Matrix6d::Zero())));
}

TEST_CASE("kinematics: generalized mass gives the kinetic energy", "[A1.7][kinematics]")
{
    for (Random random : seeds(100)) {
        const std::vector<Particle> particles = random.particles(5);
        const Vector3d X = random.vector(), V = random.vector(), w = random.vector();
        const Vector6d u = stacked(V, w);
        double E = 0, scale = 0;
        for (const auto& [m, x] : particles) {
            E += m / 2 * (w.cross(x - X) + V).squaredNorm();
            const double fastest = V.norm() + w.norm() * (x.norm() + X.norm());
            scale += m * fastest * fastest;
        }

        const Matrix6d mass = generalized_mass(particles, X);

        REQUIRE_THAT(u.dot(mass * u) / 2, IsClose(E, Rounding(16, scale)));
        INFO("it is symmetric");
        REQUIRE_THAT(Matrix6d(mass.transpose()), IsClose(mass, Rounding(16, mass.norm())));
    }
}

TEST_CASE("kinematics: blocks of the generalized mass about any point", "[A1.7][kinematics]")
{
    for (Random random : seeds(100)) {
        const std::vector<Particle> particles = random.particles(5);
        const double M = sum_of(particles).mass;
        const Vector3d X = random.vector(), X_cm = sum_of(particles).center_of_mass;

        const Matrix6d any = generalized_mass(particles, X);
        const Matrix6d center = generalized_mass(particles, X_cm);

        REQUIRE_THAT(Matrix3d(any.topLeftCorner<3, 3>()),
                     IsClose(Matrix3d(M * Matrix3d::Identity()), Rounding(16, M)));
        INFO("the upper right block is M (X* - X_cm*)");
        REQUIRE_THAT(Matrix3d(any.topRightCorner<3, 3>()),
                     IsClose(Matrix3d(M * star(X - X_cm)), Rounding(16, 4 * M)));
        INFO("it vanishes about the center of mass");
        REQUIRE_THAT(Matrix3d(center.topRightCorner<3, 3>()),
                     IsClose(Matrix3d(Matrix3d::Zero()), Rounding(16, 4 * M)));
        REQUIRE_THAT(Matrix3d(center.bottomLeftCorner<3, 3>()),
                     IsClose(Matrix3d(Matrix3d::Zero()), Rounding(16, 4 * M)));
    }
}

TEST_CASE("kinematics: rates of the velocity modes by hand", "[A1.12][kinematics]")
{
    Matrix36d expected = Matrix36d::Zero();
    expected.rightCols<3>() << 0, 3, -2, -3, 0, 1, 2, -1, 0;

    REQUIRE_THAT(velocity_mode_rates(Vector3d::Zero(), Vector3d(1, 2, 3)), IsExactly(expected));
    INFO("with V = (1, 1, 1) and v = (2, 3, 4) they are the same");
    REQUIRE_THAT(velocity_mode_rates(Vector3d(1, 1, 1), Vector3d(2, 3, 4)), IsExactly(expected));
}

TEST_CASE("kinematics: modes do not change where a particle moves with the center",
          "[A1.12][kinematics]")
{
    const Vector3d V(1, 2, 3);
    REQUIRE_THAT(velocity_mode_rates(V, V), IsExactly(Matrix36d(Matrix36d::Zero())));
}

TEST_CASE("kinematics: the rates are the derivative of the velocity modes", "[A1.12][kinematics]")
{
    for (Random random : seeds(100)) {
        const Vector3d X = random.vector(), V = random.vector();
        const Vector3d x = random.vector(), v = random.vector();
        const double h = 0.25; // S is linear in both points, so the difference is exact

        const Vector3d X_next = X + h * V, x_next = x + h * v;
        Matrix36d change = Matrix36d::Zero();
        change.rightCols<3>() = (star(X_next - x_next) - star(X - x)) / h;

        REQUIRE_THAT(velocity_mode_rates(V, v), IsClose(change, Rounding(64, 8)));
    }
}

TEST_CASE("kinematics: the rates give the centripetal acceleration", "[A1.12][kinematics]")
{
    for (Random random : seeds(100)) {
        const Vector3d V = random.vector(), w = random.vector(), r = random.vector();
        const Vector3d v = w.cross(r) + V;

        const Vector3d acceleration = velocity_mode_rates(V, v) * stacked(V, w);

        const double scale = w.norm() * (V.norm() + w.norm() * r.norm());
        REQUIRE_THAT(acceleration, IsClose(Vector3d(w.cross(w.cross(r))), Rounding(16, scale)));
    }
}

TEST_CASE("kinematics: inertial wrench of six particles by hand", "[A1.13][kinematics]")
{
    const Vector3d w(1, 2, 3), V(5, -4, 2);
    // the particles are turned by R, `length` times as far apart, and have their center at X
    const auto check = [&](const Matrix3d& R, double length, const Vector3d& X) {
        std::vector<Particle> particles = six_particles();
        for (Particle& particle : particles)
            particle.position = length * R * particle.position + X;
        const Wrench expected{Vector3d::Zero(), length * length * R * Vector3d(-30, 24, -6)};
        const double reach = 3 * length + X.norm();
        const double scale = 3 * 14 * reach * reach; // total mass × |ω|² × largest distance²
        REQUIRE_THAT(inertial_wrench(particles, X, length * R * V, R * w),
                     IsClose(expected, Rounding(16, scale)));
    };
    check(Matrix3d::Identity(), 1, Vector3d(0, 0, 0));
    check(Matrix3d::Identity(), 1, Vector3d(1, 1, 1));
    for (Random random : seeds(5)) {
        const double length = random.uniform(0.5, 2);
        const Vector3d X = random.vector();
        check(random.rotation(), length, X);
    }
}

TEST_CASE("kinematics: about the center of mass the inertial torque is ω × I ω",
          "[A1.13][kinematics]")
{
    for (Random random : seeds(100)) {
        const std::vector<Particle> particles = random.particles(5);
        const MassProperties body = sum_of(particles);
        const Vector3d V = random.vector(), w = random.vector();

        const Wrench wrench = inertial_wrench(particles, body.center_of_mass, V, w);

        const Wrench expected{Vector3d::Zero(), w.cross(body.inertia * w)};
        const double scale = body.mass * w.norm() * (V.norm() + 4 * w.norm()) * 16;
        REQUIRE_THAT(wrench, IsClose(expected, Rounding(16, scale)));
    }
}

TEST_CASE("kinematics: inertial wrench about any point", "[A1.13][kinematics]")
{
    for (Random random : seeds(100)) {
        const std::vector<Particle> particles = random.particles(5);
        const Vector3d X = random.vector(), V = random.vector(), w = random.vector();
        Wrench expected;
        for (const auto& [m, x] : particles) {
            const Vector3d f = m * w.cross(w.cross(x - X));
            expected.force += f;
            expected.torque += (x - X).cross(f);
        }

        const double M = sum_of(particles).mass;
        const double scale = M * w.norm() * (V.norm() + 4 * w.norm()) * 16;
        REQUIRE_THAT(inertial_wrench(particles, X, V, w), IsClose(expected, Rounding(16, scale)));
    }
}

TEST_CASE("kinematics: no inertial wrench without rotation and without particles",
          "[A1.13][kinematics]")
{
    const Vector3d X(1, 2, 3), V(4, 5, 6), none = Vector3d::Zero();
    REQUIRE_THAT(inertial_wrench(six_particles(), X, V, none), IsClose(Wrench{}, Rounding(1, 0)));
    REQUIRE_THAT(inertial_wrench({}, X, V, Vector3d(1, 2, 3)), IsExactly(Wrench{}));
    INFO("about a principal axis there is no torque");
    REQUIRE_THAT(inertial_wrench(six_particles(), none, V, Vector3d(0, 2, 0)),
                 IsClose(Wrench{}, Rounding(16, 3 * 2 * 20)));
}

TEST_CASE("kinematics: the modes change also where both speeds are equal", "[A1.12][kinematics]")
{
    // V* - v* of velocities with the same components in other places or with other signs
    for (Random random : seeds(40)) {
        const Vector3d V = random.vector();
        Vector3d v = V;
        std::rotate(v.data(), v.data() + random_index(random, 3), v.data() + 3);
        for (int i = 0; i < 3; ++i)
            if (random_index(random, 2)) v[i] = -v[i];
        CAPTURE(V, v);
        const Vector3d d = V - v;
        Matrix36d expected = Matrix36d::Zero();
        expected.rightCols<3>() << 0, -d.z(), d.y(), d.z(), 0, -d.x(), -d.y(), d.x(), 0;
        REQUIRE_THAT(velocity_mode_rates(V, v), IsClose(expected, Rounding(8, 2)));
    }
}

} // namespace kinematics_modes_test
