// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// A small change of a body's pose that leaves its velocity unchanged.
struct Displacement {
    Vector3d shift = Vector3d::Zero(); // motion of the center of mass [m]
    Vector3d turn = Vector3d::Zero();  // rotation axis times angle [rad]

    bool is_zero() const { return shift.isZero(0) && turn.isZero(0); }
};

/// Displacements that reduce the penetration of bodies without changing their velocities. In each
/// step they remove a fifth of the penetration, no faster than one radius of the smaller body per
/// second, and without bringing other contacts into penetration. The method is projected
/// Gauss–Seidel on pseudo velocities along the contacts' normals (Catto 2009, "Modeling and solving
/// constraints", Game Developers Conference), also known as split impulses. Since the velocities
/// stay the same, the correction adds no kinetic energy and bodies do not jump.
///
/// In a stack, every penetration above rounding is corrected; otherwise the errors of its contacts
/// would add up and the stack would lean. In a pile (`is_pile`), a slop of 1e-4 of the radius is
/// kept and overlap below twice the slop is left alone, because each correction disturbs other
/// contacts and the pile would never come to rest.
///
/// Without gravity nothing is corrected here, since a displacement does not conserve angular
/// momentum. In such a world, `correction_speed` corrects penetration.
///
/// @return one displacement for each body of the world; empty if nothing needs correction
std::vector<Displacement> position_corrections(const ContactProblem& problem);

/// The velocity v·n that corrects the penetration of a contact in a world without gravity [m/s],
/// known as Baumgarte stabilisation (Baumgarte 1972, "Stabilization of constraints and integrals of
/// motion in dynamical systems", Comput. Methods Appl. Mech. Eng. 1). It removes a fifth of the
/// penetration in each step, no faster than one radius per second. Penetration within a
/// thousandth of the radius is left alone, since the correction adds energy. Momentum and angular
/// momentum are conserved. With gravity the velocity is 0.
double correction_speed(const ContactProblem& problem, const ContactConstraint& contact);

} // namespace rigor
