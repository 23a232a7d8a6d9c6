// SPDX-License-Identifier: MIT
// The same scenes in very small and very large sizes, and far from the origin.
#include "rigid/step/step.hpp"
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::stress {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Three cubes and a ball that fall in tilted poses, with all lengths multiplied by s.
World falling_scene(double s)
{
    std::vector<RigidBody> bodies = {ground({0.3, 0.5})};
    for (int i = 0; i < 3; ++i)
        bodies.push_back(body_of(cube(s), s * Vector3d(0.3 * i, 1 + 1.5 * i, 0.1 * i), {0.3, 0.5},
                                 turn({1, 2, 3}, 0.3 * i)));
    bodies.push_back(body_of(Sphere{s / 2}, s * Vector3d(0.2, 6, 0), {0.3, 0.5}));
    World world = world_of(std::move(bodies));
    world.settings.optimisations.sleep = false; // bodies fall asleep after half a second
    return world;
}

// With lengths scaled by s = 4ᵏ and times by √s = 2ᵏ, every number of the scene changes only by a
// power of two. So the motion is bitwise the same, unless the engine contains an absolute length.
// The run ends before the cubes rest on each other: position correction has an absolute rate.
void resemble(Record& record, int k)
{
    const double s = std::ldexp(1.0, 2 * k), time = std::ldexp(1.0, k);
    World unit = falling_scene(1);
    const double scale = lifting_energy(falling_scene(s), s);
    Watch watch(falling_scene(s), record, scale);
    double apart = 0;
    constexpr int steps = 120;
    watch.run(steps, time * frame, 1, [&] {
        step(unit, frame);
        for (std::size_t i = 0; i < unit.bodies.size(); ++i)
            apart = std::max(
                apart, (watch.world().bodies[i].state.position / s - unit.bodies[i].state.position)
                           .norm());
    });
    record.limit_drift("apart from the scene of 1 m, in edges", apart, 64 * steps * eps, 'R');
    watch.limit_energy(allowed_depth);
}

void stand(Record& record, double edge, const Vector3d& foot)
{
    World world = stack(5, edge, foot);
    const double scale = lifting_energy(world, edge);
    Watch watch(std::move(world), record, scale);
    watch.run(600, frame, 10);
    const double rounding = 64 * 600 * eps * foot.norm();
    record.limit_drift("moved, in edges", watch.farthest_moved() / edge, standing, 'B');
    watch.limit_penetration(allowed_depth * edge + rounding);
    watch.limit_energy(allowed_depth + rounding / edge);
}

// A scene 1e6 m from the origin moves as it does at the origin, up to the rounding of its
// positions. In a free fall and in sliding, nothing amplifies this rounding.
void move_far(Record& record, const Vector3d& origin)
{
    const auto scene = [](const Vector3d& at) {
        RigidBody block = body_of(cube(1), at + Vector3d(0, 0.5, 0), {0, 0.2});
        block.state.velocity = {3, 0, 1};
        RigidBody ball = body_of(Sphere{0.5}, at + Vector3d(0, 0.5, 5), {0, 0.2});
        ball.state.velocity = {2, 0, 0};
        RigidBody thrown = body_of(cube(1), at + Vector3d(0, 20, 10), {0, 0.2});
        thrown.state.velocity = {1, 5, 0};
        spin(thrown, {1, 2, 3});
        return world_of({fixed(Plane{}, at, {0, 0.2}), block, ball, thrown});
    };
    World near = scene({0, 0, 0});
    World far = scene(origin);
    const double scale = lifting_energy(far, 1);
    Watch watch(std::move(far), record, scale);
    double apart = 0;
    watch.run(120, frame, 1, [&] {
        step(near, frame);
        for (std::size_t i = 0; i < near.bodies.size(); ++i)
            apart = std::max(apart, (watch.world().bodies[i].state.position - origin -
                                     near.bodies[i].state.position)
                                        .norm());
    });
    record.limit_drift("apart from the scene at the origin [m]", apart,
                       64 * 120 * eps * origin.norm(), 'R');
}

} // namespace

void add_scale(Suite& suite)
{
    for (int k : {-7, -4, -2, 2, 4, 7}) {
        char name[64];
        std::snprintf(name, sizeof name, "falling cubes of %.3g m", std::ldexp(1.0, 2 * k));
        suite.push_back({"scale 1e-4 to 1e4 m, origin to 1e6 m", name, true,
                         [k](Record& record) { resemble(record, k); }});
    }
    for (double edge : {1e-4, 1e-3, 1e-2, 1e-1, 1e1, 1e2, 1e3, 1e4}) {
        char name[64];
        std::snprintf(name, sizeof name, "stack of 5 cubes of %g m, h = 1/60 s", edge);
        suite.push_back(
            {"scale 1e-4 to 1e4 m, origin to 1e6 m", name, true, [edge](Record& record) {
                 stand(record, edge, {0, 0, 0});
             }});
    }
    for (double distance : {1e2, 1e4, 1e6}) {
        char name[64];
        const Vector3d at(distance, -distance, distance);
        std::snprintf(name, sizeof name, "stack of 5 cubes at %g m", distance);
        suite.push_back({"scale 1e-4 to 1e4 m, origin to 1e6 m", name, true,
                         [at](Record& record) { stand(record, 1, at); }});
        std::snprintf(name, sizeof name, "slide, roll and flight at %g m", distance);
        suite.push_back({"scale 1e-4 to 1e4 m, origin to 1e6 m", name, true,
                         [at](Record& record) { move_far(record, at); }});
    }
}

} // namespace rigor::stress
