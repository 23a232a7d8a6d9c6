// SPDX-License-Identifier: MIT
// A1.7, A1.8 and A1.13: sums over any number of particles or forces. Each must have the same part
// in the sum as if it were alone.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <numeric>

namespace kinematics_sums_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// Every length up to 300, and those around the powers of two: where lists are cut into blocks, a
// last block may be lost, or one that is full. Each list is from a seed of its own.
std::vector<std::vector<Particle>> all_sizes()
{
    std::vector<int> lengths(300);
    std::iota(lengths.begin(), lengths.end(), 1);
    for (int power = 512; power <= 8192; power *= 2)
        lengths.insert(lengths.end(), {power - 1, power, power + 1});
    std::vector<std::vector<Particle>> result;
    for (const int n : lengths) {
        Random random(first_seed() + static_cast<unsigned>(n));
        result.push_back(random.particles(n));
    }
    return result;
}

// Sums of n terms have a rounding error of at most n eps times the sum of their magnitudes, here on
// both sides.
Tolerance rounding_of(std::size_t n, double magnitudes)
{
    return Rounding(2 * static_cast<double>(n) + 16, magnitudes);
}

} // namespace

TEST_CASE("kinematics: the generalized mass is a sum over any number of particles",
          "[A1.7][kinematics]")
{
    for (const std::vector<Particle>& particles : all_sizes()) {
        CAPTURE(particles.size());
        const Vector3d X(0.1, -0.2, 0.3);
        Matrix6d sum = Matrix6d::Zero();
        double magnitudes = 0;
        for (const Particle& particle : particles) {
            sum += generalized_mass({particle}, X);
            magnitudes += 8 * particle.mass; // distances are less than 2 m
        }
        REQUIRE_THAT(generalized_mass(particles, X),
                     IsClose(sum, rounding_of(particles.size(), magnitudes)));
    }
}

TEST_CASE("kinematics: a wrench is a sum over any number of forces", "[A1.8][kinematics]")
{
    for (const std::vector<Particle>& particles : all_sizes()) {
        CAPTURE(particles.size());
        const Vector3d X(0.1, -0.2, 0.3);
        std::vector<PointForce> forces;
        Wrench sum = {Vector3d::Zero(), Vector3d::Zero()};
        double magnitudes = 0;
        for (const Particle& particle : particles) {
            const Vector3d f = particle.mass * Vector3d(1, particle.position.z(), -2);
            forces.push_back({f, particle.position});
            const Wrench one = net_wrench({forces.back()}, X);
            sum.force += one.force;
            sum.torque += one.torque;
            magnitudes += 4 * f.norm();
        }
        REQUIRE_THAT(net_wrench(forces, X), IsClose(sum, rounding_of(forces.size(), magnitudes)));
    }
}

TEST_CASE("kinematics: inertial forces are a sum over any number of particles",
          "[A1.13][kinematics]")
{
    for (const std::vector<Particle>& particles : all_sizes()) {
        CAPTURE(particles.size());
        const Vector3d X(0.1, -0.2, 0.3), V(1, 2, -1), omega(0.5, -1, 2);
        Wrench sum = {Vector3d::Zero(), Vector3d::Zero()};
        double magnitudes = 0;
        for (const Particle& particle : particles) {
            const Wrench one = inertial_wrench({particle}, X, V, omega);
            sum.force += one.force;
            sum.torque += one.torque;
            magnitudes += 100 * particle.mass; // distances × speeds × |ω|
        }
        REQUIRE_THAT(inertial_wrench(particles, X, V, omega),
                     IsClose(sum, rounding_of(particles.size(), magnitudes)));
    }
}

namespace {

// Puts an entry anywhere into a list.
template <class T> void put_anywhere(std::vector<T>& list, const T& entry, Random& random)
{
    list.insert(list.begin() + random_index(random, list.size() + 1), entry);
}

} // namespace

TEST_CASE("kinematics: forces of zero change nothing wherever they stand", "[A1.8][kinematics]")
{
    for (Random random : seeds(60)) {
        std::vector<PointForce> forces(6);
        for (PointForce& one : forces)
            one = {random.vector(), random.vector()};
        const Vector3d X = random.vector();
        const Wrench expected = net_wrench(forces, X);
        for (const Vector3d& point : {Vector3d(0, 0, 0), X, random.vector()})
            put_anywhere(forces, {Vector3d::Zero(), point}, random);
        REQUIRE_THAT(net_wrench(forces, X), IsClose(expected, rounding_of(9, 36)));
    }
}

TEST_CASE("kinematics: particles of no mass change nothing wherever they stand",
          "[A1.7][kinematics]")
{
    for (Random random : seeds(60)) {
        std::vector<Particle> particles = random.particles(5);
        const Vector3d X = random.vector();
        const Matrix6d expected = generalized_mass(particles, X);
        for (const Vector3d& position : {Vector3d(0, 0, 0), X, random.vector()})
            put_anywhere(particles, {0, position}, random);
        REQUIRE_THAT(generalized_mass(particles, X), IsClose(expected, rounding_of(8, 600)));
    }
}

} // namespace kinematics_sums_test
