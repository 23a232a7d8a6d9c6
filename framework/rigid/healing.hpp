// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// A small motion that has no velocity.
struct Displacement {
    Vector3d shift = Vector3d::Zero(); // of the center of mass [m]
    Vector3d turn = Vector3d::Zero();  // axis times angle [rad]
};

/// How far the bodies of an island move apart in the step besides their velocities, so that
/// penetration heals: by a fifth a step, no faster than one radius of the smaller body a second, and
/// without bringing other contacts into penetration (projected Gauss–Seidel on the contacts' normals).
/// As these motions carry no velocity, healing gives no energy of motion and nothing jumps. Any
/// penetration heals that is not rounding: a stack whose contacts kept theirs would lean by the sum.
/// In a heap 1e-4 of the radius is left, and up to twice that is no reason to heal: each contact that is
/// healed disturbs others, and with no play at all a heap would never come to rest.
///
/// Without gravity there is nothing to heal here: a motion without velocity does not keep angular
/// momentum, so that `healing_speed` does it.
///
/// @param displacements  of each body of the world: those of the island are set. Untouched if nothing
///                       needs healing
void heal(const ContactProblem& problem, const Island& island,
          std::vector<Displacement>& displacements);

/// The velocity v·n that a contact is to have so that its penetration heals without gravity: by a
/// fifth a step, no faster than one radius a second, and not at all within a thousandth of the radius,
/// since it gives energy. It keeps all momenta. With gravity: 0 [m/s].
double healing_speed(const ContactProblem& problem, const SolvedContact& contact);

} // namespace rigor
