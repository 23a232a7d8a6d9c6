// SPDX-License-Identifier: MIT
// Friction from zero to a million, and restitution 0 and 1.
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include "geometry/shapes/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor::stress {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const double coefficients[] = {0, 0.1, 0.2, 0.5, 0.6, 1, 10, 1e3, 1e6};

std::string text_of(double x)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", x);
    return text;
}

// A block on an incline of 30°, at first at rest. Expected is x = a t²/2 with a = g (sin θ - μ cos
// θ), or no motion if μ > tan θ.
void slide(Record& record, double friction, double restitution)
{
    constexpr int steps = 120;
    constexpr double angle = std::numbers::pi / 6;
    const Quaternion tilt = turn({0, 0, 1}, -angle);
    const Matrix3d R = rotation_matrix(tilt);
    const Material material{restitution, friction};
    World world = world_of({fixed(Plane{}, {0, 0, 0}, material, tilt),
                            body_of(Box{{0.4, 0.2, 0.3}}, 0.1 * R.col(1), material, tilt)});
    const double scale = lifting_energy(world, 0.2);
    Watch watch(std::move(world), record, scale);
    watch.run(steps, frame);
    const double a = std::max(0.0, g * (std::sin(angle) - friction * std::cos(angle)));
    const Vector3d expected = a * frame * frame * steps * steps / 2 * R.col(0);
    const Vector3d moved =
        watch.world().bodies[1].state.position - watch.start().bodies[1].state.position;
    record.limit_drift("slid, against a t²/2 [m]", (moved - expected).norm(),
                       64 * steps * eps * (g * frame * frame * steps * steps / 2), 'R');
    watch.limit_energy(64 * steps * eps);
}

// A spinning ball rubs on the ground. For any μ, energy may only be lost.
void rub(Record& record, double friction)
{
    const Material material{0.5, friction};
    RigidBody ball = body_of(Sphere{0.5}, {0, 1, 0}, material);
    ball.state.velocity = {1, 0, -2};
    spin(ball, {30, 10, 20});
    World world = world_of({ground(material), ball});
    const double scale = total_energy(world);
    Watch watch(std::move(world), record, scale);
    watch.run(300, frame);
    watch.limit_penetration(allowed_depth);
    watch.limit_energy(64 * 300 * eps);
}

void pile_up(Record& record, const Material& material)
{
    World world = falling_pile(3, material);
    const double scale = lifting_energy(world, 1);
    Watch watch(std::move(world), record, scale);
    watch.run(300, frame);
    watch.limit_penetration(allowed_impact_depth);
    watch.limit_energy(allowed_depth);
}

// A ball falls 1 m and bounces for 10 s. It must never rise higher than before; for ε = 1 the
// energy that the steps lose is recorded as drift.
void bounce(Record& record, double restitution, const Shape& shape)
{
    const Material material{restitution, 0.5};
    const double h = 1.0 / 240;
    World world = world_of({ground(material), body_of(shape, {0, 1.5, 0}, material)});
    const double scale = lifting_energy(world, 1);
    Watch watch(std::move(world), record, scale);
    double lowest = std::numeric_limits<double>::infinity();
    watch.run(2400, h, 1, [&] {
        lowest =
            std::min(lowest, (total_energy(watch.world()) - total_energy(watch.start())) / scale);
    });
    if (restitution == 1) record.drift = -lowest; // energy that the steps lose
    watch.limit_energy(64 * 2400 * eps);
    watch.limit_penetration(allowed_depth);
    if (restitution == 0)
        record.limit("speed at the end [m/s]", watch.world().bodies[1].state.velocity.norm(),
                     64 * 2400 * eps * g, 'R');
}

// Equal spheres in a row, with gaps between them. The first one has speed 1, and since the
// collisions happen one after the other, the last one leaves with that speed.
void cradle(Record& record, int n)
{
    std::vector<RigidBody> bodies;
    for (int i = 0; i < n; ++i)
        bodies.push_back(body_of(Sphere{0.5}, {1.1 * i, 0, 0}, {1, 0}));
    bodies[0].state.velocity = {1, 0, 0};
    Watch watch(world_of(std::move(bodies), {0, 0, 0}), record, 0);
    watch.run(120, frame);
    double error = 0;
    for (int i = 0; i < n; ++i) {
        const Vector3d expected(i == n - 1 ? 1 : 0, 0, 0);
        const RigidState& s = watch.world().bodies[static_cast<std::size_t>(i)].state;
        error = std::max(error, (s.velocity - expected).norm());
    }
    record.limit_drift("speeds against 0, ..., 0, 1 [m/s]", error, 64 * n * eps, 'R');
    watch.limit_energy(64 * 120 * eps);
}

} // namespace

void add_material(Suite& suite)
{
    for (double friction : coefficients) {
        const std::string mu = ", friction " + text_of(friction);
        for (double restitution : {0.0, 1.0})
            suite.push_back({"friction 0 to 1e6",
                             "block on 30 degrees" + mu + ", restitution " + text_of(restitution),
                             true, [=](Record& record) { slide(record, friction, restitution); }});
        suite.push_back({"friction 0 to 1e6", "spinning ball" + mu, true,
                         [=](Record& record) { rub(record, friction); }});
    }
    for (double friction : {0.0, 0.5, 1e6})
        for (double restitution : {0.0, 1.0})
            suite.push_back({"friction 0 to 1e6",
                             "pile of 27, friction " + text_of(friction) + ", restitution " +
                                 text_of(restitution),
                             false, [=](Record& record) {
                                 pile_up(record, {restitution, friction});
                             }});
    for (double restitution : {0.0, 0.5, 1.0}) {
        const std::string name = " bounces for 10 s, restitution " + text_of(restitution);
        suite.push_back({"restitution 0 and 1", "ball" + name, true,
                         [=](Record& record) { bounce(record, restitution, Sphere{0.5}); }});
        suite.push_back({"restitution 0 and 1", "cube" + name, true,
                         [=](Record& record) { bounce(record, restitution, cube(1)); }});
    }
    for (int n : {2, 3, 5})
        suite.push_back({"restitution 0 and 1", std::to_string(n) + " spheres in a row", true,
                         [n](Record& record) { cradle(record, n); }});
}

} // namespace rigor::stress
