// SPDX-License-Identifier: MIT
// Computes the states after a free flight: of one body, by the step of the integrator, or of all
// bodies of a world. Bodies that fly alone come first. Then all bodies on which springs, forces or
// drag act advance together, stage by stage, since the force of a spring depends on both its
// bodies. free_flight.hpp names the methods.
#include "rigid/motion/free_flight.hpp"

#include "formulas/rotation.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/motion/constant_wrench_step.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/naive_rotation.hpp"
#include "rigid/motion/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace rigor {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2;
// The largest number of substeps of a step. A body whose rotation needs more makes over 250
// rotations in a step, and no result is useful then. The limit bounds the run time. If springs,
// forces or drag need more substeps, `substeps_for_forces` throws.
constexpr double most_substeps = 1000;

using Turn = Quaternion (*)(const Quaternion& q, const Vector3d& omega, double time_step);

// Symplectic Euler, with a rotation by the new angular velocity.
RigidState euler_step(Integrator integrator, Turn turned, const RigidBody& body,
                      const RigidState& state, const Wrench& wrench, double h)
{
    RigidState next = state;
    next.velocity += h * body.inverse.inverse_mass * wrench.force;
    next.position += h * next.velocity;
    next.angular_momentum += h * wrench.torque;
    const Vector3d w = angular_velocity(integrator, body, next); // from the new L and the old q
    next.orientation = turned(state.orientation, w, h);
    return next;
}

RigidState one_step(Integrator integrator, const RigidBody& body, const RigidState& state,
                    const Wrench& wrench, double h)
{
    switch (integrator) {
    case Integrator::matrix: {
        BodyStages<MatrixScheme> stages{body, MatrixScheme::from(state), wrench};
        runge_kutta_4(std::span(&stages, 1), h, [] {});
        return MatrixScheme::to(stages.stage, state);
    }
    case Integrator::linear:
        return step_symplectic_euler(state, body.inverse, wrench, h);
    case Integrator::exponential:
        return euler_step(integrator, advance_exact, body, state, wrench, h);
    case Integrator::gram_schmidt:
        return euler_step(integrator, turned_by_gram_schmidt, body, state, wrench, h);
    case Integrator::euler_angles:
        return euler_step(integrator, turned_by_euler_angles, body, state, wrench, h);
    case Integrator::buss:
        return step_buss(state, body.inverse, wrench, h);
    case Integrator::runge_kutta:
        return constant_wrench_step(body, state, wrench, h);
    case Integrator::exact:
        return constant_wrench_step(body, state, wrench, h, FreeRotation::exact);
    }
    throw std::logic_error("an integrator without a step");
}

// The number of equal substeps that rotate the body by at most a quarter turn each, at most
// `most_substeps`. It is 1 for `matrix`, and for an isotropic body with any integrator but
// `linear`.
int substeps_for(Integrator integrator, const RigidBody& body, const RigidState& state, double h)
{
    if (integrator == Integrator::matrix) return 1;
    if (body.is_isotropic && integrator != Integrator::linear) return 1;
    // The bound |ω| ≤ |I⁻¹| |L| shows without computing ω that most bodies are slow enough. A NaN
    // counts as slow enough; later in the step, `require_finite` reports it.
    const double bound = body.inverse.inverse_inertia.norm() * state.angular_momentum.norm();
    if (!(bound * h > quarter_turn)) return 1;
    const double limit = max_time_step(angular_velocity(integrator, body, state));
    if (!(limit > 0))
        throw std::domain_error("max_time_step returned " + std::to_string(limit) + " for body '" +
                                body.name + "': expected a time > 0");
    return static_cast<int>(std::clamp(std::ceil(h / limit), 1.0, most_substeps));
}

// The least number of equal substeps for which `fastest_force_rate` times the length of a substep
// is at most 0.5. It is 1 if the integrator under forces is not `runge_kutta`. At 0.5, the
// splitting method (`fly_by_splitting`) has an error of at most 2e-4 of the amplitude after 30
// oscillations of a spring. If a spring has damping or drag acts on a body, Runge–Kutta 4 replaces
// the splitting method. Its error is at most 4e-3 at a twentieth of the critical damping, and up to
// 0.1 if the damping is very weak.
// @throws std::domain_error if more than `most_substeps` are needed
int substeps_for_forces(const World& world, double h)
{
    const bool any_drags = std::any_of(world.bodies.begin(), world.bodies.end(),
                                       [](const RigidBody& body) { return body.drag.acts(); });
    if (world.springs.empty() && world.forces.empty() && !any_drags) return 1;
    if (world.settings.integrator_under_forces() != Integrator::runge_kutta) return 1;
    constexpr double most_change = 0.5; // rate times substep, [rad] for an oscillation
    const auto [rate, body] = fastest_force_rate(world);
    const double needed = std::ceil(rate * h / most_change);
    if (needed > most_substeps) {
        std::ostringstream text;
        text << "body '" << world.bodies[body].name
             << "': a spring or damper is too stiff, or a force or the drag too fast, for the "
                "step: expected their rate times the step up to "
             << most_substeps * most_change << ", found " << std::setprecision(4) << rate * h
             << "; a shorter step, a softer spring or a heavier body helps";
        throw std::domain_error(text.str());
    }
    return needed > 1 ? static_cast<int>(needed) : 1;
}

// Normalizes the quaternion, since rounding errors of many rotations add up. The integrators
// `matrix` and `linear` normalize it themselves.
RigidState with_unit_orientation(Integrator integrator, RigidState state)
{
    if (integrator != Integrator::matrix && integrator != Integrator::linear)
        state.orientation = normalize(state.orientation);
    return state;
}

int count_substeps(int n, Counters& counters)
{
    if (n > 1) counters.substeps += n;
    return n;
}

// The start and the middle of a substep [s]. An applied force acts during the whole substep if it
// acts at the middle; otherwise it does not act in this substep.
struct StepTimes {
    double start = 0, middle = 0;
};

// Runge–Kutta 4 for the bodies in `together`, whose forces depend on each other at every stage.
template <class Scheme>
void fly_by_runge_kutta(const World& world, AppliedWrenches& wrenches,
                        std::span<const int> together, std::vector<RigidState>& states, double h,
                        const StepTimes& times)
{
    std::vector<BodyStages<Scheme>> bodies;
    bodies.reserve(together.size());
    for (int i : together)
        bodies.push_back({world.bodies[i], Scheme::from(states[i]), Wrench()});
    const double stages[] = {times.start, times.start + h / 2, times.start + h / 2,
                             times.start + h};
    const double* now = stages;
    runge_kutta_4(std::span(bodies), h, [&] {
        for (std::size_t k = 0; k < together.size(); ++k)
            states[together[k]] = Scheme::to(bodies[k].stage, states[together[k]]);
        const std::vector<Wrench>& net = wrenches.at(states, times.middle, *now++);
        for (std::size_t k = 0; k < together.size(); ++k)
            bodies[k].wrench = net[k];
    });
    for (std::size_t k = 0; k < together.size(); ++k)
        states[together[k]] = Scheme::to(bodies[k].stage, states[together[k]]);
}

// The splitting method of Blanes and Moan (2002), in which impulses (kicks) and free flights
// alternate; see free_flight.hpp. The coefficients are fractions of the substep h.
void fly_by_splitting(const World& world, AppliedWrenches& wrenches, std::span<const int> together,
                      std::vector<RigidState>& states, double h, const StepTimes& times)
{
    constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
    constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080;
    constexpr double a3 = 0.5 - (a1 + a2), b4 = 1 - 2 * (b1 + b2 + b3);
    constexpr double kicks[] = {b1, b2, b3, b4, b3, b2, b1};
    constexpr double flights[] = {a1, a2, a3, a3, a2, a1};
    double now = times.start;
    for (std::size_t s = 0; s < std::size(kicks); ++s) {
        const std::vector<Wrench>& net = wrenches.at(states, times.middle, now);
        if (s < std::size(flights)) now += flights[s] * h;
        for (std::size_t k = 0; k < together.size(); ++k) {
            const RigidBody& body = world.bodies[together[k]];
            RigidState& state = states[together[k]];
            state.velocity += kicks[s] * h * body.inverse.inverse_mass * net[k].force;
            state.angular_momentum += kicks[s] * h * net[k].torque;
            if (s < std::size(flights))
                state = constant_wrench_step(body, state, Wrench(), flights[s] * h);
        }
    }
}

void fly_pulled(const World& world, AppliedWrenches& wrenches, std::span<const int> together,
                std::vector<RigidState>& states, double h, const StepTimes& times)
{
    const Integrator integrator = world.settings.integrator_under_forces();
    if (integrator == Integrator::matrix)
        return fly_by_runge_kutta<MatrixScheme>(world, wrenches, together, states, h, times);
    if (integrator == Integrator::runge_kutta && wrenches.depends_on_velocities())
        return fly_by_runge_kutta<LieScheme>(world, wrenches, together, states, h, times);
    if (integrator == Integrator::runge_kutta)
        return fly_by_splitting(world, wrenches, together, states, h, times);
    const std::vector<Wrench>& net = wrenches.at(states, times.middle, times.middle);
    for (std::size_t k = 0; k < together.size(); ++k) {
        const int i = together[k];
        states[i] = one_step(integrator, world.bodies[i], states[i], net[k], h);
    }
}

} // namespace

RigidState fly(const Settings& settings, const RigidBody& body, RigidState state, double time_step,
               Counters& counters, Gravity gravity)
{
    const Integrator integrator =
        gravity == Gravity::acts ? settings.integrator : settings.integrator_under_forces();
    const bool is_exact = integrator == Integrator::exact ||
                          (integrator == Integrator::runge_kutta && body.is_body_of_revolution());
    const int n =
        is_exact ? 1 : count_substeps(substeps_for(integrator, body, state, time_step), counters);
    if (body.is_isotropic) ++counters.isotropic_shortcuts;
    for (int i = 0; i < n; ++i) {
        const Wrench wrench =
            gravity == Gravity::acts ? gravity_on(settings, body, state.position) : Wrench();
        state = one_step(integrator, body, state, wrench, time_step / n);
    }
    return with_unit_orientation(integrator, state);
}

double fall_in_step(Integrator integrator)
{
    switch (integrator) {
    case Integrator::linear:
    case Integrator::exponential:
    case Integrator::gram_schmidt:
    case Integrator::euler_angles:
        return 1;
    case Integrator::matrix:
    case Integrator::buss:
    case Integrator::runge_kutta:
    case Integrator::exact:
        return 0.5;
    }
    throw std::logic_error("an integrator without a step");
}

std::vector<RigidState> fly_all(World& world, const std::vector<bool>& pulled, double time_step,
                                ThreadPool& pool, std::span<const Wrench> supports)
{
    Counters& counters = world.counters;
    std::vector<RigidState> states(world.bodies.size());
    std::vector<int> together;
    int n = substeps_for_forces(world, time_step);
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const RigidBody& body = world.bodies[i];
        if (body.is_static && !body.changes_place()) ++counters.static_skipped;
        if (body.rest.is_asleep()) ++counters.bodies_asleep;
        if (!pulled[i] || body.is_still()) continue;
        together.push_back(static_cast<int>(i));
        n = std::max(
            n, substeps_for(world.settings.integrator_under_forces(), body, body.state, time_step));
        if (body.is_isotropic) ++counters.isotropic_shortcuts;
    }
    fly_in_parallel(
        pool, states.size(), counters, [&](std::size_t first, std::size_t last, Counters& counted) {
            for (std::size_t i = first; i < last; ++i) {
                const RigidBody& body = world.bodies[i];
                if (body.changes_place())
                    states[i] = driven_state(*body.drive, world.time + time_step);
                else if (body.is_still() || pulled[i])
                    states[i] = body.state;
                else
                    states[i] = fly(world.settings, body, body.state, time_step, counted);
            }
        });
    if (together.empty()) return states;

    count_substeps(n, counters);
    const double h = time_step / n;
    AppliedWrenches wrenches(world, together, supports);
    for (int k = 0; k < n; ++k)
        fly_pulled(world, wrenches, together, states, h,
                   {world.time + k * h, world.time + (k + 0.5) * h});
    for (int i : together)
        states[i] = with_unit_orientation(world.settings.integrator_under_forces(), states[i]);
    return states;
}

bool computes_forces_in_stages(Integrator integrator)
{
    return integrator == Integrator::runge_kutta || integrator == Integrator::matrix;
}

} // namespace rigor
