// SPDX-License-Identifier: MIT
// The motion of driven bodies during a step, as the stages of contact see it.
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// A driven body moves along the normals of its contacts with its mean velocity over the step, so
/// that other bodies do not end up inside it. If its velocity changes within the step, as that of a
/// table that is shaken, other bodies have to follow the change. Therefore an island that touches
/// such a body is solved in a frame that moves along with the body and does not rotate. With the
/// velocity V₀ of the driven body at the start of the step, its mean velocity V̄, and its velocity
/// V₁ at the end, a velocity v of another body becomes
///
///                 in the world    in the frame    in the solver
///     at start    v               v - V₀          v - V₀ + V̄
///     at end      v               v - V₁          v - V₁ + V̄
///
/// The solver adds V̄ because its velocities have to give the displacements in the world. Besides
/// the other forces, the fictitious force changes the velocity by -(V₁ - V₀) (d'Alembert 1743).
///
/// An island stays in the world if it also touches another static or driven body that has an
/// acceleration along the normal of this contact, as seen from the frame. This is so where a piston
/// presses a block against a wall. Contacts that are open, and stay open without impulses, do not
/// count.
///
/// Sets `Island::frame`, and changes the velocities of the island's bodies and the force speeds of
/// its contacts.
void enter_moving_frames(ContactProblem& problem);

/// Whether the velocity of a static or driven body, as seen from the frame of the island, stays the
/// same during the step.
bool is_steady_in_frame(const ContactProblem& problem, const Island& island, int body);

/// Changes the velocities of each island to which no driven body gave an impulse from those in its
/// moving frame to those in the world. In an accelerated frame, bodies in free flight would move
/// along curves.
/// @param before_forces  the bodies before the forces
void leave_unheld_frames(ContactProblem& problem, std::vector<Body>& before_forces);

/// Changes the velocities of all other islands to those in the world.
/// @param before_forces  the bodies before the forces
void leave_moving_frames(ContactProblem& problem, std::vector<Body>& before_forces);

/// Sets the velocities of the static and driven bodies that an island touches, for the collision
/// stage of an island in a moving frame. Along the mean normal of its contacts, such a body keeps
/// its mean velocity. Along the surface it gets its velocity at the start of the step.
void set_velocities_at_start(ContactProblem& problem, const Island& island);

/// Sets the velocities of the static and driven bodies that an island touches, for the contact
/// stage. Along the mean normal of its contacts, such a body keeps its mean velocity. Along the
/// surface it gets V_d + h ω × (V - V_d), where V_d is its velocity at the end of the step, ω its
/// mean angular velocity, h the time step, and V the mean velocity of the bodies that touch it. The
/// reason: in the step, the contact points move over its surface by h (V - V_d), so the velocity of
/// the surface at these points changes by h ω × (V - V_d). With the velocity at the start of the
/// step, a body on a turntable would move along tangents and drift outwards.
/// @param before_forces  the bodies before the forces. The velocities after the forces would be
///                       wrong here, because contacts have not yet stopped the fall of a body at
///                       rest.
void set_velocities_at_end(ContactProblem& problem, const Island& island,
                           std::span<const Body> before_forces);

/// Gives the static and driven bodies that an island touches their mean velocities again.
void reset_velocities(ContactProblem& problem, const Island& island);

} // namespace rigor
