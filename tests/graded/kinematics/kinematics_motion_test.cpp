// SPDX-License-Identifier: MIT
// A1.8 and A1.9: forces, torques, equations of motion.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

std::vector<PointForce> random_forces(Random& random, int n)
{
    std::vector<PointForce> forces;
    for (int i = 0; i < n; ++i) {
        const Vector3d f = random.vector();
        forces.push_back({f, random.vector()});
    }
    return forces;
}

MatrixState random_state(Random& random)
{
    const Vector3d X = random.vector(), V = random.vector(), L = random.vector();
    return {X, random.rotation(), V, L};
}

} // namespace

TEST_CASE("kinematics: torque of one force by hand", "[A1.8][kinematics]")
{
    const Wrench wrench = net_wrench({{Vector3d(0, 10, 0), Vector3d(3, 0, 0)}}, Vector3d(1, 0, 0));

    // (2, 0, 0) × (0, 10, 0)
    REQUIRE_THAT(wrench, IsClose(Wrench{Vector3d(0, 10, 0), Vector3d(0, 0, 20)}, Rounding(8, 30)));
}

TEST_CASE("kinematics: a couple turns without pushing", "[A1.8][kinematics]")
{
    const std::vector<PointForce> couple = {{Vector3d(0, 1, 0), Vector3d(1, 0, 0)},
                                            {Vector3d(0, -1, 0), Vector3d(-1, 0, 0)}};
    const Wrench expected{Vector3d::Zero(), Vector3d(0, 0, 2)};

    REQUIRE_THAT(net_wrench(couple, Vector3d::Zero()), IsClose(expected, Rounding(8, 2)));
    INFO("about any point");
    REQUIRE_THAT(net_wrench(couple, Vector3d(4, 5, 6)), IsClose(expected, Rounding(8, 16)));
}

TEST_CASE("kinematics: no force is no wrench", "[A1.8][kinematics]")
{
    REQUIRE_THAT(net_wrench({}, Vector3d(1, 2, 3)), IsExactly(Wrench{}));
}

TEST_CASE("kinematics: gravity does not turn a body about its center of mass", "[A1.8][kinematics]")
{
    for (Random random : seeds(100)) {
        const Vector3d g(0, -9.81, 0);
        const std::vector<Particle> particles = random.particles(6);
        const double weight = sum_of(particles).mass * g.norm();
        std::vector<PointForce> forces;
        for (const auto& [m, x] : particles)
            forces.push_back({m * g, x});

        const Wrench wrench = net_wrench(forces, sum_of(particles).center_of_mass);

        const Wrench expected{sum_of(particles).mass * g, Vector3d::Zero()};
        REQUIRE_THAT(wrench, IsClose(expected, Rounding(16, 4 * weight)));
    }
}

TEST_CASE("kinematics: net force and torque have the power of the forces", "[A1.8][kinematics]")
{
    for (Random random : seeds(100)) {
        const std::vector<PointForce> forces = random_forces(random, 4);
        const Vector3d X = random.vector(), V = random.vector(), w = random.vector();
        double power = 0, scale = 0;
        for (const auto& [f, x] : forces) {
            power += f.dot(w.cross(x - X) + V);
            scale += f.norm() * (V.norm() + w.norm() * (x.norm() + X.norm()));
        }

        const Wrench wrench = net_wrench(forces, X);

        REQUIRE_THAT(wrench.force.dot(V) + wrench.torque.dot(w),
                     IsClose(power, Rounding(16, scale)));
    }
}

TEST_CASE("kinematics: rates of a body by hand", "[A1.9][kinematics]")
{
    MatrixState state;
    state.velocity = Vector3d(1, 2, 3);
    state.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1; // a quarter turn about z
    state.angular_momentum = Vector3d(0, 0, 8);
    const Matrix3d I_inverse = Vector3d(1, 0.5, 0.25).asDiagonal(); // ω = (0, 0, 2)
    const Wrench wrench{Vector3d(10, 0, 0), Vector3d(0, 7, 0)};
    MatrixStateRate expected{Vector3d(1, 2, 3), Matrix3d::Zero(), Vector3d(5, 0, 0),
                             Vector3d(0, 7, 0)};
    expected.rotation_rate << -2, 0, 0, 0, -2, 0, 0, 0, 0;

    REQUIRE_THAT(equations_of_motion(state, 0.5, I_inverse, wrench),
                 IsClose(expected, Rounding(8, 10)));
    INFO("the same, turned, moved, and `size` times as large");
    for (Random random : seeds(5)) {
        const Matrix3d R = random.rotation();
        const double size = random.uniform(0.5, 2), size2 = size * size;
        const MatrixState turned{random.vector(), R * state.rotation, size * R * state.velocity,
                                 size2 * R * state.angular_momentum};
        const MatrixStateRate rates{size * R * expected.position_rate, R * expected.rotation_rate,
                                    size * R * expected.velocity_rate,
                                    size2 * R * expected.angular_momentum_rate};

        REQUIRE_THAT(equations_of_motion(turned, 0.5, R * I_inverse * R.transpose() / size2,
                                         {size * R * wrench.force, size2 * R * wrench.torque}),
                     IsClose(rates, Rounding(32, 10 * (1 + size2))));
    }
}

TEST_CASE("kinematics: the rate of R is linear in R", "[A1.9][kinematics]")
{
    // The stages of a Runge-Kutta step ask for the rate of matrices that are no rotations.
    for (Random random : seeds(20)) {
        MatrixState state = random_state(random);
        const Matrix3d I_inverse = random.positive_definite();
        const Vector3d w = I_inverse * state.angular_momentum;
        Matrix3d expected;
        for (int i = 0; i < 3; ++i) {
            state.rotation.col(i) = std::pow(2.0, random.uniform(-2, 2)) * random.vector();
            expected.col(i) = w.cross(state.rotation.col(i));
        }
        const double scale =
            I_inverse.norm() * state.angular_momentum.norm() * state.rotation.norm();
        REQUIRE_THAT(equations_of_motion(state, 1, I_inverse, Wrench{}).rotation_rate,
                     IsClose(expected, Rounding(32, scale)));
    }
}

TEST_CASE("kinematics: a static body has no rates", "[A1.9][kinematics]")
{
    Random random(1);
    const MatrixState state = random_state(random);
    const Wrench wrench{random.vector(), random.vector()};

    REQUIRE_THAT(equations_of_motion(state, 0, Matrix3d::Zero(), wrench),
                 IsExactly(MatrixStateRate{}));
    INFO("whatever its inertia");
    REQUIRE_THAT(equations_of_motion(state, 0, Matrix3d::Identity(), wrench),
                 IsExactly(MatrixStateRate{}));
}

TEST_CASE("kinematics: angular momentum changes only by torque", "[A1.9][kinematics]")
{
    for (Random random : seeds(100)) {
        const MatrixState state = random_state(random);
        const Vector3d tau = random.vector();
        const Matrix3d I_inverse = random.positive_definite();

        const MatrixStateRate free = equations_of_motion(state, 1, I_inverse, Wrench{});
        const MatrixStateRate driven =
            equations_of_motion(state, 1, I_inverse, Wrench{Vector3d::Zero(), tau});

        REQUIRE_THAT(free.angular_momentum_rate, IsExactly(Vector3d(Vector3d::Zero())));
        REQUIRE_THAT(driven.angular_momentum_rate, IsClose(tau, Rounding(8, tau.norm())));
    }
}

TEST_CASE("kinematics: the rates move every point with the velocity of its body",
          "[A1.9][kinematics]")
{
    for (Random random : seeds(100)) {
        const MatrixState state = random_state(random);
        const Matrix3d I = random.inertia(); // in world space
        const Matrix3d I_inverse = I.inverse();
        const Vector3d w = I_inverse * state.angular_momentum, p = random.vector();
        const double scale =
            state.velocity.norm() + I_inverse.norm() * state.angular_momentum.norm() * p.norm();
        const double inverse_mass = 1 / random.mass();
        const Wrench wrench{random.vector(), random.vector()};

        const MatrixStateRate rate = equations_of_motion(state, inverse_mass, I_inverse, wrench);

        // ẋ = Ṙ p + Ẋ = ω × (x - X) + V
        REQUIRE_THAT(
            Vector3d(rate.rotation_rate * p + rate.position_rate),
            IsClose(Vector3d(w.cross(state.rotation * p) + state.velocity), Rounding(32, scale)));
        INFO("F = M V̇");
        REQUIRE_THAT(Vector3d(rate.velocity_rate / inverse_mass),
                     IsClose(wrench.force, Rounding(8, wrench.force.norm())));
    }
}
