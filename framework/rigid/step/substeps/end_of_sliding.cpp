// SPDX-License-Identifier: MIT
// Predicts when a contact stops sliding (a method of this engine, without a paper). First it finds
// the contacts that slide at the start of the step. If the friction of one of them is below its
// limit, it computes the velocities at the end of a step with all these frictions at their limits.
// The sliding speed of each contact is taken to change at a constant rate between start and end.
#include "rigid/step/substeps/end_of_sliding.hpp"

#include "rigid/step/midpoint/middle_of_step.hpp"

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

// A body of the list `bodies`, with the velocity that `when` names if it is a driven body.
Body body_at(const ContactProblem& problem, const std::vector<Body>& bodies, int i,
             DriveVelocity DrivenBody::*when)
{
    Body body = bodies[i];
    if (const DrivenBody* drive = problem.drive_of(i)) {
        body.velocity = (drive->*when).linear;
        body.angular_velocity = (drive->*when).angular;
    }
    return body;
}

bool turns(const DrivenBody* drive)
{
    return drive && !drive->mean.angular.isZero(0);
}

std::vector<SlidingContact> sliding_contacts(const ContactProblem& problem, const Island& island,
                                             const std::vector<Body>& before_forces)
{
    std::vector<SlidingContact> sliding;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            const double limit = c.friction * c.normal.dot(c.contact_impulse); // μ jₙ
            if (!(limit > 0) || !problem.holds(c)) continue;
            if (turns(problem.drive_of(c.body1)) || turns(problem.drive_of(c.body2))) return {};
            const Body body1 = body_at(problem, before_forces, c.body1, &DrivenBody::first),
                       body2 = body_at(problem, before_forces, c.body2, &DrivenBody::first);
            const Vector3d v = slip(velocity_at(c, body1, body2), c.normal);
            const double speed = v.norm();
            // A contact that rolls along a curve sticks only in the middle of the step.
            const double omega = (body1.angular_velocity - body2.angular_velocity).norm();
            const double by_turning = problem.time_step * omega * omega * c.radius;
            if (!(speed > std::max(negligible * c.tangential_K * limit, by_turning))) continue;
            sliding.push_back({&c, v / speed, speed, -limit * v / speed});
        }
    return sliding;
}

} // namespace

double end_of_sliding(const ContactProblem& problem, const Island& island,
                      const std::vector<Body>& before_forces)
{
    const ContactMethod method = problem.settings.contact_method;
    if (method == ContactMethod::one_at_a_time || method == ContactMethod::shock_propagation)
        return 0; // they leave speeds of sliding that are no end of sliding
    if (island.bodies.size() > 1) return 0;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i)
            if (!problem.contacts[i].collision_impulse.isZero(0)) return 0;

    const std::vector<SlidingContact> sliding = sliding_contacts(problem, island, before_forces);
    const auto is_below_limit = [&](const SlidingContact& s) {
        const Vector3d friction = slip(s.contact->contact_impulse, s.contact->normal);
        return (s.limit - friction).norm() > negligible * s.limit.norm();
    };
    if (std::none_of(sliding.begin(), sliding.end(), is_below_limit)) return 0;

    // The body at the end of the step, if friction had its limit during the whole step.
    const int i = island.bodies.front();
    Body last = problem.bodies[i];
    for (const SlidingContact& s : sliding) {
        const ContactConstraint& c = *s.contact;
        const Vector3d j = s.limit - slip(c.contact_impulse, c.normal);
        problem.push(last, c.point, c.body1 == i ? j : Vector3d(-j));
    }
    const double h = problem.time_step;
    double end = h;
    for (const SlidingContact& s : sliding) {
        const ContactConstraint& c = *s.contact;
        const Body ground =
            body_at(problem, problem.bodies, c.body1 == i ? c.body2 : c.body1, &DrivenBody::last);
        const Vector3d v =
            c.body1 == i ? velocity_at(c, last, ground) : velocity_at(c, ground, last);
        const double speed = v.dot(s.direction);
        const double time = speed < 0 ? h * s.speed / (s.speed - speed) : h;
        if (time > negligible * h) end = std::min(end, time);
    }
    return end < (1 - negligible) * h ? end : 0;
}

} // namespace rigor
