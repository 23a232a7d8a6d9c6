// SPDX-License-Identifier: MIT
// Advances a world with a single rigid body by one free flight. No stage for contacts runs, because
// there is no other rigid body that it could touch.
#include "rigid/step/single_body.hpp"

#include "rigid/bodies/mass.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/motion/free_flight.hpp"

namespace rigor {

bool is_single_body(const World& world)
{
    return world.bodies.size() == 1 && !world.bodies[0].is_static && !world.bodies[0].is_still() &&
           world.springs.empty() && world.forces.empty() && !world.bodies[0].drag.acts();
}

std::vector<ContactRecord> step_single_body(World& world, double time_step)
{
    RigidBody& body = world.bodies[0];
    const RigidState flown = fly(world.settings, body, body.state, time_step, world.counters);
    require_finite(body, flown, world.time + time_step);
    ++world.counters.free_flights;
    body.state = flown;
    if (body.only_axis) body.state.angular_momentum = own_angular_momentum(body, body.state);
    world.memory.warm_contacts.clear();
    world.time += time_step;
    ++world.counters.steps;
    return {};
}

} // namespace rigor
