// SPDX-License-Identifier: MIT
// A million steps of spinning, and inertias at the limits of what a body can have.
#include "rigid/bodies/mass.hpp"
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::stress {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

RigidBody free_body(const Vector3d& moments, const Vector3d& angular_velocity)
{
    RigidBody body = body_of(Sphere{0.1}, {0, 0, 0});
    set_mass(body, 12, moments.asDiagonal().toDenseMatrix());
    spin(body, angular_velocity);
    return body;
}

double length_error(const Quaternion& q)
{
    return std::abs(std::sqrt(q.s * q.s + q.v.squaredNorm()) - 1);
}

// Long spins: |q| = 1 after every step, and L never changes.
void spin_long(Record& record, Integrator integrator, int steps, const Vector3d& moments,
               const Vector3d& angular_velocity)
{
    World world = world_of({free_body(moments, angular_velocity)}, {0, 0, 0});
    world.settings.integrator = integrator;
    Watch watch(std::move(world), record, 0);
    double worst = 0;
    watch.run(steps, 0.01, steps, [&] {
        worst = std::max(worst, length_error(watch.world().bodies[0].state.orientation));
    });
    const Vector3d L = watch.start().bodies[0].state.angular_momentum,
                   L_end = watch.world().bodies[0].state.angular_momentum;
    record.limit_drift("||q| - 1|", worst, 4 * eps, 'R');
    record.limit("change of L / |L|", (L_end - L).norm() / L.norm(), 4 * eps, 'R');
}

void add_spins(Suite& suite)
{
    const std::pair<const char*, Integrator> integrators[] = {
        {"runge_kutta", Integrator::runge_kutta},
        {"matrix", Integrator::matrix},
        {"buss", Integrator::buss},
        {"exponential", Integrator::exponential},
        {"linear", Integrator::linear},
        {"exact", Integrator::exact}};
    for (const auto& [name, integrator] : integrators) {
        suite.push_back({"1e6 steps of a spin", std::string("box 1 x 2 x 3, ") + name, false,
                         [kind = integrator](Record& record) {
                             spin_long(record, kind, 1'000'000, {13, 10, 5}, {1, 2, 3});
                         }});
        suite.push_back({"1e6 steps of a spin", std::string("the same, 1e4 steps, ") + name, true,
                         [kind = integrator](Record& record) {
                             spin_long(record, kind, 10'000, {13, 10, 5}, {1, 2, 3});
                         }});
    }
    suite.push_back(
        {"1e6 steps of a spin", "sphere, 1 rad a step", false, [](Record& record) {
             spin_long(record, Integrator::runge_kutta, 1'000'000, {2, 2, 2}, {0, 60, 80});
         }});
}

// Free rotation of a body with a physically possible inertia (no moment above the sum of the
// others). L does not change. For any time step, the energy lies between L²/2I of the largest and
// that of the smallest moment. If the n steps resolve the spin, it changes only by the error of a
// fourth-order method, n (|ω|h)⁵; if not, it must not grow without bound.
void tumble(Record& record, const Vector3d& moments, const Vector3d& angular_velocity)
{
    constexpr int steps = 1000;
    Watch watch(world_of({free_body(moments, angular_velocity)}, {0, 0, 0}), record, 0);
    double least = kinetic_energy(watch.start()), most = least;
    const double start = least;
    watch.run(steps, frame, steps, [&] {
        least = std::min(least, kinetic_energy(watch.world()));
        most = std::max(most, kinetic_energy(watch.world()));
    });
    const RigidState &before = watch.start().bodies[0].state,
                     &after = watch.world().bodies[0].state;
    const Vector3d L = before.angular_momentum;
    record.limit("change of L / |L|", (after.angular_momentum - L).norm() / L.norm(), 4 * eps, 'R');
    record.limit("||q| - 1|", length_error(after.orientation), 4 * eps, 'R');
    const double turned = angular_velocity.norm() * frame,
                 change = std::max(most - start, start - least) / start;
    if (turned < 0.1)
        record.limit_drift("change of energy", change, steps * std::pow(turned, 5), 'O');
    else
        record.limit_drift("change of energy, which must not double", change, 1, 'I');
    if (moments.minCoeff() > 0)
        record.limit("energy over L²/2I of the least moment",
                     most / (L.squaredNorm() / (2 * moments.minCoeff())) - 1, 64 * steps * eps,
                     'I');
    record.limit("L²/2I of the largest moment over the energy",
                 (L.squaredNorm() / (2 * moments.maxCoeff())) / least - 1, 64 * steps * eps, 'I');
}

// A body falls on the ground in a tilted pose and has to come to rest there.
void drop(Record& record, const Shape& shape, double thickness, const Vector3d* moments)
{
    RigidBody body = body_of(shape, {0, 1, 0}, rough, turn({1, 2, 3}, 0.4));
    if (moments) set_mass(body, 1, moments->asDiagonal().toDenseMatrix());
    World world = world_of({ground(), body});
    const double scale = lifting_energy(world, thickness);
    Watch watch(std::move(world), record, scale);
    watch.run(600, frame);
    watch.limit_penetration(standing * thickness);
    watch.limit_energy(standing);
    record.limit_drift("speed after 10 s [m/s]", watch.world().bodies[1].state.velocity.norm(),
                       g * frame, 'I');
}

void add_inertias(Suite& suite)
{
    const auto add = [&suite](const std::string& name, const Vector3d& I, const Vector3d& w) {
        suite.push_back({"inertia ratios, rods, points", name, true,
                         [I, w](Record& record) { tumble(record, I, w); }});
    };
    for (double ratio : {1e2, 1e4, 1e6}) {
        const std::string name = "moments 1 : 1 : " + std::to_string(static_cast<int>(ratio));
        add(name, {ratio, ratio, 1}, {1, 1, 1});
        add(name + ", a fast spin", {ratio, ratio, 1}, {1, 1, 1000});
        add("moments 1 : 1 - 1/2r : 1/r, r = " + std::to_string(static_cast<int>(ratio)),
            {1, 1 - 0.5 / ratio, 1 / ratio}, {1, 2, 1});
    }
    add("rod without thickness: 1 : 1 : 0", {1, 1, 0}, {1, 2, 0});
    const auto fall = [&suite](const std::string& name, const Shape& shape, double thickness) {
        suite.push_back(
            {"inertia ratios, rods, points", name, true,
             [shape, thickness](Record& record) { drop(record, shape, thickness, nullptr); }});
    };
    fall("box 1 x 0.1 x 0.1 dropped", Box{{1, 0.1, 0.1}}, 0.1);
    fall("box 1 x 0.01 x 0.01 dropped", Box{{1, 0.01, 0.01}}, 0.01);
    fall("box 1 x 0.001 x 0.001 dropped", Box{{1, 0.001, 0.001}}, 0.001);
    suite.push_back({"inertia ratios, rods, points", "point mass in a sphere dropped", true,
                     [](Record& record) {
                         const Vector3d none(0, 0, 0);
                         drop(record, Sphere{0.1}, 0.2, &none);
                     }});
    suite.push_back(
        {"inertia ratios, rods, points", "thin rod in a box dropped", true, [](Record& record) {
             const Vector3d rod(0, 1.0 / 12, 1.0 / 12);
             drop(record, Box{{1, 0.1, 0.1}}, 0.1, &rod);
         }});
}

} // namespace

void add_spinning(Suite& suite)
{
    add_spins(suite);
    add_inertias(suite);
}

} // namespace rigor::stress
