// SPDX-License-Identifier: MIT
// A rattleback turns freely one way; spun the other way it begins to rock, stops, and turns back
// (Walker 1896; Garcia and Hubbard 1988, "Spin reversal of the rattleback"). Its axes of inertia
// are turned against those of its curvature. Energy never grows.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a rattleback turns back from one way only", "[classics]")
{
    const double a = 0.2, b = 0.03, c = 0.02, M = 1; // half length, width and height [m], mass
    const Material rough{0, 100};
    std::vector<double> last;
    for (const double way : {1., -1.}) {
        RigidBody stone = body_of(Ellipsoid{{a, c, b}}, {0, c, 0}, rough);
        const Matrix3d Q = rotation_matrix(turn({0, 1, 0}, 0.09));
        const Vector3d moments(M / 5 * (b * b + c * c), M / 5 * (a * a + b * b),
                               M / 5 * (a * a + c * c));
        set_mass(stone, M, Q * moments.asDiagonal() * Q.transpose());
        spin(stone, {0.02, way * 5, 0.02});
        World world = solved({fixed(Plane{}, rough), stone});
        const auto energy = [&] {
            return totals(world).kinetic_energy + M * g * world.bodies[1].state.position.y();
        };
        const double first = energy();
        double least = 5;
        for (int i = 0; i < 8000; ++i) {
            step(world, 0.001);
            least = std::min(least, way * angular_velocity(world.bodies[1]).y());
        }
        check_at_most(energy(), first * (1 + 1e-3), "energy [J]");
        last.push_back(least);
    }
    CAPTURE(last);
    check_at_least(std::max(last[0], last[1]), 1, "least spin of the free way [rad/s]");
    check_at_most(std::min(last[0], last[1]), -0.3, "spin after the reversal [rad/s]");
}
