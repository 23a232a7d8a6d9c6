// SPDX-License-Identifier: MIT
#include "rigid/contact_problem.hpp"

#include "formulas/collision.hpp"
#include "rigid/blocks.hpp"
#include "rigid/flight.hpp"
#include "rigid/groups.hpp"
#include "rigid/optimised_forms.hpp"
#include "rigid/warm_start.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rigor {

namespace {

Body body_in_world(Integrator integrator, const RigidBody& rigid)
{
    const RigidState& s = rigid.state;
    Body body;
    body.position = s.position;
    if (rigid.is_static) return body;
    body.inverse_mass = rigid.inverse.inverse_mass;
    body.inverse_inertia = inverse_inertia(integrator, rigid, s);
    body.velocity = s.velocity;
    body.angular_momentum = s.angular_momentum;
    body.angular_velocity = body.inverse_inertia * s.angular_momentum;
    return body;
}

// The body as it would be after the step's forces, still at its place.
Body pushed(Body body, const RigidState& start, const RigidState& flown)
{
    if (body.is_static()) return body;
    const Vector3d dL = flown.angular_momentum - start.angular_momentum;
    body.velocity += flown.velocity - start.velocity;
    body.angular_momentum += dL;
    body.angular_velocity += body.inverse_inertia * dL;
    return body;
}

// Where a contact comes among others: from the lowest up, in an order that does not depend on how the bodies
// are numbered.
std::tuple<double, double, double> place(const SolvedContact& c)
{
    return {c.height, c.point.x(), c.point.z()};
}

// Contacts of the same two bodies, one after the other.
std::vector<ContactPair> pairs_of(const std::vector<SolvedContact>& contacts)
{
    std::vector<ContactPair> pairs;
    for (int first = 0, last = 0, n = static_cast<int>(contacts.size()); first < n; first = last) {
        while (last < n && contacts[last].body1 == contacts[first].body1 &&
               contacts[last].body2 == contacts[first].body2)
            ++last;
        pairs.push_back({first, last});
    }
    return pairs;
}

// Pairs from the lowest up, and so the contacts of each.
void sort(std::vector<ContactPair>& pairs, std::vector<SolvedContact>& contacts, Team& team)
{
    constexpr std::size_t worth_sharing = 256; // pairs
    team.share_stretches(pairs.size(), worth_sharing, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            std::sort(
                contacts.begin() + pairs[k].first, contacts.begin() + pairs[k].last,
                [](const SolvedContact& a, const SolvedContact& b) { return place(a) < place(b); });
    });
    std::stable_sort(pairs.begin(), pairs.end(), [&](const ContactPair& a, const ContactPair& b) {
        return place(contacts[a.first]) < place(contacts[b.first]);
    });
}

int moving_of(const World& world, const Contact& c)
{
    return world.bodies[c.body1].is_static ? c.body2 : c.body1;
}

std::vector<Island> islands_of(const World& world, const ContactProblem& problem,
                               const std::vector<ContactPair>& pairs)
{
    Groups groups(world.bodies.size());
    for (const SolvedContact& c : problem.contacts)
        if (!world.bodies[c.body1].is_static && !world.bodies[c.body2].is_static)
            groups.join(c.body1, c.body2);
    if (!world.skips.islands) // all in one
        for (const SolvedContact& c : problem.contacts)
            for (int i : {c.body1, c.body2})
                if (!world.bodies[i].is_static)
                    groups.join(moving_of(world, problem.contacts[0]), i);

    std::vector<int> island_of(world.bodies.size(), -1);
    std::vector<bool> is_active;
    std::vector<Island> islands;
    for (const ContactPair& pair : pairs) {
        const SolvedContact& first = problem.contacts[pair.first];
        int& island = island_of[groups.of(moving_of(world, first))];
        if (island < 0) {
            island = static_cast<int>(islands.size());
            islands.emplace_back();
            is_active.push_back(false);
        }
        islands[island].pairs.push_back(pair);
        for (int i = pair.first; i < pair.last; ++i) {
            const SolvedContact& c = problem.contacts[i];
            if (problem.predicted_gap(c, c.free_speed) < 0) is_active[island] = true;
        }
    }
    for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
        if (const int island = island_of[groups.of(i)]; island >= 0 && !world.bodies[i].is_static)
            islands[island].bodies.push_back(i);

    std::vector<Island> active;
    for (std::size_t i = 0; i < islands.size(); ++i)
        if (is_active[i]) active.push_back(std::move(islands[i]));
    return active;
}

} // namespace

bool is_heap(const Island& island)
{
    constexpr std::size_t few_bodies = 8, many_bodies = 256;
    const std::size_t bodies = island.bodies.size(), pairs = island.pairs.size();
    return bodies > few_bodies && (bodies > many_bodies || 4 * pairs > 5 * bodies + 8);
}

Vector3d ContactProblem::up() const
{
    const double g = gravity.norm();
    return g > 0 ? Vector3d(-gravity / g) : Vector3d::UnitY();
}

Vector3d ContactProblem::velocity_at(const SolvedContact& c, const Vector3d& x) const
{
    return velocity_between(bodies, c, x);
}

Vector3d ContactProblem::velocity_between(const std::vector<Body>& states, const Contact& c,
                                          const Vector3d& x) const
{
    const Body &body1 = states[c.body1], &body2 = states[c.body2];
    if (optimised) return optimised::relative_velocity(body1, body2, x);
    return relative_velocity(body1, body2, x);
}

Matrix3d ContactProblem::impulse_matrix_at(const SolvedContact& c, const Vector3d& x) const
{
    Matrix3d K = Matrix3d::Zero();
    for (int i : {c.body1, c.body2}) {
        const Body& body = bodies[i];
        if (body.is_static()) continue;
        K += optimised ? optimised::impulse_matrix(body, x)
                       : impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);
    }
    return K;
}

void ContactProblem::apply(const SolvedContact& c, const Vector3d& x, const Vector3d& j)
{
    Body &body1 = bodies[c.body1], &body2 = bodies[c.body2];
    if (optimised) {
        optimised::apply_impulse(body1, x, j);
        optimised::apply_impulse(body2, x, -j);
        return;
    }
    if (!body1.is_static()) body1 = apply_impulse(body1, x, j);
    if (!body2.is_static()) body2 = apply_impulse(body2, x, -j);
}

namespace {

// The bodies that have contacts, as they are and as the step's forces would leave them.
void take_bodies(const World& world, std::span<const RigidState> flown,
                 std::span<const Contact> contacts, ContactProblem& problem,
                 std::vector<Body>& after_forces)
{
    std::vector<char> touches(world.bodies.size(), false);
    for (const Contact& contact : contacts)
        touches[contact.body1] = touches[contact.body2] = true;
    std::vector<int> touching;
    for (int i = 0; i < static_cast<int>(touches.size()); ++i)
        if (touches[i]) touching.push_back(i);
    problem.bodies.resize(world.bodies.size());
    after_forces.resize(world.bodies.size());
    constexpr std::size_t worth_sharing = 64; // bodies
    problem.team->share_stretches(
        touching.size(), worth_sharing, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                const int i = touching[k];
                problem.bodies[i] = body_in_world(world.integrator, world.bodies[i]);
                after_forces[i] = pushed(problem.bodies[i], world.bodies[i].state, flown[i]);
            }
        });
}

// What makes a contact one that is solved.
struct Filter {
    const World& world;
    const ContactProblem& problem;
    std::span<const double> margins;
    const std::vector<double>& radii;
    const std::vector<Body>& after_forces;

    // Appends it if it may close.
    void take(const Contact& contact, const Vector3d& up, std::vector<SolvedContact>& taken) const
    {
        const Vector3d &n = contact.normal, &x = contact.point;
        const double free_speed = problem.velocity_between(after_forces, contact, x).dot(n);
        const double margin = margins[contact.body1] + margins[contact.body2];
        if (contact.gap + problem.time_step * free_speed >= margin) return;

        SolvedContact& c = taken.emplace_back(SolvedContact{contact});
        c.free_speed = free_speed;
        c.force_speed = free_speed - problem.velocity_at(c, x).dot(n);
        c.height = up.dot(x);
        const Material &a = world.bodies[c.body1].material, &b = world.bodies[c.body2].material;
        c.restitution = std::min(a.restitution, b.restitution);
        c.friction = std::sqrt(a.friction * b.friction);
        const double r1 = radii[c.body1], r2 = radii[c.body2];
        c.radius = r1 > 0 && r2 > 0 ? std::min(r1, r2) : std::max(r1, r2);
    }
};

// In stretches, put together again in their order.
void take_contacts(const Filter& filter, std::span<const Contact> contacts, ContactProblem& problem)
{
    constexpr std::size_t worth_sharing = 256; // contacts
    const int stretches = problem.team->stretches_of(contacts.size(), worth_sharing);
    const Vector3d up = problem.up();
    std::vector<std::vector<SolvedContact>> taken(stretches);
    problem.team->share(stretches, [&](int k) {
        const auto [first, last] = Team::stretch(contacts.size(), stretches, k);
        taken[k].reserve(last - first);
        for (std::size_t i = first; i < last; ++i)
            filter.take(contacts[i], up, taken[k]);
    });
    if (stretches == 1) problem.contacts = std::move(taken[0]);
    for (const std::vector<SolvedContact>& part : taken)
        problem.contacts.insert(problem.contacts.end(), part.begin(), part.end());
}

void set_impulse_matrices(ContactProblem& problem, const Island& island)
{
    constexpr std::size_t worth_sharing = 64; // pairs
    problem.team->share_stretches(
        island.pairs.size(), worth_sharing, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k)
                for (int i = island.pairs[k].first; i < island.pairs[k].last; ++i) {
                    SolvedContact& c = problem.contacts[i];
                    c.K = problem.impulse_matrix_at(c, c.point);
                    c.normal_K = c.normal.dot(optimised::product(c.K, c.normal));
                }
        });
}

} // namespace

ContactProblem contact_problem(const World& world, std::span<const RigidState> flown,
                               std::span<const double> margins, const std::vector<double>& radii,
                               std::span<const Contact> contacts, double time_step,
                               Counters& counters, Team& team)
{
    ContactProblem problem;
    problem.time_step = time_step;
    problem.gravity = world.gravity;
    problem.method = world.contact_method;
    problem.skips = world.skips;
    problem.optimised = world.formulas_are_reference && world.skips.readable_formulas;
    problem.counters = &counters;
    problem.team = &team;
    std::vector<Body> after_forces;
    take_bodies(world, flown, contacts, problem, after_forces);
    take_contacts({world, problem, margins, radii, after_forces}, contacts, problem);

    std::vector<ContactPair> pairs = pairs_of(problem.contacts);
    const bool is_iterative =
        problem.method == ContactMethod::built_in || problem.method == ContactMethod::simultaneous;
    if (is_iterative && world.skips.warm_start)
        start_warm(world, time_step, pairs, problem.contacts, counters, team);
    sort(pairs, problem.contacts, team);
    problem.islands = islands_of(world, problem, pairs);
    for (Island& island : problem.islands) {
        set_impulse_matrices(problem, island);
        split_into_blocks(problem, island);
    }
    return problem;
}

} // namespace rigor
