// SPDX-License-Identifier: MIT
// Computes quantities that several stages of contact need: first those of islands, then the
// velocities and impulse matrices of contacts. Last comes the change of the velocities by an
// impulse.
#include "rigid/contact/contact_problem.hpp"

#include "rigid/bodies/height_order.hpp"
#include "rigid/bodies/inlined_product.hpp"
#include "rigid/bodies/optimised_forms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

// The larger eigenvalue of K in the tangent plane of n. The sum of the two eigenvalues there is
// tr K - nᵀKn, and the sum of their squares is |K|² - 2 |K n|² + (nᵀKn)².
double tangential_eigenvalue(const Matrix3d& K, const Vector3d& n)
{
    const Vector3d Kn = optimised::product(K, n);
    const double nKn = n.dot(Kn);
    const double sum = K.trace() - nKn;
    const double squares = K.squaredNorm() - 2 * Kn.squaredNorm() + nKn * nKn;
    return (sum + std::sqrt(std::max(0.0, 2 * squares - sum * sum))) / 2;
}

} // namespace

bool is_at_friction_limit(const ContactConstraint& c, const Vector3d& j)
{
    constexpr double rounding = 1e-9;
    const double j_n = j.dot(c.normal);
    return (j - j_n * c.normal).norm() >= (1 - rounding) * c.friction * j_n;
}

std::size_t contact_count(std::span<const ContactPair> pairs)
{
    return std::accumulate(
        pairs.begin(), pairs.end(), std::size_t{0},
        [](std::size_t sum, const ContactPair& pair) { return sum + pair.count(); });
}

bool is_pile(const Island& island)
{
    // A stack has about one pair of touching bodies for each body; a pile has more. An island of n
    // bodies is a pile if it has more than `pairs_of_a_body` n + `more_pairs` such pairs. An
    // island of at most `few_bodies` bodies never counts as a pile. An island of more than
    // `many_bodies` bodies always does, because Newton's method would be too expensive for it. The
    // values were chosen by trial: tests/stress has stacks, which must not count as piles, and
    // `bench pile` has a pile. With 1 or with 3 instead of 1.25 pairs for each body, a test of
    // tests/classics fails.
    constexpr std::size_t many_bodies = 256;
    constexpr double pairs_of_a_body = 1.25, more_pairs = 2;
    const std::size_t bodies = island.bodies.size();
    const double most_pairs = pairs_of_a_body * static_cast<double>(bodies) + more_pairs;
    return bodies > few_bodies &&
           (bodies > many_bodies || static_cast<double>(island.pairs.size()) > most_pairs);
}

double kinetic_energy_of(const Body& b, const Vector3d& V)
{
    const double m = 1 / b.inverse_mass;
    return (m * (b.velocity - V).squaredNorm() + b.angular_velocity.dot(b.angular_momentum)) / 2;
}

double kinetic_energy_of(std::span<const Body> bodies, const Vector3d& V)
{
    double energy = 0;
    for (const Body& body : bodies)
        energy += kinetic_energy_of(body, V);
    return energy;
}

Vector3d ContactProblem::up() const
{
    return up_direction(settings.gravity);
}

const DrivenBody* ContactProblem::drive_of(int body) const
{
    const auto found = std::find_if(driven.begin(), driven.end(),
                                    [&](const DrivenBody& d) { return d.body == body; });
    return found == driven.end() ? nullptr : &*found;
}

std::vector<Body> ContactProblem::grounds_of(const Island& island) const
{
    std::vector<int> touched;
    bool any_fixed = false;
    for (const ContactPair& pair : island.pairs)
        for (const int i : {contacts[pair.first].body1, contacts[pair.first].body2}) {
            if (!bodies[i].is_static()) continue;
            if (drive_of(i) || !std::exchange(any_fixed, true)) touched.push_back(i);
        }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    std::vector<Body> grounds;
    grounds.reserve(touched.size());
    for (const int i : touched)
        grounds.push_back(bodies[i]);
    if (!grounds.empty()) return grounds;

    Body center;
    double M = 0;
    for (const int i : island.bodies) {
        const double m = 1 / bodies[i].inverse_mass;
        M += m;
        center.velocity += m * bodies[i].velocity;
    }
    center.velocity /= M;
    return {center};
}

std::vector<Body> ContactProblem::bodies_of(const Island& island) const
{
    std::vector<Body> copies;
    for (int i : island.bodies)
        copies.push_back(bodies[i]);
    return copies;
}

Vector3d ContactProblem::velocity_between(std::span<const Body> states, const Contact& contact,
                                          const Vector3d& x) const
{
    const Body &body1 = states[contact.body1], &body2 = states[contact.body2];
    return optimised ? optimised::relative_velocity(body1, body2, x)
                     : relative_velocity(body1, body2, x);
}

double ContactProblem::rounding_speed(const ContactConstraint& c) const
{
    constexpr double few_errors = 64 * std::numeric_limits<double>::epsilon();
    double speed = std::abs(c.force_speed); // the loop adds the speeds of both bodies
    for (const int i : {c.body1, c.body2}) {
        const Body& body = bodies[i];
        speed += body.velocity.lpNorm<1>() +
                 body.angular_velocity.lpNorm<1>() * (c.point - body.position).lpNorm<1>();
    }
    return few_errors * speed;
}

bool ContactProblem::holds(const ContactConstraint& c) const
{
    if (c.contact_impulse.isZero(0)) return false;
    const double rounding = rounding_speed(c);
    return c.normal_K * c.contact_impulse.norm() > rounding || !std::isfinite(rounding);
}

double ContactProblem::bend_of_drives(const ContactConstraint& c) const
{
    double bend = 0;
    for (const int i : {c.body1, c.body2}) {
        const Body& body = bodies[i];
        if (!body.is_static()) continue;
        const double turn = time_step * body.angular_velocity.norm();
        bend += turn * turn * (c.point - body.position).norm() / 2;
    }
    return bend;
}

Matrix3d ContactProblem::impulse_matrix_at(const ContactConstraint& c, const Vector3d& x) const
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

void ContactProblem::set_impulse_matrix(ContactConstraint& c) const
{
    c.K = impulse_matrix_at(c, c.point);
    c.normal_K = c.normal.dot(optimised::product(c.K, c.normal));
    c.tangential_K = tangential_eigenvalue(c.K, c.normal);
}

void ContactProblem::apply(const ContactConstraint& c, const Vector3d& x, const Vector3d& j)
{
    push(bodies[c.body1], x, j);
    push(bodies[c.body2], x, -j);
}

void ContactProblem::push(Body& body, const Vector3d& x, const Vector3d& j) const
{
    if (body.is_static()) return;
    if (optimised)
        optimised::apply_impulse(body, x, j);
    else
        body = apply_impulse(body, x, j);
}

} // namespace rigor
