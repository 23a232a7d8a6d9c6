// SPDX-License-Identifier: MIT
// A pile without gravity: momentum and angular momentum do not change, and kinetic energy never
// rises.
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <limits>

namespace rigor::stress {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Momenta {
    Vector3d P = Vector3d::Zero(), L = Vector3d::Zero();
    double scale_P = 0, scale_L = 0; // sums of the magnitudes of the terms
};

Momenta momenta(const World& world)
{
    Momenta sum;
    for (const RigidBody& body : world.bodies) {
        const RigidState& s = body.state;
        const Vector3d p = body.mass * s.velocity;
        sum.P += p;
        sum.L += s.position.cross(p) + s.angular_momentum;
        sum.scale_P += p.norm();
        sum.scale_L += s.position.norm() * p.norm() + s.angular_momentum.norm();
    }
    return sum;
}

// n³ bodies that drift towards each other, each with a random velocity and rotation.
World cloud(int n, bool spheres, const Material& material)
{
    testing::Random random(7);
    std::vector<RigidBody> bodies;
    for (int i = 0; i < n * n * n; ++i) {
        const Vector3d cell(i % n, i / n % n, i / n / n);
        const Vector3d X = 1.8 * (cell - Vector3d::Constant((n - 1) / 2.0));
        const Shape shape = spheres ? Shape(Sphere{0.5}) : Shape(cube(1));
        RigidBody body = body_of(shape, X, material, random.quaternion());
        body.state.velocity = -0.5 * X + random.vector();
        spin(body, random.vector());
        bodies.push_back(body);
    }
    return world_of(std::move(bodies), {0, 0, 0});
}

void drift_together(Record& record, World world, int steps)
{
    Watch watch(std::move(world), record, 0);
    const Momenta start = momenta(watch.start());
    const double start_energy = kinetic_energy(watch.start());
    double before = start_energy, rise = 0, change_P = 0, change_L = 0;
    watch.run(steps, frame, 20, [&] {
        const double energy = kinetic_energy(watch.world());
        rise = std::max(rise, (energy - before) / start_energy);
        before = energy;
        const Momenta now = momenta(watch.world());
        change_P = std::max(change_P, (now.P - start.P).norm() / start.scale_P);
        change_L = std::max(change_L, (now.L - start.L).norm() / start.scale_L);
    });
    record.limit_drift("change of momentum", change_P, 8 * steps * eps, 'I');
    record.limit("change of angular momentum", change_L, 8 * steps * eps, 'I');
    record.limit("rise of kinetic energy in a step", rise, 64 * eps, 'I');
}

} // namespace

void add_weightless(Suite& suite)
{
    for (double restitution : {0.0, 0.5, 1.0})
        for (double friction : {0.0, 0.5}) {
            char name[64];
            const Material material{restitution, friction};
            std::snprintf(name, sizeof name, "64 cubes, restitution %g, friction %g", restitution,
                          friction);
            suite.push_back({"pile without gravity", name, false, [=](Record& record) {
                                 drift_together(record, cloud(4, false, material), 300);
                             }});
            std::snprintf(name, sizeof name, "27 spheres, restitution %g, friction %g", restitution,
                          friction);
            suite.push_back({"pile without gravity", name, true, [=](Record& record) {
                                 drift_together(record, cloud(3, true, material), 300);
                             }});
        }
}

} // namespace rigor::stress
