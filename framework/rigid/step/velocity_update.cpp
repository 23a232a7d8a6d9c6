// SPDX-License-Identifier: MIT
#include "rigid/step/velocity_update.hpp"

#include "rigid/contact/make_problem.hpp"

namespace rigor {

void apply_forces(const World& world, const Island& island, const std::vector<Body>& before_forces,
                  const std::vector<RigidState>& flown, ContactProblem& problem)
{
    for (int i : island.bodies) {
        problem.bodies[i] = with_forces(before_forces[i], world.bodies[i].state, flown[i]);
        problem.bodies[i].velocity -= island.frame.change();
    }
}

} // namespace rigor
