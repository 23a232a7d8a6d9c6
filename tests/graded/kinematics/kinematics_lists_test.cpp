// SPDX-License-Identifier: MIT
// A1: sums over lists of any length, with entries anywhere in them that are 0, and velocities that
// have equal lengths and other directions.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>

namespace kinematics_lists_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// Lengths at which lists are cut into blocks, and their neighbours.
constexpr int lengths[] = {1,    2,    3,    4,    5,    7,     8,     9,    15,   16,   17,
                           31,   32,   33,   63,   64,   65,    127,   128,  129,  255,  256,
                           257,  511,  512,  513,  1023, 1024,  1025,  2047, 2048, 2049, 4095,
                           4096, 4097, 8191, 8192, 8193, 65535, 65536, 65537};

std::vector<PointForce> some_forces(int count, Random& random)
{
    std::vector<PointForce> forces(static_cast<std::size_t>(count));
    for (PointForce& one : forces)
        one = {random.vector(), random.vector()};
    return forces;
}

Wrench sum_of(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench sum;
    for (const PointForce& one : forces) {
        sum.force += one.force;
        sum.torque += (one.point - X).cross(one.force);
    }
    return sum;
}

} // namespace

TEST_CASE("kinematics: the generalized mass of any number of particles", "[A1.7][kinematics]")
{
    for (const int count : lengths) {
        CAPTURE(count);
        Random random(first_seed() + static_cast<unsigned>(count));
        const Vector3d X = random.vector();
        std::vector<Particle> particles(static_cast<std::size_t>(count));
        double mass = 0;
        Vector3d first = Vector3d::Zero();  // Σ m r
        Matrix3d second = Matrix3d::Zero(); // Σ m r rᵀ
        for (Particle& one : particles) {
            one = {random.mass(), random.vector()};
            const Vector3d r = one.position - X;
            mass += one.mass;
            first += one.mass * r;
            second += one.mass * r * r.transpose();
        }
        Matrix3d cross;
        cross << 0, -first.z(), first.y(), first.z(), 0, -first.x(), -first.y(), first.x(), 0;
        Matrix6d expected;
        expected << mass * Matrix3d::Identity(), -cross, cross,
            second.trace() * Matrix3d::Identity() - second;
        REQUIRE_THAT(generalized_mass(particles, X),
                     IsClose(expected, Rounding(16 + count, 3 * mass)));
    }
}

TEST_CASE("kinematics: the wrench of any number of forces", "[A1.8][kinematics]")
{
    for (const int count : lengths) {
        CAPTURE(count);
        Random random(first_seed() + static_cast<unsigned>(count));
        const std::vector<PointForce> forces = some_forces(count, random);
        const Vector3d X = random.vector();
        REQUIRE_THAT(net_wrench(forces, X),
                     IsClose(sum_of(forces, X), Rounding(16 + count, 6 * count)));
    }
}

TEST_CASE("kinematics: forces of zero change nothing wherever they stand", "[A1.8][kinematics]")
{
    for (Random random : seeds(60)) {
        const std::vector<PointForce> forces = some_forces(6, random);
        const Vector3d X = random.vector();
        const Wrench expected = sum_of(forces, X);
        std::vector<PointForce> more = forces;
        for (int extra = 1 + random_index(random, 3); extra > 0; --extra) {
            const PointForce zero{Vector3d::Zero(),
                                  random_index(random, 2) ? Vector3d::Zero() : random.vector()};
            more.insert(more.begin() + random_index(random, more.size() + 1), zero);
        }
        REQUIRE_THAT(net_wrench(more, X), IsClose(expected, Rounding(64, 36)));
    }
}

TEST_CASE("kinematics: particles of no mass change nothing wherever they stand",
          "[A1.7][kinematics]")
{
    for (Random random : seeds(60)) {
        std::vector<Particle> particles = random.particles(5);
        const Vector3d X = random.vector();
        const Matrix6d expected = generalized_mass(particles, X);
        const Particle none{0, random_index(random, 2) ? Vector3d::Zero() : random.vector()};
        particles.insert(particles.begin() + random_index(random, 6), none);
        REQUIRE_THAT(generalized_mass(particles, X), IsClose(expected, Rounding(64, 600)));
    }
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

} // namespace kinematics_lists_test
