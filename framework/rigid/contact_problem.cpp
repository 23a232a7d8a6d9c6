// SPDX-License-Identifier: MIT
#include "rigid/contact_problem.hpp"

#include "formulas/collision.hpp"
#include "rigid/blocks.hpp"
#include "rigid/flight.hpp"
#include "rigid/forces.hpp"
#include "rigid/islands.hpp"
#include "rigid/optimised_forms.hpp"
#include "rigid/warm_start.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

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

// The larger eigenvalue of K across n: of the two, the sum is tr K - nᵀKn and the sum of the squares
// |K|² - 2 |K n|² + (nᵀKn)².
double tangential_eigenvalue(const Matrix3d& K, const Vector3d& n)
{
    const Vector3d Kn = optimised::product(K, n);
    const double nKn = n.dot(Kn);
    const double sum = K.trace() - nKn;
    const double squares = K.squaredNorm() - 2 * Kn.squaredNorm() + nKn * nKn;
    return (sum + std::sqrt(std::max(0.0, 2 * squares - sum * sum))) / 2;
}

} // namespace

Vector3d ContactProblem::up() const
{
    return up_against(gravity);
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

void ContactProblem::set_impulse_matrix(SolvedContact& c) const
{
    c.K = impulse_matrix_at(c, c.point);
    c.normal_K = c.normal.dot(optimised::product(c.K, c.normal));
    c.tangential_K = tangential_eigenvalue(c.K, c.normal);
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
                 Joined<Body>& after_forces)
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
    const Neighbourhood& near;
    std::span<const Body> after_forces;

    // Appends it if it may close.
    void take(const Contact& contact, Joined<SolvedContact>& taken) const
    {
        const Vector3d &n = contact.normal, &x = contact.point;
        const double free_speed = problem.velocity_between(after_forces, contact, x).dot(n);
        const double margin = near.margins[contact.body1] + near.margins[contact.body2];
        if (contact.gap + problem.time_step * free_speed >= margin) return;

        SolvedContact& c = taken.emplace_back(SolvedContact{contact});
        c.free_speed = free_speed;
        c.force_speed = free_speed - problem.velocity_at(c, x).dot(n);
        const Material &a = world.bodies[c.body1].material, &b = world.bodies[c.body2].material;
        c.restitution = std::min(a.restitution, b.restitution);
        c.friction = std::sqrt(a.friction * b.friction);
        const double r1 = near.radii[c.body1], r2 = near.radii[c.body2];
        c.radius = r1 > 0 && r2 > 0 ? std::min(r1, r2) : std::max(r1, r2);
    }
};

void take_contacts(const Filter& filter, ContactProblem& problem)
{
    const std::vector<Contact>& contacts = filter.near.contacts;
    constexpr std::size_t worth_sharing = 256; // contacts
    problem.contacts = join(*problem.team, contacts.size(), worth_sharing,
                            [&](std::size_t first, std::size_t last) {
                                Joined<SolvedContact> taken;
                                taken.reserve(last - first);
                                for (std::size_t i = first; i < last; ++i)
                                    filter.take(contacts[i], taken);
                                return taken;
                            });
}

// Impulse matrices and, beside them, blocks.
void prepare(ContactProblem& problem, Island& island)
{
    constexpr std::size_t worth_sharing = 64; // pairs
    const std::span<const ContactPair> pairs = island.pairs;
    std::vector<ContactPair> replaced; // those of `pairs` until all are done
    problem.team->share_stretches_beside(
        [&] { replaced = split_into_blocks(problem, island); }, pairs.size(), worth_sharing,
        [&](std::size_t first, std::size_t last) {
            for (const ContactPair& pair : pairs.subspan(first, last - first))
                for (int i = pair.first; i < pair.last; ++i)
                    problem.set_impulse_matrix(problem.contacts[i]);
        });
}

} // namespace

ContactProblem contact_problem(const World& world, std::span<const RigidState> flown,
                               const Neighbourhood& near, double time_step, Counters& counters,
                               Team& team)
{
    ContactProblem problem;
    problem.time_step = time_step;
    problem.gravity = world.gravity;
    problem.method = world.contact_method;
    problem.skips = world.skips;
    problem.optimised = world.formulas_are_reference && world.skips.readable_formulas;
    problem.counters = &counters;
    problem.team = &team;
    Joined<Body> after_forces; // of those that have contacts
    take_bodies(world, flown, near.contacts, problem, after_forces);
    take_contacts({world, problem, near, after_forces}, problem);

    const std::vector<ContactPair> pairs = pairs_of(problem.contacts);
    const auto find_islands = [&] {
        std::vector<ContactPair> from_lowest = pairs;
        sort_from_lowest(problem, from_lowest);
        problem.islands = islands_of(world, problem, from_lowest);
    };
    const bool is_iterative =
        problem.method == ContactMethod::built_in || problem.method == ContactMethod::simultaneous;
    if (is_iterative && world.skips.warm_start) {
        constexpr std::size_t worth_sharing = 128; // pairs
        std::atomic<std::uint64_t> started = 0;
        team.share_stretches_beside(
            find_islands, pairs.size(), worth_sharing, [&](std::size_t first, std::size_t last) {
                started +=
                    start_warm(world, near.poses, time_step,
                               std::span(pairs).subspan(first, last - first), problem.contacts);
            });
        counters.warm_starts += started;
    } else {
        find_islands();
    }
    for (Island& island : problem.islands)
        prepare(problem, island);
    return problem;
}

} // namespace rigor
