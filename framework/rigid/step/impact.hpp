// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/contact/position_correction.hpp"

namespace rigor {

/// Whether a contact of the pair got an impulse in the collision stage of this step.
bool bounced(const ContactProblem& problem, const ContactPair& pair);

/// Whether two contacts of a pair of bodies lie on the same side: their normals differ by less than
/// 60°.
inline bool are_on_one_side(const Vector3d& n1, const Vector3d& n2)
{
    return n1.dot(n2) > 0.5;
}

/// Whether a contact of the pair got an impulse in the contact stage of this step.
bool carries_load(const ContactProblem& problem, const ContactPair& pair);

/// The time from the start of the step until the first contact of the pair closes, predicted from
/// its gap, speed and acceleration [s]. It is infinity if no contact closes, and 0 if a contact is
/// closed already and does not open.
double time_of_impact(const World& world, const ContactProblem& problem, const ContactPair& pair);

/// The time of the first bounce in this step, moved or not, since the start of the step [s]. It is
/// infinity if there is none.
double first_bounce(const World& world, const ContactProblem& problem);

/// Moves bounces to their times of impact: the two bodies fly until they meet, bounce at that time,
/// and fly on for the rest of the step. Such a bounce has the order of accuracy of free flight and
/// conserves the energy if ε = 1 and μ = 0. If the two bodies turn out not to meet in this step,
/// they only fly. A bounce of a pair of bodies is moved if all of these conditions hold:
/// 1. The pair bounced in this step, and its contacts carry no load.
/// 2. Each of the two bodies is static or got no impulse from a third body.
/// 3. No other pair of the island got an impulse, or each of the two bodies that can move is a
///    ball.
/// 4. The bodies did not touch at the start of the step, met on one side only, and do not meet
///    again within the step.
/// 5. No spring, applied force, drag or position correction moves one of them.
///
/// The secant method finds the time of impact from the gap at several times of the flight, starting
/// from a prediction. If the method does not converge, the result of the collision stage is kept.
///
/// @param pulled         for each body, whether springs, applied forces or drag act on it
/// @param displacements  the position corrections, one for each body, or an empty list
/// @param states  the states of all bodies; the states of pairs whose bounce is moved are replaced
/// @param problem  its islands get the contacts of these bounces with their impulses
///                 (`Island::moved_bounces`); the impulses of all contacts of these pairs become
///                 zero, also if the two bodies only fly
void bounce_at_impacts(const World& world, ContactProblem& problem, const std::vector<bool>& pulled,
                       const std::vector<Displacement>& displacements,
                       std::vector<RigidState>& states);

} // namespace rigor
