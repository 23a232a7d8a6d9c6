// SPDX-License-Identifier: MIT
#include "scene/make_world.hpp"

#include <cmath>
#include <stdexcept>

namespace rigor {

namespace {

// One step to `number`: time is counted in steps, so that it carries no sum of roundings.
std::vector<ContactRecord> step_to(World& world, const Scene& scene, std::int64_t number)
{
    world.time = static_cast<double>(number - 1) * scene.time_step;
    std::vector<ContactRecord> contacts = step(world, scene.time_step);
    world.time = static_cast<double>(number) * scene.time_step;
    return contacts;
}

Frame frame_of(const World& world, std::int64_t step, std::vector<ContactRecord> contacts)
{
    Frame frame{step, world.time, {}, std::move(contacts)};
    frame.bodies.reserve(world.bodies.size());
    for (const RigidBody& body : world.bodies)
        frame.bodies.push_back(body.state);
    return frame;
}

} // namespace

void run_scene(const Scene& scene, Record record, const ByteSink& write,
               const RunSettings& settings)
{
    RecordedWorld made = make_recorded_world(scene, settings);
    World& world = made.world;
    write(encode_start(scene, made.bodies));
    write(encode_frame(frame_of(world, 0, {})));
    const std::int64_t steps = step_count(scene);
    for (std::int64_t number = 1, frame = 1; number <= steps; ++number) {
        std::vector<ContactRecord> contacts = step_to(world, scene, number);
        const bool is_frame = frame_step(scene, frame) == number;
        if (is_frame) ++frame;
        if (is_frame || record == Record::every_step)
            write(encode_frame(frame_of(world, number, std::move(contacts))));
    }
    write(encode_end(world.counters));
}

std::vector<std::vector<RigidState>> advance(const Scene& scene, const std::vector<Moment>& starts,
                                             int steps, const RunSettings& settings)
{
    World world = make_world(scene, settings);
    std::vector<std::vector<RigidState>> results;
    for (const auto& [time, states] : starts) {
        if (states.size() != world.bodies.size())
            throw std::invalid_argument("advance: expected a state for each body of the scene");
        for (std::size_t i = 0; i < states.size(); ++i)
            world.bodies[i].state = states[i];
        const std::int64_t start = std::llround(time / scene.time_step);
        for (int i = 1; i <= steps; ++i)
            step_to(world, scene, start + i);
        results.push_back(frame_of(world, start + steps, {}).bodies);
    }
    return results;
}

} // namespace rigor
