// SPDX-License-Identifier: MIT
// A large and a small block on a plank, compared with the same motion computed without contacts.
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include "geometry/shapes/pose.hpp"

#include <cmath>
#include <numbers>

namespace rigor::stress {

namespace {

constexpr double until = 0.3; // [s]
constexpr double angle_error_limit = 0.02;

// The plank comes first. It balances on the edge of a box at the origin.
std::vector<RigidBody> loaded_plank()
{
    const Material sticky{0, 1};
    return {body_of(Box{{4, 0.1, 0.5}}, {0, 0.05, 0}, sticky, {}, 500),
            body_of(cube(0.5), {-1.5, 0.35, 0}, sticky, {}, 8000),
            body_of(cube(0.5), {1.5, 0.35, 0}, sticky, {}, 800)};
}

// The angle of the plank and its blocks as one rigid body about the origin: θ̈ = -g Σ m x(θ) / Σ (I
// + m r²), by Runge–Kutta 4 with steps so short that the error is negligible.
double angle_of_twin()
{
    const std::vector<RigidBody> bodies = loaded_plank();
    const auto acceleration = [&bodies](double angle) {
        double torque = 0, I = 0;
        for (const RigidBody& b : bodies) {
            const Vector3d& r = b.state.position;
            torque -= b.mass * g * (r.x() * std::cos(angle) - r.y() * std::sin(angle));
            I += b.inertia(2, 2) + b.mass * r.squaredNorm();
        }
        return torque / I;
    };
    constexpr int steps = 3000;
    const double h = until / steps;
    double angle = 0, speed = 0;
    for (int i = 0; i < steps; ++i) {
        const double a1 = acceleration(angle), a2 = acceleration(angle + h / 2 * speed),
                     a3 = acceleration(angle + h / 2 * speed + h * h / 4 * a1),
                     a4 = acceleration(angle + h * speed + h * h / 2 * a2);
        angle += h * speed + h * h / 6 * (a1 + a2 + a3);
        speed += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return angle;
}

double angle_with_contact(ContactMethod method, int steps, Record& record)
{
    std::vector<RigidBody> bodies = loaded_plank();
    const double edge = 0.5;
    bodies.push_back(fixed(cube(edge), {0, -edge / std::numbers::sqrt2, 0}, {0, 1},
                           turn({0, 0, 1}, std::numbers::pi / 4)));
    World world = world_of(std::move(bodies));
    world.settings.contact_method = method;
    const double scale = lifting_energy(world, edge);
    Watch watch(std::move(world), record, scale);
    watch.run(steps, until / steps);
    const Matrix3d R = rotation_matrix(watch.world().bodies[0].state.orientation);
    return std::atan2(R(1, 0), R(0, 0));
}

void balance(Record& record, ContactMethod method)
{
    const double exact = angle_of_twin();
    const double coarse = angle_with_contact(method, 36, record) / exact - 1,
                 fine = angle_with_contact(method, 72, record) / exact - 1;
    record.limit_drift("angle after 0.3 s against the twin's, h = 1/240", std::abs(fine),
                       angle_error_limit, 'O');
    record.limit("order of h below 1", 1 - std::log2(std::abs(coarse / fine)), 0.2, 'O');
    record.limit("penetration [m]", record.penetration, allowed_depth * 0.5, 'I');
    record.limit("energy gained", record.energy_gain, allowed_depth, 'I');
}

} // namespace

void add_seesaw(Suite& suite)
{
    const std::pair<const char*, ContactMethod> methods[] = {
        {"simultaneous", ContactMethod::simultaneous},
        {"shock_propagation", ContactMethod::shock_propagation},
        {"built_in", ContactMethod::built_in}};
    for (const auto& [name, method] : methods)
        suite.push_back({"seesaw against its twin without contact", name, true,
                         [kind = method](Record& record) { balance(record, kind); }});
}

} // namespace rigor::stress
