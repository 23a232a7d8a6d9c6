// SPDX-License-Identifier: MIT
// A1.7 and A1.8: bodies far from the origin, and particles without mass far from the others. All
// differences of places are exact. But a solution may take moments about the origin first, so the
// distance from there counts among the magnitudes of the terms.
#include "formulas/kinematics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

namespace kinematics_far_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A place whose coordinates are multiples of 1/4 between -2 and 2.
Vector3d place(Random& random)
{
    Vector3d x;
    for (double& coordinate : x)
        coordinate = random_index(random, 17) / 4.0 - 2;
    return x;
}

Vector3d far_away(int power)
{
    return std::ldexp(1, power) * Vector3d(1, -0.5, 1.5);
}

} // namespace

TEST_CASE("kinematics: a particle without mass changes nothing however far it is",
          "[A1.7][kinematics]")
{
    for (Random random : seeds(10)) {
        std::vector<Particle> particles;
        for (int i = 0; i < 4; ++i)
            particles.push_back({random.mass(), place(random)});
        const Vector3d X = place(random);
        const Matrix6d expected = generalized_mass(particles, X);
        for (const int power : {0, 10, 20, 30, 40})
            for (const std::size_t at : {0, 2, 4}) {
                CAPTURE(power, at);
                std::vector<Particle> more = particles;
                more.insert(more.begin() + static_cast<std::ptrdiff_t>(at), {0, far_away(power)});
                REQUIRE_THAT(generalized_mass(more, X),
                             IsClose(expected, Rounding(32, expected.norm())));
            }
    }
}

TEST_CASE("kinematics: far from the origin the generalized mass is the same", "[A1.7][kinematics]")
{
    for (Random random : seeds(10)) {
        std::vector<Particle> near;
        for (int i = 0; i < 4; ++i)
            near.push_back({random.mass(), place(random)});
        const Vector3d X = place(random);
        const Matrix6d expected = generalized_mass(near, X);
        for (int power = 0; power <= 20; power += 5) {
            CAPTURE(power);
            const double distance = 4 + far_away(power).norm();
            std::vector<Particle> far = near;
            for (Particle& particle : far)
                particle.position += far_away(power);
            REQUIRE_THAT(generalized_mass(far, X + far_away(power)),
                         IsClose(expected, Rounding(32, expected(0, 0) * distance * distance)));
        }
    }
}

TEST_CASE("kinematics: far from the origin the wrench is the same", "[A1.8][kinematics]")
{
    for (Random random : seeds(10))
        for (const int balanced : {0, 2, 3, 5, 9}) { // so many forces add up to exactly 0
            std::vector<PointForce> near;
            for (int i = 0; i < 3 && balanced == 0; ++i)
                near.push_back({random.vector(), place(random)});
            if (balanced > 0) {
                const Vector3d f = random.vector().cast<float>().cast<double>();
                near = {{(balanced - 1) * f, place(random)}};
                for (int i = 1; i < balanced; ++i)
                    near.push_back({-f, place(random)});
            }
            const Vector3d X = place(random);
            const Wrench expected = net_wrench(near, X);
            for (int power = 0; power <= 30; power += 5) {
                CAPTURE(balanced, power);
                const double distance = 4 + far_away(power).norm();
                std::vector<PointForce> far = near;
                for (PointForce& force : far)
                    force.point += far_away(power);
                const Wrench found = net_wrench(far, X + far_away(power));
                REQUIRE_THAT(found.force, IsClose(expected.force, Rounding(16, 4)));
                REQUIRE_THAT(found.torque, IsClose(expected.torque, Rounding(16, 16 * distance)));
            }
        }
}

} // namespace kinematics_far_test
