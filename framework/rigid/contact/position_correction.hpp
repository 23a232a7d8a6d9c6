// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// A small change of a body's pose, made without a change of its velocity.
struct Displacement {
    Vector3d shift = Vector3d::Zero(); // motion of the center of mass [m]
    Vector3d turn = Vector3d::Zero();  // rotation axis times angle [rad]

    bool is_zero() const { return shift.isZero(0) && turn.isZero(0); }
};

/// Displacements that reduce the penetration of bodies without changing their velocities. In each
/// step they remove a fifth of the penetration above the slop, at a speed of at most one radius of
/// the contact (`ContactConstraint::radius`) per second, and without making other contacts
/// penetrate. The method is projected Gauss–Seidel on pseudo velocities along the contacts' normals
/// (Catto 2014, "Understanding constraints", Game Developers Conference), also known as split
/// impulses. Since the velocities stay the same, the correction adds no kinetic energy and bodies
/// do not jump apart. In a large island the number of sweeps is small, so less may be removed in
/// one step.
///
/// The slop is the overlap that the correction leaves. An overlap below twice the slop is not
/// corrected at all. In a stack, the slop is tiny (1e-6 of the radius); otherwise the errors of the
/// contacts would add up and the stack would lean. In a pile (`is_pile` in contact_problem.hpp), it
/// is 1e-4 of the radius; otherwise each correction would disturb other contacts, and the pile
/// would never come to rest.
///
/// In a world without gravity this function corrects nothing, since a displacement does not
/// conserve angular momentum. There, `correction_speed` corrects penetration.
///
/// @return one displacement for each body of the world; empty if nothing needs correction
std::vector<Displacement> position_corrections(const ContactProblem& problem);

/// The speed v·n that corrects the penetration of a contact in a world without gravity [m/s], known
/// as Baumgarte stabilization (Baumgarte 1972, "Stabilization of constraints and integrals of
/// motion in dynamical systems", Comput. Methods Appl. Mech. Eng. 1). A slop of a thousandth of the
/// contact's radius remains, since the correction adds energy. In each step a fifth of the
/// penetration above the slop is removed, no faster than one radius per second. Momentum and
/// angular momentum are conserved. In a world with gravity the speed is 0.
double correction_speed(const ContactProblem& problem, const ContactConstraint& contact);

} // namespace rigor
