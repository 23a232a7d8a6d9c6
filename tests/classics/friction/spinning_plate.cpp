// SPDX-License-Identifier: MIT
// A square plate on four feet that spins on a rough table stops after I ω/(μ M g r): each foot, at
// the distance r from the middle, bears a quarter of the weight and is braked across its arm.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a spinning plate is braked evenly", "[classics]")
{
    const double mu = 0.2, w = 8, a = 0.5;
    RigidBody plate;
    plate.name = "plate";
    plate.material = {0, mu};
    const double foot = 0.02;
    for (const double x : {-a, a})
        for (const double z : {-a, a})
            plate.parts.push_back(Part{Sphere{foot}, {x, 0, z}, {}});
    set_mass_from_parts(plate);
    plate.state.position = {0, foot, 0};
    spin(plate, {0, w, 0});
    const double I = plate.inertia(1, 1), r = a * std::sqrt(2.);
    const double slows = mu * plate.mass * g * r / I; // [rad/s²]
    for (const double h : {0.01, 0.002}) {
        CAPTURE(h);
        World world = solved({fixed(Plane{}, {0, mu}), plate});
        const double T = 0.6 * w / slows;
        run_until(world, T, h);
        CHECK_THAT(angular_velocity(world.bodies[1]).y(),
                   IsClose(w - slows * world.time, Order(0.1 * w * h)));
        check_at_most(world.bodies[1].state.position.cwiseProduct(Vector3d(1, 0, 1)).norm(), 1e-6,
                      "way of the middle [m]");
        run_until(world, 0.45 * w / slows, h);
        CHECK_THAT(angular_velocity(world.bodies[1]).norm(), IsClose(0.0, Order(1e-9)));
    }
}
