// SPDX-License-Identifier: MIT
// A log lies on ice, spins about its axis with w and turns about the vertical with Ω. The moment
// C w Ω that turns its angular momentum comes from the ice, which presses more on one end. As long
// as this moment is smaller than M g L/2, both ends stay on the ice, and as nothing acts along it,
// the log keeps w and Ω for ever (the gyroscopic moment: Kleppner and Kolenkow 2014, "An
// introduction to mechanics", 8.3). In a step the log may spin by more than a turn.
#include "classics/problems.hpp"

namespace spinning_log_on_ice {

using namespace rigor;
using namespace rigor::testing;

namespace {

struct Log {
    const char* name;
    Shape shape;
    double length; // between the outermost points that it lies on, in radii
};

std::vector<Log> logs(double r)
{
    return {{"cylinder", Cylinder{r, 12 * r}, 12},
            {"short cylinder", Cylinder{r, 2 * r}, 2},
            {"capsule", Capsule{r, 6 * r}, 6}};
}

} // namespace

TEST_CASE("classics: a log on ice spins and turns for ever", "[classics]")
{
    Sweep sweep;
    for (const double r : {1e-3, 0.05, 100.})
        for (const bool is_box : {false, true})
            for (const Log& log : logs(r))
                for (const double turn_of_step : {0.2, 0.8, 0.95, 1.1, 1.5, 1.6, 2., 3.})
                    for (const double share : {0.1, 0.5}) { // share of the moment M g L/2
                        if (!sweep.takes_next()) continue;
                        CAPTURE(r, is_box, log.name, turn_of_step, share);
                        const double h = 0.14 * std::sqrt(r / g);
                        RigidBody body =
                            body_of(log.shape, {0, r, 0}, {0, 0}, turn({1, 0, 0}, pi / 2));
                        const double w = turn_of_step / h, C = body.inertia(1, 1);
                        const double omega = share * body.mass * g * log.length * r / 2 / (C * w);
                        spin(body, {0, omega, w});
                        const Shape ground =
                            is_box ? Shape(Box{{100 * r, 2 * r, 100 * r}}) : Plane{};
                        World world =
                            solved({fixed(ground, {0, 0}, {0, is_box ? -r : 0, 0}), body});
                        run(world, 40, h);
                        const RigidBody& end = world.bodies[1];
                        const Vector3d axis = pose_of(end.state).R.col(1);
                        CHECK_THAT(angular_velocity(end).dot(axis) / w, IsClose(1.0, Order(1e-3)));
                        CHECK_THAT(axis.y(), IsClose(0.0, Order(0.02)));
                        CHECK_THAT(end.state.position.y() / r, IsClose(1.0, Order(0.01)));
                    }
}

} // namespace spinning_log_on_ice
