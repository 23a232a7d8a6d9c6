// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// A contact that may hold bodies apart in this step, at the start and in the middle of the step.
struct HeldContact {
    int index = 0;       // index in `ContactProblem::contacts`
    Contact middle = {}; // the same contact in the middle of the step
    // v₁ - v₂ at the contact point of the start of the step, and at that of the middle of the step,
    // both with the velocities and angular momenta of the bodies at the start [m/s].
    Vector3d v_start = {}, v_middle = {};
    // The change of v·n from the start to the middle of the step [m/s]. It is computed twice, with
    // the velocities at the start and with those after the contact stage. The larger value is kept.
    double change = 0;
    double negligible = 0; // the highest speed at this contact that counts as 0 [m/s]
    // Whether the contact stage gave it an impulse. If not, it is listed because a driven body that
    // turns may close it.
    bool has_impulse = false;
    bool slides = false; // whether its friction in the contact stage is at the limit
    // Whether it does not count in the middle of the step, see `find_middles`.
    bool is_left_out = false;
};

/// A bound of |v₁ - v₂| at a contact, whatever the directions of its lever arms. It is the same in
/// every frame that moves at a constant velocity [m/s].
double speed_at(const Contact& contact, const Body& body1, const Body& body2);

/// Finds held contacts again in the middle of the step and sets their `middle`. Contacts that count
/// no more are removed: those without an impulse that are not closer then than at the start, and
/// those that their bodies leave behind, as at the joint of two tiles that a ball crosses.
///
/// @param before_forces  the bodies after the collision stage, before the forces
/// @param poses  poses of all bodies in the middle of the step
/// @return whether each contact with an impulse was found again
bool find_middles(const World& world, const ContactProblem& problem,
                  const std::vector<Body>& before_forces, const std::vector<Pose>& poses,
                  std::vector<HeldContact>& held);

} // namespace rigor
