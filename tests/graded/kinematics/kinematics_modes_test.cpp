// SPDX-License-Identifier: MIT
// A1.6 and A1.7: velocity modes, virtual work, generalized mass.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

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

    REQUIRE_THAT(found, IsClose(expected, Rounding(8, 2)));
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
