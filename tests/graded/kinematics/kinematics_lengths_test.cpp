// SPDX-License-Identifier: MIT
// A1.7, A1.8 and A1.13: lists without an element, and lists whose indices need more than 16 bits.
// All numbers are small integers, so that the sums are exact in any order.
#include "formulas/kinematics.hpp"
#include "graded/laws/lengths.hpp"
#include "support/close.hpp"

namespace kinematics_lengths_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// The beads of lengths.hpp and their sums.
struct Beads {
    std::vector<Particle> particles;
    double mass = 0, first = 0, second = 0; // Σ m, Σ m x, Σ m x²

    explicit Beads(int n) : particles(beads(n))
    {
        for (const auto& [m, x] : particles) {
            mass += m;
            first += m * x.x();
            second += m * x.squaredNorm();
        }
    }
};

} // namespace

TEST_CASE("kinematics: many particles have one generalized mass", "[A1.7][kinematics]")
{
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        const Beads beads(n);
        const Matrix6d found = generalized_mass(beads.particles, {0, 0, 0});
        REQUIRE_THAT(found(0, 0), IsClose(beads.mass, Rounding(64)));
        REQUIRE_THAT(std::abs(found(1, 5)), IsClose(beads.first, Rounding(64)));
        REQUIRE_THAT(found(4, 4), IsClose(beads.second, Rounding(64)));
    }
}

TEST_CASE("kinematics: many forces add up", "[A1.8][kinematics]")
{
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        std::vector<PointForce> forces(n);
        Wrench expected;
        for (int i = 0; i < n; ++i) {
            const double F = 1 + i % 7, x = i % 11;
            forces[i] = {{0, F, 0}, {x, 0, 0}}; // a push along y with the lever x - 2
            expected.force.y() += F;
            expected.torque.z() += (x - 2) * F;
        }
        REQUIRE_THAT(net_wrench(forces, {2, 0, 0}), IsClose(expected, Rounding(64, n)));
    }
}

TEST_CASE("kinematics: many particles that turn pull inwards", "[A1.13][kinematics]")
{
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        const Beads beads(n);
        const Wrench found =
            inertial_wrench(beads.particles, {0, 0, 0}, {1, 2, 3}, {0, 0, 2}); // |ω|² is 4
        REQUIRE_THAT(found.force, IsClose(Vector3d(-4 * beads.first, 0, 0), Rounding(64, n)));
        REQUIRE_THAT(found.torque, IsClose(Vector3d(0, 0, 0), Rounding(64, n)));
    }
}

} // namespace kinematics_lengths_test
