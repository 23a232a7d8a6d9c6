// SPDX-License-Identifier: MIT
// A scene λ times as large takes √λ times as long (Galilei 1638, "Discorsi"; Froude 1868): lengths
// grow with λ, times and velocities with √λ, whatever the density.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: what is larger takes longer by the root", "[classics]")
{
    const auto scene = [](double l, double density) {
        const Material material{0.5, 0.4};
        std::vector<RigidBody> bodies = {fixed(Plane{}, material)};
        const std::vector<Shape> shapes = {Box{l * Vector3d(0.4, 0.3, 0.5)}, Sphere{l * 0.2},
                                           Capsule{l * 0.1, l * 0.4}};
        for (int i = 0; i < 3; ++i) {
            RigidBody body = body_of(shapes[i], l * Vector3d(0.7 * i, 0.5, 0.1 * i), material,
                                     turn({1, 2, 3.}, 0.3 * i));
            set_mass(body, density * body.mass, density * body.inertia);
            body.state.velocity = std::sqrt(l) * Vector3d(1 - i, -1, 0.3);
            spin(body, Vector3d(0.5, 1, -2) / std::sqrt(l));
            bodies.push_back(body);
        }
        return solved(bodies);
    };
    for (const double l : {0.01, 0.3, 40.})
        for (const double density : {1., 0.05}) {
            CAPTURE(l, density);
            World one = scene(1, 1), other = scene(l, density);
            run(one, 50, 0.01);
            run(other, 50, 0.01 * std::sqrt(l));
            for (int i = 1; i < 4; ++i)
                CHECK_THAT(Vector3d(other.bodies[i].state.position / l),
                           IsClose(one.bodies[i].state.position, Order(1e-5)));
        }
}
