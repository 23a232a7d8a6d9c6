// SPDX-License-Identifier: MIT
// Decides which islands move with the mean of their velocities at the start and the end of the
// step: those that are solved again with the contacts in the middle of the step, and those whose
// contacts keep their normals.
#include "rigid/step/mean_velocity.hpp"

#include "rigid/motion/free_flight.hpp"
#include "rigid/step/midpoint/midpoint_contact.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Whether the contacts of an island act along the same normals during the whole step, as on an
// incline. This is so if v·n is zero at every contact with an impulse, at the start and at the
// end of the step, and if the collision stage changed no v·n. On the wall of a bowl the normals
// change, and the mean of two velocities would add energy.
bool holds_along_fixed_normals(const ContactProblem& problem, const Island& island,
                               const std::vector<Body>& before)
{
    // A contact opens or closes if |v·n| is above this fraction of the speed of its bodies relative
    // to the ground. A smaller |v·n| is only an error that the sweeps leave; it moves no point by
    // more than 1e-6 of the distance that the bodies move. The limit also holds for the change of
    // v·n by the collision stage. This change may be tiny but not zero between bodies that gravity
    // accelerates equally.
    constexpr double opens = 1e-6;
    // Between bodies at rest, the sweeps leave a |v·n| of at most this share of the speed that the
    // forces of the step add.
    constexpr double left_at_rest = 1e-12;
    const std::vector<Body> grounds = problem.grounds_of(island);
    const auto speed_of = [&](const Body& body) {
        double speed = 0;
        for (const Body& ground : grounds)
            speed = std::max(speed, (body.velocity - ground.velocity).norm());
        return speed;
    };
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            const double hit = c.normal_K * c.collision_impulse.norm(); // change of v·n
            if (c.contact_impulse.isZero(0) && hit == 0) continue;
            const double none =
                std::max(left_at_rest * std::abs(c.force_speed), problem.rounding_speed(c));
            double v_n = 0, speed = 0; // the larger of those at the start and at the end
            for (const std::vector<Body>* bodies : {&before, &problem.bodies}) {
                v_n = std::max(
                    v_n, std::abs(problem.velocity_between(*bodies, c, c.point).dot(c.normal)));
                speed =
                    std::max(speed, speed_of((*bodies)[c.body1]) + speed_of((*bodies)[c.body2]));
            }
            if (std::max(hit, v_n) > std::max(opens * speed, none)) return false;
        }
    return true;
}

} // namespace

std::vector<char> solve_again_at_midpoint(const World& world,
                                          const std::vector<Body>& before_forces,
                                          const std::vector<RigidState>& flown,
                                          std::vector<Pose> poses, ContactProblem& problem)
{
    std::vector<char> by_mean(problem.islands.size(), false);
    // Integrators with stages converge with an order above the first even where forces change
    // within a step. The positions of bodies that contacts hold should have a higher order too.
    if (!computes_forces_in_stages(world.settings.integrator_under_forces())) return by_mean;
    for (std::size_t k = 0; k < by_mean.size(); ++k) {
        const Island& island = problem.islands[k];
        switch (solve_at_midpoint(world, before_forces, flown, island, poses, problem)) {
        case MidpointResult::solved:
            by_mean[k] = true;
            break;
        case MidpointResult::unchanged:
            by_mean[k] = holds_along_fixed_normals(problem, island, before_forces);
            break;
        case MidpointResult::refused:
            break;
        }
    }
    return by_mean;
}

} // namespace rigor
