// SPDX-License-Identifier: MIT
// The pile in our engine.
#include "rigid/step/step.hpp"
#include "run.hpp"

#include "rigid/bodies/mass.hpp"
#include "support/bench/bench.hpp"

#include <string>

namespace rigor {

World pile_world(const PileStart& start, const PileOptions& options)
{
    World world;
    world.settings.gravity = {0, pile_gravity, 0};
    world.settings.contact_method = ContactMethod::simultaneous;
    world.settings.formulas_are_reference = true;
    world.settings.optimisations.sleep = options.sleep;
    world.pool = ThreadPool(options.threads);
    const auto add = [&world](const Vector3d& size, const Vector3d& X, const Quaternion& q,
                              bool is_static) {
        RigidBody& body = world.bodies.emplace_back();
        body.name = std::to_string(world.bodies.size());
        body.parts = {{Box{size}, Vector3d::Zero(), {}, pile_density}};
        body.material = {0, pile_friction};
        body.is_static = is_static;
        body.state.position = X;
        body.state.orientation = q;
        set_mass_from_parts(body);
    };
    for (const Wall& wall : start.walls)
        add(wall.size, wall.center, {}, true);
    for (std::size_t i = 0; i < start.cubes.size(); ++i)
        add(Vector3d::Ones(), start.cubes[i].X, start.orientations[i], false);
    return world;
}

PileRun pile_rigor(const PileStart& start, const PileOptions& options)
{
    World world = pile_world(start, options);
    PileRun run;
    std::uint64_t asleep = 0;
    for (int i = 0; i < options.steps; ++i) {
        const std::uint64_t before = world.counters.bodies_asleep;
        run.step_seconds.push_back(seconds([&] { step(world, pile_step); }));
        asleep = world.counters.bodies_asleep - before;
    }
    run.asleep = static_cast<double>(asleep) / static_cast<double>(start.cubes.size());
    for (const RigidBody& body : world.bodies)
        if (!body.is_static) run.cubes.push_back(pose_of(body.state));
    return run;
}

} // namespace rigor
