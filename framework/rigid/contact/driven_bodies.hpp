// SPDX-License-Identifier: MIT
// The motion of driven bodies during a step, as the stages of contact see it.
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// A driven body moves along the normals of its contacts with its mean velocity over the step, so
/// that other bodies do not end up inside it. If its velocity changes within the step, as that of a
/// table that is shaken, other bodies have to follow the change. Therefore an island that touches
/// such a body is solved in the frame that moves with it. Let V₀ be the velocity of the driven body
/// at the start of the step, V̄ its mean velocity and V₁ its velocity at the end. A body with the
/// velocity v at the start has the velocity v - V₀ in the frame. The solver gives it the velocity
/// v' = (v - V₀) + V̄, which moves it in a step just as far as the frame and its velocity in the
/// frame do. During the step, the fictitious force changes its velocity by -(V₁ - V₀) (d'Alembert
/// 1743). At the end its velocity in the world is v' + (V₁ - V̄).
///
/// An island stays in the world if it also touches a static or driven body that moves along the
/// normal of their contact as seen from the frame and in another way than with its mean velocity,
/// for example where a piston presses a block against a wall.
///
/// Sets `Island::frame`, and gives bodies and contacts their velocities at the start in this frame.
void enter_moving_frames(ContactProblem& problem);

/// Takes those islands back to the world that no driven body holds: in a moving frame, bodies in
/// free flight would move on curves.
/// @param first  the bodies before the forces
void leave_unheld_frames(ContactProblem& problem, std::vector<Body>& first);

/// Sets the velocities of the static and driven bodies that an island touches, for the collision
/// stage. Along the mean normal of its contacts, such a body keeps its mean velocity. Along the
/// surface it gets its velocity at the start of the step, if the island is in a moving frame.
void set_velocities_at_start(ContactProblem& problem, const Island& island);

/// Sets the velocities of the static and driven bodies that an island touches, for the contact
/// stage. Along the mean normal of its contacts, such a body keeps its mean velocity. Along the
/// surface it gets V_d + h ω × (V - V_d), where V_d is its velocity at the end of the step, ω its
/// mean angular velocity, h the time step, and V the mean velocity of the bodies that touch it. The
/// reason: in the step, the contact points move over its surface by h (V - V_d), so the velocity of
/// the surface at these points changes by h ω × (V - V_d). With the velocity at the start of the
/// step, a body on a turntable would move along tangents and drift outwards.
/// @param first  the bodies before the forces. The velocities after the forces would be wrong here,
///               because contacts have not yet stopped the fall of a body at rest.
void set_velocities_at_end(ContactProblem& problem, const Island& island,
                           std::span<const Body> first);

/// Gives the static and driven bodies that an island touches their mean velocities again.
void reset_velocities(ContactProblem& problem, const Island& island);

} // namespace rigor
