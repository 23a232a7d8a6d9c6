// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// A small motion without velocity.
struct Displacement {
    Vector3d shift = Vector3d::Zero(); // of the center of mass [m]
    Vector3d turn = Vector3d::Zero();  // axis times angle [rad]
};

/// How far the bodies move apart in the step besides their velocities, so that penetration vanishes: by
/// a fifth a step, no faster than one radius of the smaller body a second, and without bringing other
/// contacts into penetration (projected Gauss–Seidel on the contacts' normals, as in "pseudo
/// velocities" or "split impulses"). These motions carry no velocity, so the correction gives no kinetic
/// energy and nothing jumps.
///
/// Every penetration above rounding is corrected: a stack whose contacts kept theirs would lean by the
/// sum. In a heap, overlap below 1e-4 of the radius is kept, and below twice that it is left alone: each
/// contact that is corrected disturbs others, and without any slop a heap would never come to rest.
///
/// Without gravity nothing is corrected here: a motion without velocity does not keep angular momentum,
/// so `correction_speed` does it.
///
/// @return one for each body of the world; empty if nothing needs correction
std::vector<Displacement> correct_positions(const ContactProblem& problem);

/// The velocity v·n that corrects the penetration of a contact without gravity [m/s]: a fifth a step, no
/// faster than one radius a second, and nothing within a thousandth of the radius, since it gives
/// energy. It keeps all momenta. With gravity: 0.
double correction_speed(const ContactProblem& problem, const ContactConstraint& contact);

} // namespace rigor
