// SPDX-License-Identifier: MIT
// Runs a scene and writes its trajectory: the header with the bodies, the frame at time 0, then the
// frames of the chosen steps, and last the counters.
#include "scene/run/run_scene.hpp"

#include "deformable/step/step.hpp"
#include "rigid/step/step.hpp"
#include "scene/run/record_solid.hpp"

#include <cmath>
#include <stdexcept>

namespace rigor {

namespace {

// Does the time step with this number, counted from 1. The times at its start and end are computed
// from the number, so that rounding errors do not accumulate.
std::vector<ContactRecord> step_to(DeformableWorld& world, const Scene& scene, std::int64_t number)
{
    double& time = world.rigid.time;
    time = static_cast<double>(number - 1) * scene.time_step;
    std::vector<ContactRecord> contacts =
        world.solids.empty() ? step(world.rigid, scene.time_step) : step(world, scene.time_step);
    time = static_cast<double>(number) * scene.time_step;
    return contacts;
}

std::vector<RigidState> states_of(const World& world)
{
    std::vector<RigidState> states;
    states.reserve(world.bodies.size());
    for (const RigidBody& body : world.bodies)
        states.push_back(body.state);
    return states;
}

// Makes the frames of a run, one after the other.
class Recorder {
public:
    explicit Recorder(const DeformableWorld& world) : world_(world), solids_(world.solids.size()) {}

    Frame frame(std::int64_t step, std::vector<ContactRecord> contacts)
    {
        const double time = world_.rigid.time;
        Frame frame{step, time, states_of(world_.rigid), std::move(contacts)};
        for (std::size_t i = 0; i < solids_.size(); ++i)
            frame.solids.push_back(solids_[i].frame(world_.solids[i], time));
        return frame;
    }

private:
    const DeformableWorld& world_;
    std::vector<SolidRecorder> solids_;
};

} // namespace

void run_scene(const Scene& scene, Record record, const ByteSink& write,
               const RunSettings& settings)
{
    RecordedWorld made = make_recorded_world(scene, settings);
    DeformableWorld& world = made.world;
    Recorder recorder(world);
    write(encode_start(scene, made.bodies));
    write(encode_frame(recorder.frame(0, {})));
    const std::int64_t steps = step_count(scene);
    for (std::int64_t number = 1, frame = 1; number <= steps; ++number) {
        std::vector<ContactRecord> contacts = step_to(world, scene, number);
        const bool is_frame = frame_step(scene, frame) == number;
        if (is_frame) ++frame;
        if (is_frame || record == Record::every_step)
            write(encode_frame(recorder.frame(number, std::move(contacts))));
    }
    write(encode_end(world.rigid.counters));
}

std::vector<std::vector<RigidState>> advance(const Scene& scene, const std::vector<Moment>& starts,
                                             int steps, const RunSettings& settings)
{
    DeformableWorld world = make_deformable_world(scene, settings);
    const std::vector<Deformable> solids = world.solids;
    std::vector<std::vector<RigidState>> results;
    for (const auto& [time, states] : starts) {
        std::vector<RigidBody>& bodies = world.rigid.bodies;
        if (states.size() != bodies.size())
            throw std::invalid_argument("advance: expected a state for each body of the scene");
        for (std::size_t i = 0; i < states.size(); ++i) {
            bodies[i].state = states[i];
            bodies[i].rest = {};
        }
        world.rigid.memory = {};
        world.solids = solids;
        const std::int64_t start = std::llround(time / scene.time_step);
        for (int i = 1; i <= steps; ++i)
            step_to(world, scene, start + i);
        results.push_back(states_of(world.rigid));
    }
    return results;
}

} // namespace rigor
