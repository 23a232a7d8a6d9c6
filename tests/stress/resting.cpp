// SPDX-License-Identifier: MIT
// Scenes that must stay standing: stacks, and heavy bodies on light ones, for any order of the
// bodies.
#include "stress/scenes.hpp"
#include "stress/watch.hpp"
#include "support/random.hpp"

#include <algorithm>

namespace rigor::stress {

namespace {

constexpr int ten_seconds = 600; // steps of length `frame`

// Runs 10 s and checks that all bodies stay standing.
void stand(Record& record, World world, double edge, int every = 10)
{
    const double scale = lifting_energy(world, edge);
    Watch watch(std::move(world), record, scale);
    watch.run(ten_seconds, frame, every);
    record.limit_drift("moved, in edges", watch.farthest_moved() / edge, standing, 'B');
    watch.limit_penetration(allowed_depth * edge);
    watch.limit_energy(allowed_depth);
}

void add_stacks(Suite& suite)
{
    for (int n : {5, 10, 20, 30, 50, 100})
        suite.push_back({"stacks, h = 1/60 s, 10 s, no sleep", std::to_string(n) + " cubes",
                         n <= 10, [n](Record& record) { stand(record, stack(n), 1); }});
}

void add_heavy(Suite& suite)
{
    for (double ratio : {1.0, 10.0, 100.0, 1e3, 1e4}) {
        const std::string name = std::to_string(static_cast<int>(ratio)) + " times heavier";
        suite.push_back(
            {"heavy on light", name + " cube on a cube", ratio < 1e3, [ratio](Record& record) {
                 World world = stack(1);
                 world.bodies.push_back(body_of(cube(1), {0, 1.5, 0}, rough, {}, 1000 * ratio));
                 stand(record, std::move(world), 1);
             }});
        suite.push_back(
            {"heavy on light", name + " cube on five", false, [ratio](Record& record) {
                 World world = stack(5);
                 world.bodies.push_back(body_of(cube(1), {0, 5.5, 0}, rough, {}, 1000 * ratio));
                 stand(record, std::move(world), 1);
             }});
    }
}

// A wall of cubes with 5 in the lowest row and one fewer in each row above.
World pyramid()
{
    std::vector<RigidBody> bodies = {ground()};
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i < 5 - row; ++i)
            bodies.push_back(body_of(cube(1), {1.1 * (i + row / 2.0), row + 0.5, 0}));
    return world_of(std::move(bodies));
}

// A wall of bricks 2 × 1 × 1, eight in a row. Every other row is offset by half a brick, so its
// ends overhang.
World brick_wall()
{
    std::vector<RigidBody> bodies = {ground()};
    for (int row = 0; row < 8; ++row)
        for (int i = 0; i < 8; ++i)
            bodies.push_back(body_of(Box{{2, 1, 1}}, {2.02 * i + 0.5 * (row % 2), row + 0.5, 0}));
    return world_of(std::move(bodies));
}

// The place of each body of `world` at the end, if the bodies are numbered in the given order.
std::vector<Vector3d> places_after(const World& world, const std::vector<int>& order,
                                   Record& record)
{
    World shuffled = world;
    for (std::size_t i = 0; i < order.size(); ++i)
        shuffled.bodies[i] = world.bodies[static_cast<std::size_t>(order[i])];
    const double scale = lifting_energy(world, 1);
    Watch watch(std::move(shuffled), record, scale);
    watch.run(ten_seconds, frame, 10);
    std::vector<Vector3d> places(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        places[static_cast<std::size_t>(order[i])] = watch.world().bodies[i].state.position;
    return places;
}

void shuffle_bodies(Record& record, const World& world)
{
    testing::Random random(1);
    std::vector<int> order(world.bodies.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<int>(i);
    const std::vector<Vector3d> places = places_after(world, order, record);
    double apart = 0;
    for (int k = 0; k < 4; ++k) {
        for (std::size_t i = order.size() - 1; i > 0; --i)
            std::swap(order[i], order[random.bits() % (i + 1)]);
        const std::vector<Vector3d> shuffled = places_after(world, order, record);
        for (std::size_t i = 0; i < places.size(); ++i)
            apart = std::max(apart, (places[i] - shuffled[i]).norm());
    }
    record.limit_drift("places apart, in edges", apart, allowed_depth, 'I');
    record.limit("penetration [m]", record.penetration, allowed_depth, 'I');
    record.limit("energy gained", record.energy_gain, allowed_depth, 'I');
}

} // namespace

void add_resting(Suite& suite)
{
    add_stacks(suite);
    suite.push_back({"stacks, h = 1/60 s, 10 s, no sleep", "pyramid of 15 cubes", false,
                     [](Record& record) { stand(record, pyramid(), 1); }});
    suite.push_back({"stacks, h = 1/60 s, 10 s, no sleep", "wall of 64 bricks", false,
                     [](Record& record) { stand(record, brick_wall(), 1); }});
    add_heavy(suite);
    suite.push_back({"order of the bodies shuffled, 4 times", "stack of 10 cubes", false,
                     [](Record& record) { shuffle_bodies(record, stack(10)); }});
    suite.push_back({"order of the bodies shuffled, 4 times", "pyramid of 15 cubes", false,
                     [](Record& record) { shuffle_bodies(record, pyramid()); }});
}

} // namespace rigor::stress
