// SPDX-License-Identifier: MIT
#include "rigid/step/substeps/end_of_sliding.hpp"

#include <algorithm>

namespace rigor {

namespace {

// A contact that slides at the start of the step.
struct SlidingContact {
    const ContactConstraint* contact = nullptr;
    Vector3d direction = Vector3d::Zero(); // in which it slides, a unit vector
    double speed = 0;                      // with which it slides [m/s]
    Vector3d limit = Vector3d::Zero();     // friction at its limit against the sliding [N s]
};

// A share of the change of speed by friction in a step. Below it, a contact counts as one that does
// not slide at the start, or whose friction is at its limit. Also the smallest share of a step that
// is worth a division.
constexpr double negligible = 1e-3;

Vector3d along_surface(const ContactConstraint& c, const Vector3d& v)
{
    return v - c.normal.dot(v) * c.normal;
}

// The velocity of sliding, v₁ - v₂ along the surface.
// @param body_at  gives a body by its index in the world
// @param when     which of its velocities a driven body has
template <class BodyAt>
Vector3d sliding_velocity(const ContactProblem& problem, const ContactConstraint& c,
                          const BodyAt& body_at, DriveVelocity DrivenBody::*when)
{
    Body pair[] = {body_at(c.body1), body_at(c.body2)};
    for (const auto& [body, i] : {std::pair(&pair[0], c.body1), std::pair(&pair[1], c.body2)})
        if (const DrivenBody* drive = problem.drive_of(i)) {
            body->velocity = (drive->*when).linear;
            body->angular_velocity = (drive->*when).angular;
        }
    Contact between = c;
    between.body1 = 0;
    between.body2 = 1;
    return along_surface(c, problem.velocity_between(pair, between, c.point));
}

bool turns(const DrivenBody* drive)
{
    return drive && !drive->mean.angular.isZero(0);
}

std::vector<SlidingContact> sliding_contacts(const ContactProblem& problem, const Island& island,
                                             const std::vector<Body>& first)
{
    std::vector<SlidingContact> sliding;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            const double limit = c.friction * c.normal.dot(c.contact_impulse); // μ jₙ
            if (!(limit > 0) || !problem.holds(c)) continue;
            if (turns(problem.drive_of(c.body1)) || turns(problem.drive_of(c.body2))) return {};
            const Vector3d v = sliding_velocity(
                problem, c, [&](int body) { return first[body]; }, &DrivenBody::first);
            const double speed = v.norm();
            // A contact that rolls along a curve sticks only in the middle of the step.
            const double omega =
                (first[c.body1].angular_velocity - first[c.body2].angular_velocity).norm();
            const double by_turning = problem.time_step * omega * omega * c.radius;
            if (!(speed > std::max(negligible * c.tangential_K * limit, by_turning))) continue;
            sliding.push_back({&c, v / speed, speed, -limit * v / speed});
        }
    return sliding;
}

} // namespace

double end_of_sliding(const ContactProblem& problem, const Island& island,
                      const std::vector<Body>& first)
{
    const ContactMethod method = problem.settings.contact_method;
    if (method == ContactMethod::one_at_a_time || method == ContactMethod::shock_propagation)
        return 0; // they leave speeds of sliding that are no end of sliding
    if (island.bodies.size() > 1) return 0;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i)
            if (!problem.contacts[i].collision_impulse.isZero(0)) return 0;

    const std::vector<SlidingContact> sliding = sliding_contacts(problem, island, first);
    const auto is_below_limit = [&](const SlidingContact& s) {
        const Vector3d friction = along_surface(*s.contact, s.contact->contact_impulse);
        return (s.limit - friction).norm() > negligible * s.limit.norm();
    };
    if (std::none_of(sliding.begin(), sliding.end(), is_below_limit)) return 0;

    // The bodies at the end of the step, if friction had its limit during the whole step.
    std::vector<Body> last = problem.bodies_of(island);
    const auto place_of = [&](int i) {
        return std::lower_bound(island.bodies.begin(), island.bodies.end(), i) -
               island.bodies.begin();
    };
    const auto push = [&](int i, const Vector3d& x, const Vector3d& j) {
        if (!problem.bodies[i].is_static()) problem.push(last[place_of(i)], x, j);
    };
    const auto last_at = [&](int i) {
        return problem.bodies[i].is_static() ? problem.bodies[i] : last[place_of(i)];
    };
    for (const SlidingContact& s : sliding) {
        const ContactConstraint& c = *s.contact;
        const Vector3d j = s.limit - along_surface(c, c.contact_impulse);
        push(c.body1, c.point, j);
        push(c.body2, c.point, -j);
    }
    const double h = problem.time_step;
    double end = h;
    for (const SlidingContact& s : sliding) {
        const double speed =
            sliding_velocity(problem, *s.contact, last_at, &DrivenBody::last).dot(s.direction);
        const double time = speed < 0 ? h * s.speed / (s.speed - speed) : h;
        if (time > negligible * h) end = std::min(end, time);
    }
    return end < (1 - negligible) * h ? end : 0;
}

} // namespace rigor
