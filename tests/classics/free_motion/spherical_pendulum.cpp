// SPDX-License-Identifier: MIT
// A spherical pendulum goes round level with ω² = F d/(I cos θ) (Lagrange 1788, "Mécanique
// analytique"), and pushed a little off it nods with ω √(1 + 3 cos² θ). The body here is a ball
// without spin about its own axis, which a steady force pulls at the distance d from its center.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a spherical pendulum goes round level and nods", "[classics]")
{
    const double F = 40, d = 0.3, I = 5;
    AppliedForce pull;
    pull.force = {0, -F, 0};
    pull.point = {0, -d, 0};
    for (const double degrees : {20., 60., 85.})
        for (const double push : {0., 1e-5}) {
            const double a = degrees * pi / 180, w = std::sqrt(F * d / (I * std::cos(a)));
            const double nods = w * std::sqrt(1 + 3 * std::pow(std::cos(a), 2));
            const double T = push == 0 ? 3 * pi / w : 5 * pi / nods; // the nod is at its middle
            const Vector3d start(std::sin(a), -std::cos(a), 0);      // towards the pulled point
            std::vector<double> errors;
            for (const int steps : {100, 200, 400}) {
                RigidBody ball = free_box();
                set_mass(ball, 12, I * Matrix3d::Identity());
                ball.state.orientation = turn({0, 0, 1}, a);
                const Vector3d y(0, 1, 0), up(std::cos(a), std::sin(a), 0);
                spin(ball, w * (y - start.y() * start) + push * start.cross(up));
                World world = solved({ball}, {0, 0, 0});
                world.forces = {pull};
                run(world, steps, T / steps);
                const Matrix3d R = rotation_matrix(world.bodies[0].state.orientation);
                const double height = -R(1, 1);
                if (push == 0)
                    errors.push_back((R.col(1) + rotation_matrix(turn(y, w * T)) * start).norm());
                else
                    errors.push_back(std::abs(height - start.y()) / push);
            }
            CAPTURE(degrees, push, errors);
            if (push == 0)
                check_order(errors, 4);
            else
                check_at_most(errors.back(), 1e-3, "height in amplitudes of the nod");
        }
}
