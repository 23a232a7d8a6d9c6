// SPDX-License-Identifier: MIT
// The laws that hold for every way to resolve contacts.
#pragma once

#include "contact_cases.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"

namespace rigor::testing {

inline Vector3d momentum(const Bodies& bodies)
{
    Vector3d sum = Vector3d::Zero();
    for (const Body& body : bodies)
        if (!body.is_static()) sum += body.velocity / body.inverse_mass;
    return sum;
}

/// Total angular momentum about the origin [N m s].
inline Vector3d angular_momentum(const Bodies& bodies)
{
    Vector3d sum = Vector3d::Zero();
    for (const Body& body : bodies)
        if (!body.is_static())
            sum += body.angular_momentum + body.position.cross(body.velocity) / body.inverse_mass;
    return sum;
}

inline double energy(const Bodies& bodies)
{
    double sum = 0;
    for (const Body& body : bodies)
        sum += energy(body);
    return sum;
}

/// Upper bound of the momenta that are passed on, the scale of their rounding [N s].
inline double impulse_size(const ContactCase& problem, const ContactResult& result)
{
    double sum = 0;
    for (const Bodies* bodies : {&problem.bodies, &result.bodies})
        for (const Body& body : *bodies)
            if (!body.is_static())
                sum += body.velocity.norm() / body.inverse_mass + body.angular_momentum.norm();
    for (std::size_t i = 0; i < result.impulses.size(); ++i)
        sum += (1 + problem.contacts[i].friction) * result.impulses[i].norm() +
               problem.contacts[i].impulse.norm();
    return sum;
}

/// Checks that positions, masses and static bodies are exactly as before.
inline void check_untouched(const ContactCase& problem, const ContactResult& result)
{
    check_count(result.bodies.size(), problem.bodies.size(), "bodies");
    check_count(result.impulses.size(), problem.contacts.size(), "impulses, one for each contact");
    for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
        const Body &before = problem.bodies[i], &after = result.bodies[i];
        CAPTURE(i);
        REQUIRE_THAT(after.inverse_mass, IsExactly(before.inverse_mass));
        REQUIRE_THAT(after.inverse_inertia, IsExactly(before.inverse_inertia));
        REQUIRE_THAT(after.position, IsExactly(before.position));
        if (before.is_static()) REQUIRE_THAT(after, IsExactly(before));
    }
}

/// Checks that each body has changed by the reported impulses and by nothing else.
/// @param visits    number of impulses that were added up
/// @param receives  receives(body, contact): whether the body gets the impulse of the contact
template <class Receives>
void check_bookkeeping(const ContactCase& problem, const ContactResult& result, int visits,
                       Receives receives)
{
    check_untouched(problem, result);
    const double k = 64.0 * (1 + visits), size = impulse_size(problem, result);
    for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
        const Body& before = problem.bodies[i];
        if (before.is_static()) continue;
        Body expected = before;
        for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
            const BodyContact& contact = problem.contacts[c];
            if (!receives(static_cast<int>(i), contact)) continue;
            const int sign = (contact.body1 == static_cast<int>(i) ? 1 : 0) -
                             (contact.body2 == static_cast<int>(i) ? 1 : 0);
            if (sign != 0) expected = kicked(expected, contact.point, sign * result.impulses[c]);
        }
        CAPTURE(i);
        const Body& after = result.bodies[i];
        REQUIRE_THAT(after.velocity,
                     IsClose(expected.velocity, Rounding(k, size * before.inverse_mass)));
        REQUIRE_THAT(after.angular_momentum,
                     IsClose(expected.angular_momentum, Rounding(k, 4 * size)));
        REQUIRE_THAT(after.angular_velocity,
                     IsClose(expected.angular_velocity,
                             Rounding(k, 4 * size * before.inverse_inertia.norm() + 2)));
    }
}

inline void check_bookkeeping(const ContactCase& problem, const ContactResult& result, int visits)
{
    check_bookkeeping(problem, result, visits, [](int, const BodyContact&) { return true; });
}

/// Checks that momentum and angular momentum are conserved.
inline void check_momenta(const ContactCase& problem, const ContactResult& result, int visits)
{
    const double k = 64.0 * (1 + visits), size = impulse_size(problem, result);
    REQUIRE_THAT(momentum(result.bodies), IsClose(momentum(problem.bodies), Rounding(k, size)));
    REQUIRE_THAT(angular_momentum(result.bodies),
                 IsClose(angular_momentum(problem.bodies), Rounding(k, 4 * size)));
}

/// Checks that contacts push, and that friction is at most μ times the normal impulse.
inline void check_cones(const ContactCase& problem, const ContactResult& result, int visits)
{
    check_count(result.impulses.size(), problem.contacts.size(), "impulses, one for each contact");
    const double scale = 16.0 * (1 + visits);
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
        const Vector3d &n = problem.contacts[i].normal, &j = result.impulses[i];
        const double mu = problem.contacts[i].friction, j_n = j.dot(n);
        CAPTURE(i);
        check_at_least(j_n, 0, "jₙ", scale * j.norm());
        check_at_most((j - j_n * n).norm(), mu * j_n, "|j_T|, by μ jₙ",
                      scale * (1 + mu) * j.norm());
    }
}

} // namespace rigor::testing
