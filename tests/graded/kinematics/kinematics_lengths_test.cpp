// SPDX-License-Identifier: MIT
// A1.7, A1.8 and A1.13: lists without an element, lists whose indices need more than 16 bits, and
// elements that count for nothing in front of others. All sums are exact in any order.
#include "formulas/kinematics.hpp"
#include "graded/laws/lengths.hpp"
#include "support/close.hpp"

namespace kinematics_lengths_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

const Particle weightless = {0, {2, -1, 4}};

} // namespace

TEST_CASE("kinematics: many particles have one generalized mass", "[A1.7][kinematics]")
{
    Beads<Particle> beads;
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        beads.grow(n);
        const Matrix6d found = generalized_mass(beads.list, {0, 0, 0});
        REQUIRE_THAT(found(0, 0), IsClose(beads.mass, Rounding(64)));
        REQUIRE_THAT(std::abs(found(1, 5)), IsClose(beads.first, Rounding(64)));
        REQUIRE_THAT(found(4, 4), IsClose(beads.second, Rounding(64)));
    }
}

TEST_CASE("kinematics: many forces add up", "[A1.8][kinematics]")
{
    std::vector<PointForce> forces;
    Wrench expected;
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        for (int i = static_cast<int>(forces.size()); i < n; ++i) {
            const double F = dyadic(i), x = i % 11;
            forces.push_back({{0, F, 0}, {x, 0, 0}}); // a push along y with the lever x - 2
            expected.force.y() += F;
            expected.torque.z() += (x - 2) * F;
        }
        REQUIRE_THAT(net_wrench(forces, {2, 0, 0}), IsClose(expected, Rounding(64, n)));
    }
}

TEST_CASE("kinematics: many particles that turn pull inwards", "[A1.13][kinematics]")
{
    Beads<Particle> beads;
    for (const int n : lengths(0, long_list)) {
        CAPTURE(n);
        beads.grow(n);
        const Wrench found =
            inertial_wrench(beads.list, {0, 0, 0}, {1, 2, 3}, {0, 0, 2}); // |ω|² is 4
        REQUIRE_THAT(found.force, IsClose(Vector3d(-4 * beads.first, 0, 0), Rounding(64, n)));
        REQUIRE_THAT(found.torque, IsClose(Vector3d(0, 0, 0), Rounding(64, n)));
    }
}

TEST_CASE("kinematics: particles without mass have no generalized mass", "[A1.7][kinematics]")
{
    const Vector3d X(1, 2, 3);
    const Matrix6d expected = generalized_mass(Beads<Particle>(20).list, X);
    for (const int n : idle_elements) {
        CAPTURE(n);
        const Matrix6d found = generalized_mass(among(n, weightless, Beads<Particle>(20).list), X);
        REQUIRE_THAT(found, IsClose(expected, Rounding(64, expected.norm())));
    }
}

TEST_CASE("kinematics: particles without mass need no wrench", "[A1.13][kinematics]")
{
    const Vector3d X(1, 2, 3), V(1, 2, 3), omega(1, -2, 0.5);
    const Wrench expected = inertial_wrench(Beads<Particle>(20).list, X, V, omega);
    for (const int n : idle_elements) {
        CAPTURE(n);
        const Wrench found =
            inertial_wrench(among(n, weightless, Beads<Particle>(20).list), X, V, omega);
        REQUIRE_THAT(found, IsClose(expected, Rounding(64, 2e5))); // Σ m |d|² |ω|²
    }
}

TEST_CASE("kinematics: any number of forces that balance may turn", "[A1.8][kinematics]")
{
    for (const int n : lengths(2, 140)) {
        CAPTURE(n);
        std::vector<PointForce> forces = {{{0, n - 1.0, 0}, {3, 0, 0}}};
        Wrench expected;
        expected.torque.z() = 3 * (n - 1);
        for (int i = 0; i + 1 < n; ++i) {
            forces.push_back({{0, -1, 0}, {1.0 * i, 0, 0}});
            expected.torque.z() -= i;
        }
        REQUIRE_THAT(net_wrench(forces, {5, 0, 2}), IsClose(expected, Rounding(64, n * n)));
    }
}

TEST_CASE("kinematics: a force of zero counts for nothing", "[A1.8][kinematics]")
{
    const std::vector<PointForce> few = {{{1, 2, 3}, {0, 1, 0}}, {{-2, 0, 1}, {1, 1, 4}}};
    for (const int n : idle_elements) {
        CAPTURE(n);
        const Wrench found = net_wrench(among(n, PointForce{{0, 0, 0}, {5, 1, 2}}, few), {1, 0, 0});
        REQUIRE_THAT(found, IsClose(net_wrench(few, {1, 0, 0}), Rounding(64, 16)));
    }
}

} // namespace kinematics_lengths_test
