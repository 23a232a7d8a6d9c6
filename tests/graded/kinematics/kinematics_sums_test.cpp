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

// Every length up to 300, and those around the powers of two: a formula that takes lists block by
// block may lose the last block, or one that is full.
std::vector<std::size_t> lengths()
{
    std::vector<std::size_t> result(300);
    std::iota(result.begin(), result.end(), 1);
    for (std::size_t power = 512; power <= 8192; power *= 2)
        result.insert(result.end(), {power - 1, power, power + 1});
    return result;
}

// The elements that take turns in the lists. There are fewer of them than the longest list has, so
// that the formula is not called for too many single elements.
std::vector<Particle> some_particles()
{
    Random random(first_seed());
    return random.particles(331);
}

// A sum of n terms has a rounding error of at most n eps times the sum of their magnitudes. Both of
// the compared results are such sums.
Tolerance rounding_of(std::size_t n, double magnitudes)
{
    return Rounding(2 * static_cast<double>(n) + 16, magnitudes);
}

Matrix6d plus(const Matrix6d& a, const Matrix6d& b)
{
    return a + b;
}

Wrench plus(const Wrench& a, const Wrench& b)
{
    return {a.force + b.force, a.torque + b.torque};
}

// Checks for lists in which these elements take turns: the result for a list is the sum of the
// results for its elements alone.
// @param formula    takes a list
// @param magnitude  a bound on each component of the result for one element
template <class Sum, class T, class Formula, class Magnitude>
void require_sums(Sum sum, const std::vector<T>& elements, const Formula& formula,
                  const Magnitude& magnitude)
{
    std::vector<Sum> alone;
    for (const T& element : elements)
        alone.push_back(formula(std::vector<T>{element}));
    double magnitudes = 0;
    std::vector<T> list;
    for (const std::size_t length : lengths()) {
        CAPTURE(length);
        while (list.size() < length) {
            const std::size_t next = list.size() % elements.size();
            sum = plus(sum, alone[next]);
            magnitudes += magnitude(elements[next]);
            list.push_back(elements[next]);
        }
        REQUIRE_THAT(formula(list), IsClose(sum, rounding_of(length, magnitudes)));
    }
}

const Wrench no_wrench = {Vector3d::Zero(), Vector3d::Zero()};
const Vector3d center(0.1, -0.2, 0.3);

} // namespace

TEST_CASE("kinematics: the generalized mass is a sum over any number of particles",
          "[A1.7][kinematics]")
{
    require_sums(
        Matrix6d::Zero().eval(), some_particles(),
        [](const std::vector<Particle>& particles) { return generalized_mass(particles, center); },
        [](const Particle& particle) { return 8 * particle.mass; }); // distances are less than 2 m
}

TEST_CASE("kinematics: a wrench is a sum over any number of forces", "[A1.8][kinematics]")
{
    std::vector<PointForce> forces;
    for (const Particle& particle : some_particles())
        forces.push_back(
            {particle.mass * Vector3d(1, particle.position.z(), -2), particle.position});
    require_sums(
        no_wrench, forces,
        [](const std::vector<PointForce>& some) { return net_wrench(some, center); },
        [](const PointForce& force) { return 4 * force.force.norm(); }); // levers of less than 2 m
}

TEST_CASE("kinematics: inertial forces are a sum over any number of particles",
          "[A1.13][kinematics]")
{
    const Vector3d V(1, 2, -1), omega(0.5, -1, 2);
    require_sums(
        no_wrench, some_particles(),
        [&](const std::vector<Particle>& particles) {
            return inertial_wrench(particles, center, V, omega);
        },
        [](const Particle& particle) {
            return 100 * particle.mass; // distances × speeds × |ω|
        });
}

namespace {

// Puts an entry at a random place into a list.
template <class T> void put_anywhere(std::vector<T>& list, const T& entry, Random& random)
{
    list.insert(list.begin() + random_index(random, list.size() + 1), entry);
}

} // namespace

TEST_CASE("kinematics: opposite forces with a short lever arm make a small torque",
          "[A1.8][kinematics]")
{
    for (int power = 1; power <= 40; ++power) {
        const double arm = std::ldexp(1, -power);
        CAPTURE(arm);
        for (const Vector3d& X : {Vector3d(0, 0, 0), Vector3d(1, 0, 0)}) {
            const Wrench found = net_wrench({{{1, 0, 0}, {0, 0, 0}}, {{-1, 0, 0}, {1, arm, 0}}}, X);
            REQUIRE_THAT(found.force, IsExactly(Vector3d(0, 0, 0)));
            REQUIRE_THAT(found.torque, IsExactly(Vector3d(0, 0, arm)));
        }
    }
}

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
