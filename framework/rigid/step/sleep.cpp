// SPDX-License-Identifier: MIT
// Sleep of islands at rest. The code adds up how long each body of an island has stayed in its
// place. If all bodies of the island have stayed there for long enough, they become a sleeping
// group without velocity, and their contacts are stored in the world. A group wakes as a whole.
#include "rigid/step/sleep.hpp"

#include "rigid/bodies/orientation.hpp"
#include "rigid/contact/warm_start.hpp"

#include <algorithm>
#include <iterator>

namespace rigor {

namespace {

// Shortest time at rest before a body sleeps [s]. With a shorter time, a body would sleep at a
// turning point of its motion; with a longer time, more steps are computed for bodies at rest.
constexpr double needed_rest = 0.5;
// If a step has moved a body to a new place, the time at rest starts with the length of this step,
// but with at most this time [s]. Otherwise a moving body would fall asleep at once in a scene with
// long steps.
constexpr double first_rest = needed_rest / 2;
// A body counts as at rest if its center of mass moves, and its rotation moves its points, by at
// most this fraction of a length. This length is the body's radius or, if it is shorter, the
// distance of a free fall during `needed_rest`. With the radius alone, a large body that begins to
// slide or fall would count as at rest. With a larger fraction, bodies that creep would sleep; with
// a smaller fraction, the errors of the solver would keep piles awake.
constexpr double rest_fraction = 1e-4;

// Whether a body with the state b before and the state a now counts as at rest.
// @param fall  distance of a free fall during `needed_rest` [m]
bool is_near(const RigidState& a, const RigidState& b, double radius, double fall)
{
    const double unit = std::min(radius, fall);
    const double moved = (a.position - b.position).norm();
    const double turned = 2 * orientation_distance(a.orientation, b.orientation);
    return moved <= rest_fraction * unit && turned * radius <= rest_fraction * unit;
}

// Adds the length of the step to the time at rest of each body of the island, or starts this time
// again.
void add_rest_times(World& world, const Island& island, const std::vector<double>& radii,
                    const std::vector<RigidState>& states, double time_step)
{
    const double fall = world.settings.gravity.norm() * needed_rest * needed_rest / 2;
    for (int i : island.bodies) {
        Rest& rest = world.bodies[i].rest;
        if (rest.duration > 0 && is_near(states[i], rest.place, radii[i], fall)) {
            rest.duration += time_step;
        } else {
            rest.duration = std::min(time_step, first_rest);
            rest.place = states[i];
        }
    }
}

// Whether all bodies of the island have been at rest for long enough, and no spring or applied
// force pulls on one of them.
bool has_rested(const World& world, const Island& island, const std::vector<bool>& has_force)
{
    return std::all_of(island.bodies.begin(), island.bodies.end(), [&](int i) {
        return world.bodies[i].rest.duration >= needed_rest && !has_force[i];
    });
}

// Whether a body of the island touches a driven body that moves at this time, or a belt that may
// still move later. (A belt that starts would not wake a sleeping body, since it keeps its pose.)
bool is_driven(const World& world, const ContactProblem& problem, const Island& island)
{
    if (problem.driven.empty()) return false;
    const auto moves = [&](int i) {
        const auto& drive = world.bodies[i].drive;
        if (!drive) return false;
        if (drive->is_belt && world.time < drive->end) return true;
        const auto [V, w] = drive_velocity(*drive, world.time);
        return !V.isZero(0) || !w.isZero(0);
    };
    return std::any_of(island.pairs.begin(), island.pairs.end(), [&](const ContactPair& pair) {
        const ContactConstraint& c = problem.contacts[pair.first];
        return moves(c.body1) || moves(c.body2);
    });
}

template <class T, class Condition>
void copy_if(const std::vector<T>& from, const Condition& condition, std::vector<T>& to)
{
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), condition);
}

} // namespace

void fall_asleep(World& world, const ContactProblem& problem, const std::vector<double>& radii,
                 const std::vector<bool>& has_force, StepResult& result)
{
    if (!world.settings.optimisations.sleep || world.settings.gravity.isZero(0)) return;
    if (problem.time_step == 0) return;
    std::vector<bool> fell; // for each body, whether it falls asleep now; empty if none does
    for (const Island& island : problem.islands) {
        add_rest_times(world, island, radii, result.states, problem.time_step);
        if (!has_rested(world, island, has_force) || is_driven(world, problem, island)) continue;
        fell.resize(world.bodies.size());
        const int group = *std::min_element(island.bodies.begin(), island.bodies.end());
        for (int i : island.bodies) {
            world.bodies[i].rest.group = group;
            result.states[i].velocity.setZero();
            result.states[i].angular_momentum.setZero();
            fell[i] = true;
        }
    }
    if (fell.empty()) return;
    const auto holds_sleeper = [&](const auto& contact) {
        return fell[contact.body1] || fell[contact.body2];
    };
    for (const ContactRecord& record : result.records)
        if (holds_sleeper(record))
            world.memory.sleeping_contacts.push_back({record, problem.time_step});
    copy_if(result.warm_contacts, holds_sleeper, world.memory.sleeping_warm_contacts);
    std::erase_if(result.warm_contacts, holds_sleeper);
}

void wake(World& world, const std::vector<int>& bodies)
{
    std::vector<bool> wakes(world.bodies.size(), false); // for each group, whether it wakes
    for (int i : bodies)
        wakes[world.bodies[i].rest.group] = true;
    const auto is_woken = [&](int i) {
        const Rest& rest = world.bodies[i].rest;
        return rest.is_asleep() && wakes[rest.group];
    };
    const auto holds_woken = [&](const auto& contact) {
        return is_woken(contact.body1) || is_woken(contact.body2);
    };
    StepMemory& memory = world.memory;
    std::erase_if(memory.sleeping_contacts, holds_woken);
    copy_if(memory.sleeping_warm_contacts, holds_woken, memory.warm_contacts);
    std::erase_if(memory.sleeping_warm_contacts, holds_woken);
    sort_by_bodies(memory.warm_contacts);
    for (RigidBody& body : world.bodies)
        if (body.rest.is_asleep() && wakes[body.rest.group]) body.rest = {};
}

void wake_pulled(World& world, const std::vector<bool>& has_force)
{
    for (std::size_t i = 0; i < has_force.size(); ++i)
        if (has_force[i] && world.bodies[i].rest.is_asleep()) wake(world, {static_cast<int>(i)});
}

} // namespace rigor
