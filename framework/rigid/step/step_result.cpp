// SPDX-License-Identifier: MIT
// Collects the contacts of a step, including those of islands that took substeps, and counts the
// contacts and the islands. Then it gives the world its new states and the impulses for the next
// warm start.
#include "rigid/step/step_result.hpp"

#include "rigid/bodies/mass.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/contact/warm_start.hpp"

#include <algorithm>

namespace rigor {

namespace {

std::vector<ContactRecord> records_of(const ContactProblem& problem)
{
    std::vector<ContactRecord> records;
    records.reserve(problem.contacts.size());
    for (const ContactConstraint& c : problem.contacts) {
        const Vector3d impulse = c.collision_impulse + c.contact_impulse;
        if (impulse.isZero(0)) continue;
        records.push_back({c.body1, c.body2, c.point, c.normal, -c.gap, impulse});
    }
    return records;
}

template <class T> void append(std::vector<T>& list, const std::vector<T>& more)
{
    list.insert(list.end(), more.begin(), more.end());
}

} // namespace

void collect_contacts(World& world, const ContactProblem& problem,
                      const ContactCandidates& candidates, const Refinement& refined,
                      StepResult& result)
{
    std::vector<ContactRecord> records;
    // Two threads share this work if there are at least twice this many contacts.
    constexpr std::size_t grain_size = 512;
    problem.pool->run_both(
        problem.contacts.size(), grain_size,
        [&] {
            result.warm_contacts =
                warm_contacts(candidates.poses, problem.contacts, problem.time_step);
        },
        [&] { records = records_of(problem); });
    if (!refined.warm_contacts.empty()) {
        append(result.warm_contacts, refined.warm_contacts);
        sort_by_bodies(result.warm_contacts);
    }
    for (const Island& island : problem.islands)
        append(result.records, island.moved_bounces);
    if (result.records.empty())
        result.records = std::move(records);
    else
        append(result.records, records);
    world.counters.contacts += result.records.size();
    append(result.records, refined.records);
    world.counters.islands += problem.islands.size();
    for (std::size_t i = 0; i < result.states.size(); ++i)
        require_finite(world.bodies[i], result.states[i], world.time + problem.time_step);
}

std::vector<ContactRecord> finish_step(World& world, double time_step, StepResult result)
{
    // The contacts of sleeping bodies are already among the sleeping contacts, which are appended
    // below.
    std::erase_if(result.records, [&](const ContactRecord& r) {
        return world.bodies[r.body1].rest.is_asleep() || world.bodies[r.body2].rest.is_asleep();
    });
    for (std::size_t i = 0; i < result.states.size(); ++i) {
        RigidBody& body = world.bodies[i];
        body.state = result.states[i];
        if (body.only_axis) body.state.angular_momentum = own_angular_momentum(body, body.state);
    }
    for (SleepingContact contact : world.memory.sleeping_contacts) {
        contact.impulse *= time_step / contact.time_step;
        result.records.push_back(contact);
    }
    world.memory.warm_contacts = std::move(result.warm_contacts);
    world.time += time_step;
    ++world.counters.steps;
    return std::move(result.records);
}

} // namespace rigor
