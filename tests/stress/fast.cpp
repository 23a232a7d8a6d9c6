// SPDX-License-Identifier: MIT
// Steps in which bodies travel farther than the thickness of the obstacles in their way.
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::stress {

namespace {

constexpr double wall_thickness = 0.01, size = 0.1; // [m]

// A body is shot at a wall from a distance of 0.47 times its travel in a step plus its size. It
// must stay in front of the wall.
void shoot(Record& record, RigidBody body, double speed, const Vector3d& direction)
{
    body.state.position = -(0.47 * speed * frame + size) * direction;
    body.state.velocity = speed * direction;
    const Box wall{{wall_thickness, 4000, 4000}};
    World world =
        world_of({fixed(wall, {wall_thickness / 2, 0, 0}, body.material), body}, {0, 0, 0});
    Watch watch(std::move(world), record, 0);
    double beyond = -std::numeric_limits<double>::infinity();
    watch.run(10, frame, 1,
              [&] { beyond = std::max(beyond, watch.world().bodies[1].state.position.x()); });
    record.limit_drift("center beyond the face [m]", beyond, 0, 'I');
    watch.limit_penetration(allowed_depth * size);
    watch.limit_energy(64 * 10 * std::numeric_limits<double>::epsilon(), 'I');
}

void add_walls(Suite& suite)
{
    for (double speed : {10.0, 100.0, 1000.0})
        for (const bool bounces : {false, true}) {
            const Material material{bounces ? 1.0 : 0.0, 0.5};
            const std::string how = " at " + std::to_string(static_cast<int>(speed)) + " m/s" +
                                    (bounces ? ", elastic" : "");
            const auto add = [&](const std::string& name, const RigidBody& body,
                                 const Vector3d& direction) {
                suite.push_back({"walls of 1 cm, thinner than a step's travel", name + how, true,
                                 [=](Record& record) { shoot(record, body, speed, direction); }});
            };
            add("sphere", body_of(Sphere{size / 2}, {0, 0, 0}, material), {1, 0, 0});
            add("sphere, oblique", body_of(Sphere{size / 2}, {0, 0, 0}, material),
                Vector3d(1, 1, 0).normalized());
            RigidBody box = body_of(cube(size), {0, 0, 0}, material, turn({1, 2, 3}, 0.5));
            add("cube", box, {1, 0, 0});
            spin(box, {10, 20, 30});
            add("spinning cube, oblique", box, Vector3d(2, 1, 1).normalized());
        }
}

// Two small bodies are shot at each other. Neither may pass through the other.
void meet(Record& record, const Shape& shape, double speed)
{
    RigidBody left = body_of(shape, {-0.3 * speed * frame - size, 0, 0}), right = left;
    right.state.position = -left.state.position;
    left.state.velocity = {speed, 0, 0};
    right.state.velocity = {-speed, 0, 0};
    Watch watch(world_of({left, right}, {0, 0, 0}), record, 0);
    double passed = -std::numeric_limits<double>::infinity();
    watch.run(10, frame, 1, [&] {
        const auto& bodies = watch.world().bodies;
        passed = std::max(passed, bodies[0].state.position.x() - bodies[1].state.position.x());
    });
    record.limit_drift("how far they passed each other [m]", passed, 0, 'I');
    watch.limit_penetration(allowed_depth * size);
    watch.limit_energy(64 * 10 * std::numeric_limits<double>::epsilon(), 'I');
}

void fly_ten_seconds(Record& record)
{
    RigidBody body = body_of(cube(1), {0, 0, 0});
    body.state.velocity = {1, 100, 0};
    Watch watch(world_of({body}), record, 0);
    watch.run(10, 10, 10);
    const double t = 100;
    const Vector3d exact(t, 100 * t - g * t * t / 2, 0);
    const double scale = t + 100 * t + g * t * t / 2;
    record.limit_drift("place against v t + g t²/2",
                       (watch.world().bodies[0].state.position - exact).norm() / scale,
                       64 * 10 * std::numeric_limits<double>::epsilon(), 'R');
}

// For any time step, no body may end on the far side of the body on which it lands. The bound for
// resting bodies does not apply: a millionth of the distance that gravity covers in such a step is
// already 1 mm.
void land_in_ten_seconds(Record& record, World world, double edge)
{
    const double scale = std::max(lifting_energy(world, edge), total_energy(world));
    Watch watch(std::move(world), record, scale);
    watch.run(10, 10);
    watch.limit_penetration(standing * edge);
    watch.limit_energy(allowed_depth);
}

void add_long_steps(Suite& suite)
{
    suite.push_back({"a step of 10 s", "free flight", true, fly_ten_seconds});
    suite.push_back({"a step of 10 s", "stack of 5 cubes", true,
                     [](Record& record) { land_in_ten_seconds(record, stack(5), 1); }});
    for (double restitution : {0.0, 0.5})
        suite.push_back(
            {"a step of 10 s",
             restitution > 0 ? "ball falls 100 m and bounces" : "ball falls 100 m", true,
             [restitution](Record& record) {
                 const Material material{restitution, 0.5};
                 land_in_ten_seconds(
                     record,
                     world_of({ground(material), body_of(Sphere{0.5}, {0, 100, 0}, material)}), 1);
             }});
    suite.push_back({"a step of 10 s", "pile of 27 cubes falls", true, [](Record& record) {
                         land_in_ten_seconds(record, falling_pile(3, rough), 1);
                     }});
}

} // namespace

void add_fast(Suite& suite)
{
    add_walls(suite);
    for (double speed : {10.0, 100.0, 1000.0}) {
        const std::string how = " at " + std::to_string(static_cast<int>(speed)) + " m/s each";
        suite.push_back({"walls of 1 cm, thinner than a step's travel", "two spheres" + how, true,
                         [speed](Record& record) { meet(record, Sphere{size / 2}, speed); }});
        suite.push_back({"walls of 1 cm, thinner than a step's travel", "two cubes" + how, true,
                         [speed](Record& record) { meet(record, cube(size), speed); }});
    }
    add_long_steps(suite);
}

} // namespace rigor::stress
