// SPDX-License-Identifier: MIT
// Bodies that overlap at the start.
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include <algorithm>

namespace rigor::stress {

namespace {

// The energy that the separation may add: the energy of lifting all bodies by `lift` on average,
// and that of a speed of one edge per second.
double parting_energy(const World& world, double lift, double edge)
{
    double mass = 0;
    for (const RigidBody& body : world.bodies)
        mass += body.mass;
    return lifting_energy(world, lift) + mass * edge * edge / 2;
}

// The bodies have ten seconds to separate and must not fly apart.
void part(Record& record, World world, double lift, bool completely = true)
{
    const double edge = 1, scale = parting_energy(world, lift, edge);
    const double overlap = deepest_overlap(world);
    Watch watch(std::move(world), record, scale);
    watch.run(600, frame, 600);
    record.drift = watch.farthest_moved() / edge;
    record.limit("overlap after 10 s [m]", deepest_overlap(watch.world()),
                 completely ? allowed_depth * edge : overlap, 'I');
    record.limit("energy, over lifting out and an edge a second", record.energy_gain, 1, 'I');
}

void add_recovery(Suite& suite)
{
    for (double share : {0.01, 0.1, 0.5}) {
        const std::string name = std::to_string(static_cast<int>(share * 100)) + " % of an edge";
        const auto add = [&](const std::string& what, double lift,
                             const std::function<World()>& world) {
            suite.push_back({"overlap recovery", name + ", " + what, true,
                             [=](Record& record) { part(record, world(), lift); }});
        };
        add("cube in the ground", share, [share] {
            return world_of({ground(), body_of(cube(1), {0, 0.5 - share, 0})});
        });
        add("cube in a cube on the ground", share, [share] {
            return world_of(
                {ground(), body_of(cube(1), {0, 0.5, 0}), body_of(cube(1), {0, 1.5 - share, 0})});
        });
        add("five cubes in each other", 2 * share, [share] {
            std::vector<RigidBody> bodies = {ground()};
            for (int i = 0; i < 5; ++i)
                bodies.push_back(body_of(cube(1), {0, 0.5 + i * (1 - share), 0}));
            return world_of(std::move(bodies));
        });
        add("two cubes without gravity", 0, [share] {
            return world_of({body_of(cube(1), {0, 0, 0}), body_of(cube(1), {1 - share, 0, 0})},
                            {0, 0, 0});
        });
        add("two spheres without gravity", 0, [share] {
            return world_of(
                {body_of(Sphere{0.5}, {0, 0, 0}), body_of(Sphere{0.5}, {1 - share, 0, 0})},
                {0, 0, 0});
        });
    }
}

void add_deep(Suite& suite)
{
    const auto add = [&suite](const std::string& name, double lift,
                              const std::function<World()>& world, bool completely = true) {
        suite.push_back({"bodies deep inside each other", name, name.find("eight") != 0,
                         [=](Record& record) { part(record, world(), lift, completely); }});
    };
    add("two cubes at one place", 1, [] {
        return world_of({ground(), body_of(cube(1), {0, 0.5, 0}), body_of(cube(1), {0, 0.5, 0})});
    });
    add("two spheres at one place", 1, [] {
        return world_of(
            {ground(), body_of(Sphere{0.5}, {0, 0.5, 0}), body_of(Sphere{0.5}, {0, 0.5, 0})});
    });
    add("sphere in the middle of a cube", 1, [] {
        return world_of(
            {ground(), body_of(cube(1), {0, 0.5, 0}), body_of(Sphere{0.3}, {0, 0.5, 0})});
    });
    add("cube inside of a wall", 1, [] {
        return world_of({fixed(Box{{10, 2, 10}}, {0, -1, 0}), body_of(cube(1), {0, -0.5, 0})});
    });
    add("sphere 2 m below the ground", 2.5, [] {
        return world_of({ground(), body_of(Sphere{0.5}, {0, -2, 0})});
    });
    add(
        "sphere 100 m below the ground, which takes longer", 100,
        [] {
            return world_of({ground(), body_of(Sphere{0.5}, {0, -100, 0})});
        },
        false);
    add("eight cubes at one place", 4, [] {
        std::vector<RigidBody> bodies = {ground()};
        for (int i = 0; i < 8; ++i)
            bodies.push_back(body_of(cube(1), {0.01 * i, 0.5, 0.003 * i * i}));
        return world_of(std::move(bodies));
    });
}

} // namespace

void add_overlap(Suite& suite)
{
    add_recovery(suite);
    add_deep(suite);
}

} // namespace rigor::stress
