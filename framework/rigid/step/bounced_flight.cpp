// SPDX-License-Identifier: MIT
// The flight after the collision stage of bodies on which springs, applied forces or drag act: the
// velocities of these bodies are replaced, and the flight is repeated. Where it leaves a bounced
// contact open, the contact stage is told so, because this stage predicts a gap from the velocity
// at the end of the step, and strong forces may have turned this velocity round.
#include "rigid/step/bounced_flight.hpp"

#include "rigid/contact/make_problem.hpp"
#include "rigid/detection/overlap_depth.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/impact.hpp"
#include "rigid/step/supported_flight.hpp"

#include <algorithm>

namespace rigor {

namespace {

// The islands that fly again.
std::vector<const Island*> bounced_islands(const ContactProblem& problem,
                                           const std::vector<bool>& pulled)
{
    std::vector<const Island*> islands;
    for (const Island& island : problem.islands) {
        const bool is_pulled = std::any_of(island.bodies.begin(), island.bodies.end(),
                                           [&](int i) { return pulled[i]; });
        const bool has_bounced =
            std::any_of(island.pairs.begin(), island.pairs.end(),
                        [&](const ContactPair& pair) { return bounced(problem, pair); });
        if (is_pulled && has_bounced && island.bodies.size() <= most_refined &&
            island.frame.is_world())
            islands.push_back(&island);
    }
    return islands;
}

// How the point of a contact on a body moves along the normal of the contact in a flight: its
// displacement [m], and its speed at the end [m/s].
struct NormalMotion {
    double displacement = 0, last_speed = 0;
};

NormalMotion motion_of(const ContactConstraint& c, const Body& body, const RigidState& start,
                       const RigidState& end, double time_step)
{
    const Body last = with_forces(body, start, end);
    const Vector3d r = c.point - body.position;
    const double last_speed = (last.velocity + last.angular_velocity.cross(r)).dot(c.normal);
    if (body.is_static()) return {time_step * last_speed, last_speed};
    const auto [shift, turn] = displacement_between(start, end);
    return {(shift + turn.cross(r)).dot(c.normal), last_speed};
}

// Sets `gap_correction` where the flight leaves a bounced contact open.
void predict_gaps(const World& world, const std::vector<RigidState>& flown, const Island& island,
                  ContactProblem& problem)
{
    const auto motion = [&](const ContactConstraint& c, int i) {
        return motion_of(c, problem.bodies[i], world.bodies[i].state, flown[i], problem.time_step);
    };
    for (const ContactPair& pair : island.pairs)
        for (int k = pair.first; k < pair.last; ++k) {
            ContactConstraint& c = problem.contacts[k];
            if (c.collision_impulse.isZero(0)) continue;
            const NormalMotion first = motion(c, c.body1), second = motion(c, c.body2);
            const double opens = first.displacement - second.displacement;
            if (c.gap + opens < 0) continue;
            const double last_speed = first.last_speed - second.last_speed;
            c.gap_correction = std::max(c.gap_correction, opens - problem.time_step * last_speed);
        }
}

} // namespace

BouncedFlight::BouncedFlight(World& world, ContactProblem& problem, const std::vector<bool>& pulled)
    : world_(world)
{
    if (!computes_forces_in_stages(world.settings.integrator_under_forces())) return;
    const std::vector<const Island*> islands = bounced_islands(problem, pulled);
    if (islands.empty()) return;
    bodies_.assign(world.bodies.size(), false);
    for (const Island* island : islands)
        for (const int i : island->bodies) {
            RigidState& state = world.bodies[i].state;
            before_.emplace_back(i, state);
            bodies_[i] = true;
            state.velocity = problem.bodies[i].velocity;
            state.angular_momentum = problem.bodies[i].angular_momentum;
        }
    const Counters counters = world.counters; // the repeated flight does not count
    flown_ = fly_all(world, pulled, problem.time_step, *problem.pool);
    world.counters = counters;

    for (const Island* island : islands)
        predict_gaps(world, flown_, *island, problem);
}

void BouncedFlight::restore()
{
    for (const auto& [i, state] : before_)
        world_.bodies[i].state = state;
    before_.clear();
}

} // namespace rigor
