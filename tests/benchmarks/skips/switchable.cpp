// SPDX-License-Identifier: MIT
// The skips that a setting of the world turns off.
#include "rigid/step/step.hpp"
#include "run.hpp"
#include "stress/scenes.hpp"
#include "support/random.hpp"

namespace rigor {

namespace {

using stress::body_of;
using stress::cube;
using stress::frame;
using stress::ground;

// Resting bodies may differ in position by as much as they may overlap, a hundredth of an edge [m].
constexpr double resting = 0.01;

World towers(int count, int height)
{
    std::vector<RigidBody> bodies = {ground()};
    for (int i = 0; i < count; ++i)
        for (int y = 0; y < height; ++y)
            bodies.push_back(body_of(cube(1), {3.0 * (i % 10), y + 0.5, 3.0 * (i / 10)}));
    return stress::world_of(std::move(bodies));
}

// Cubes that fall flat from different heights, so that they come to rest one after the other.
World landing_cubes(int count)
{
    std::vector<RigidBody> bodies = {ground()};
    for (int i = 0; i < count; ++i)
        bodies.push_back(body_of(cube(1), {3.0 * (i % 10), 0.5 + 0.02 * i, 3.0 * (i / 10)}));
    return stress::world_of(std::move(bodies));
}

// A gable wall in which each brick rests on two below. It has too many contacts to be solved to
// machine precision.
std::vector<RigidBody> gable(int width, int height)
{
    std::vector<RigidBody> bodies = {ground()};
    for (int row = 0; row < height; ++row)
        for (int i = 0; i < width - row; ++i)
            bodies.push_back(body_of(Box{{2, 1, 1}}, {2.02 * i + 1.01 * row, row + 0.5, 0}));
    return bodies;
}

// Towers whose lowest cubes start with different speeds, so that each slides for a different time.
World pushed_towers(int count, int height)
{
    World world = towers(count, height);
    for (int i = 0; i < count; ++i)
        world.bodies[static_cast<std::size_t>(1 + i * height)].state.velocity = {0.02 * i, 0, 0};
    return world;
}

World after(World world, int steps)
{
    for (int i = 0; i < steps; ++i)
        step(world, frame);
    return world;
}

SkipCase switched(const std::string& name, const std::string& scene, const World& world, int steps,
                  bool Optimisations::*skip, const std::string& counter_name,
                  std::uint64_t Counters::*counter, double bound)
{
    World with = world, without = world;
    with.settings.optimisations.*skip = true;
    without.settings.optimisations.*skip = false;
    if (skip == &Optimisations::sleep)
        for (RigidBody& body : without.bodies)
            body.rest = {}; // wakes the body
    return {name,
            scene,
            counter_name,
            [=] { return run_steps(with, steps, counter); },
            [=] { return run_steps(without, steps, counter); },
            bound};
}

} // namespace

SkipRun run_steps(const World& world, int steps, std::uint64_t Counters::*counter)
{
    World copy = world;
    copy.counters = {};
    SkipRun run;
    run.seconds = seconds([&] {
        for (int i = 0; i < steps; ++i)
            step(copy, frame);
    });
    run.counter = static_cast<double>(copy.counters.*counter);
    for (const RigidBody& body : copy.bodies)
        run.result.insert(run.result.end(), body.state.position.data(),
                          body.state.position.data() + 3);
    return run;
}

std::vector<SkipCase> switchable_skips()
{
    World sleepy = towers(50, 4);
    sleepy.settings.optimisations.sleep = true;
    const World high = towers(1, 20), wall = stress::world_of(gable(12, 8));
    return {
        switched("islands", "50 towers of 4 cubes, each pushed", pushed_towers(50, 4), 30,
                 &Optimisations::islands, "islands", &Counters::islands, resting),
        switched("sleep", "50 towers of 4 cubes after 5 s", after(sleepy, 300), 120,
                 &Optimisations::sleep, "bodies asleep", &Counters::bodies_asleep, resting),
        switched("warm start", "a gable of 68 bricks", wall, 60, &Optimisations::warm_start,
                 "contact sweeps", &Counters::contact_sweeps, resting),
        switched("early exit", "100 cubes that land", landing_cubes(100), 120,
                 &Optimisations::early_exit, "contact sweeps", &Counters::contact_sweeps, resting),
        switched("optimised formulas", "tower of 20 cubes", high, 120,
                 &Optimisations::optimised_formulas, "contact impulses",
                 &Counters::contact_impulses, resting),
    };
}

} // namespace rigor
