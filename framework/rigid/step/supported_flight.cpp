// SPDX-License-Identifier: MIT
// The fixed point of two steps: the flight under the forces and the impulses of the contacts, and
// the contact stage with the forces along this flight. See supported_flight.hpp.
#include "rigid/step/supported_flight.hpp"

#include "formulas/rotation.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/contact/resting_contact.hpp"
#include "rigid/detection/overlap_depth.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/midpoint/middle_of_step.hpp"
#include "rigid/step/velocity_update.hpp"

#include <algorithm>

namespace rigor {

namespace {

// The iteration ends when the loads change by less than `converged`, as a share of the loads. After
// two accelerated repetitions it also ends when they change by more than `slow` times the change
// before: then what is left are errors of the sweeps of the contact stage. Most scenes need one or
// two repetitions; strong dampers between light bodies need the most. Chosen by trial, with the
// springs between bodies on the ground in tests/classics.
constexpr double converged = 1e-8, slow = 0.5;
constexpr int most_repetitions = 8;

// The longest time step for which friction is computed, times the fastest rate of the forces
// (`fastest_force_rate`), for example the angular frequency of a spring. A block on a rough floor
// that a spring pulls loses energy with 2.8, as it should, but gains energy with 3.5.
constexpr double longest_step = 2;

template <class Visit>
void for_each_contact(ContactProblem& problem, const std::vector<const Island*>& islands,
                      const Visit& visit)
{
    for (const Island* island : islands)
        for (const ContactPair& pair : island->pairs)
            for (int i = pair.first; i < pair.last; ++i)
                visit(problem.contacts[i]);
}

std::vector<const Island*> supported_islands(ContactProblem& problem,
                                             const std::vector<bool>& pulled)
{
    std::vector<const Island*> islands;
    for (const Island& island : problem.islands) {
        const bool is_pulled = std::any_of(island.bodies.begin(), island.bodies.end(),
                                           [&](int i) { return pulled[i]; });
        if (!is_pulled || island.bodies.size() > most_refined) continue;
        bool holds = false, is_hit = false;
        for_each_contact(problem, {&island}, [&](const ContactConstraint& c) {
            holds |= problem.holds(c);
            is_hit |= !c.collision_impulse.isZero(0);
        });
        if (holds && !is_hit) islands.push_back(&island);
    }
    return islands;
}

// The loads of bodies: for each of them six entries, the sum of its contact impulses and the sum of
// their moments about its center of mass. How several contacts share a load is often undetermined,
// so the impulses themselves need not converge. The entries are multiplied by the square roots of
// 1/M and |I⁻¹|, so that their squares are energies.
class Loads {
public:
    Loads(const ContactProblem& problem, const std::vector<const Island*>& islands)
        : place_(problem.bodies.size(), -1)
    {
        for (const Island* island : islands)
            for (int i : island->bodies) {
                const Body& body = problem.bodies[i];
                place_[i] = 6 * static_cast<Eigen::Index>(weights_.size());
                weights_.emplace_back(std::sqrt(body.inverse_mass),
                                      std::sqrt(body.inverse_inertia.norm()));
            }
    }

    // The loads by the contact stage.
    Eigen::VectorXd of(ContactProblem& problem, const std::vector<const Island*>& islands) const
    {
        Eigen::VectorXd loads = Eigen::VectorXd::Zero(6 * std::ssize(weights_));
        for_each_contact(problem, islands, [&](const ContactConstraint& c) {
            const Vector3d& j = c.contact_impulse;
            for (const auto& [i, sign] : {std::pair(c.body1, 1.), std::pair(c.body2, -1.)}) {
                if (place_[i] < 0) continue;
                const auto [linear, angular] = weights_[place_[i] / 6];
                const Vector3d r = c.point - problem.bodies[i].position;
                loads.segment<3>(place_[i]) += sign * linear * j;
                loads.segment<3>(place_[i] + 3) += sign * angular * r.cross(j);
            }
        });
        return loads;
    }

    // For each body of the world, the constant wrench that gives its load in a step of length h.
    std::vector<Wrench> wrenches(const Eigen::VectorXd& loads, double h) const
    {
        std::vector<Wrench> wrenches(place_.size());
        for (std::size_t i = 0; i < place_.size(); ++i) {
            if (place_[i] < 0) continue;
            const auto [linear, angular] = weights_[place_[i] / 6];
            if (linear > 0) wrenches[i].force = loads.segment<3>(place_[i]) / (linear * h);
            if (angular > 0) wrenches[i].torque = loads.segment<3>(place_[i] + 3) / (angular * h);
        }
        return wrenches;
    }

private:
    std::vector<Eigen::Index> place_; // for each body of the world: where its load stands, or -1
    std::vector<std::pair<double, double>> weights_;
};

// Removes from the displacements what would move bodies at the contacts that hold them: along the
// normal, and where a contact sticks also along the surface. The velocities of `bodies` are the
// displacements. The method is Gauss–Seidel.
void project(ContactProblem& problem, const std::vector<const Island*>& islands,
             std::vector<Body>& bodies)
{
    constexpr int most_sweeps = 50;
    constexpr double rounding = 1e-12; // relative to the first displacements
    double first = 0;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double largest = 0;
        for_each_contact(problem, islands, [&](const ContactConstraint& c) {
            if (!problem.holds(c)) return;
            Vector3d u = problem.velocity_between(bodies, c, c.point);
            if (slides(c)) u = u.dot(c.normal) * c.normal;
            largest = std::max(largest, u.norm());
            const Vector3d p =
                slides(c) ? Vector3d(u / -c.normal_K) : Vector3d(c.K.ldlt().solve(-u));
            problem.push(bodies[c.body1], c.point, p);
            problem.push(bodies[c.body2], c.point, -p);
        });
        if (sweep == 0) first = largest;
        if (largest <= rounding * first) return;
    }
}

std::vector<Displacement> bends_of(const World& world, ContactProblem& problem,
                                   const std::vector<const Island*>& islands,
                                   const std::vector<RigidState>& flown)
{
    std::vector<bool> is_held(problem.bodies.size(), false);
    for_each_contact(problem, islands, [&](const ContactConstraint& c) {
        if (problem.holds(c)) is_held[c.body1] = is_held[c.body2] = true;
    });
    std::vector<Body> moved = problem.bodies; // with the displacements as velocities
    for (Body& body : moved)
        body.velocity = body.angular_velocity = body.angular_momentum = Vector3d::Zero();
    Counters uncounted;
    for (const Island* island : islands)
        for (int i : island->bodies) {
            if (!is_held[i]) continue; // `flown` is its final state
            const RigidState &start = world.bodies[i].state, &end = flown[i];
            RigidState mean = start;
            mean.velocity = (start.velocity + end.velocity) / 2;
            mean.angular_momentum = (start.angular_momentum + end.angular_momentum) / 2;
            mean = fly(world.settings, world.bodies[i], mean, problem.time_step, uncounted,
                       Gravity::left_out);
            const Displacement bend = displacement_between(mean, end);
            moved[i].velocity = bend.shift;
            moved[i].angular_velocity = bend.turn;
        }
    project(problem, islands, moved);
    std::vector<Displacement> bends(moved.size());
    for (std::size_t i = 0; i < moved.size(); ++i)
        if (is_held[i] && !moved[i].is_static())
            bends[i] = {moved[i].velocity, moved[i].angular_velocity};
    return bends;
}

} // namespace

Displacement displacement_between(const RigidState& a, const RigidState& b)
{
    Quaternion turn = multiply(b.orientation, conjugate(a.orientation));
    if (turn.s < 0) turn = {-turn.s, -turn.v};
    const double sine = turn.v.norm();
    const double angle = 2 * std::atan2(sine, turn.s);
    return {b.position - a.position, sine > 0 ? Vector3d(angle / sine * turn.v) : 2 * turn.v};
}

bool is_too_long_for_friction(const World& world, ContactProblem& problem,
                              const std::vector<bool>& pulled)
{
    bool has_friction = false;
    for_each_contact(problem, supported_islands(problem, pulled), [&](const ContactConstraint& c) {
        has_friction |= c.friction > 0 && problem.holds(c);
    });
    return has_friction && problem.time_step * fastest_force_rate(world).rate > longest_step;
}

std::optional<SupportedFlight> fly_supported(World& world, ContactProblem& problem,
                                             const std::vector<Body>& before_forces,
                                             const std::vector<bool>& pulled,
                                             const std::vector<RigidState>& flown)
{
    if (!computes_forces_in_stages(world.settings.integrator_under_forces())) return std::nullopt;
    if (std::none_of(pulled.begin(), pulled.end(), [](bool is_pulled) { return is_pulled; }))
        return std::nullopt;
    const std::vector<const Island*> islands = supported_islands(problem, pulled);
    if (islands.empty() || problem.time_step == 0) return std::nullopt;
    std::vector<bool> pulled_or_held = pulled;
    for (const Island* island : islands)
        for (int i : island->bodies)
            pulled_or_held[i] = true;

    const double h = problem.time_step;
    const Counters before = world.counters; // repetitions do not count
    SupportedFlight flight{flown, flown, {}};
    const Loads loads(problem, islands);
    Eigen::VectorXd taken = loads.of(problem, islands); // those of the flight
    Eigen::VectorXd last_found, last_residual;
    for (int repetition = 0; repetition < most_repetitions; ++repetition) {
        const std::vector<Wrench> supports = loads.wrenches(taken, h);
        flight.flown = flight.forced = fly_all(world, pulled_or_held, h, *problem.pool, supports);
        for (const Island* island : islands) {
            for (int i : island->bodies) {
                flight.forced[i].velocity -= h * problem.bodies[i].inverse_mass * supports[i].force;
                flight.forced[i].angular_momentum -= h * supports[i].torque;
            }
            apply_forces(world, *island, before_forces, flight.forced, problem);
        }
        for_each_contact(problem, islands,
                         [](ContactConstraint& c) { c.contact_impulse.setZero(); });
        for (const Island* island : islands)
            process_contact(problem, *island, before_forces);

        const Eigen::VectorXd found = loads.of(problem, islands), residual = found - taken;
        if (residual.norm() <= converged * found.norm()) break;
        if (repetition > 2 && residual.norm() > slow * last_residual.norm()) break;
        taken = found;
        if (last_residual.size() > 0) {
            const Eigen::VectorXd change = residual - last_residual;
            if (change.squaredNorm() > 0)
                taken -= residual.dot(change) / change.squaredNorm() * (found - last_found);
        }
        last_found = found;
        last_residual = residual;
    }
    flight.bends = bends_of(world, problem, islands, flight.flown);
    world.counters = before;
    return flight;
}

} // namespace rigor
