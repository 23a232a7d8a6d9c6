// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"
#include "rigid/contact/position_correction.hpp"

#include <optional>

namespace rigor {

/// The flight of bodies that contacts hold while springs, applied forces or drag act on them.
struct SupportedFlight {
    // The states of all bodies after the flight, in which the impulses of the contact stage act as
    // constant forces.
    std::vector<RigidState> flown;
    // The same, without the changes of velocity and angular momentum by these constant forces. So
    // only the other forces change them, but along the path of the supported body.
    std::vector<RigidState> forced;
    // For each body, its displacement in the step minus the displacement by the mean of its
    // velocities at the start and at the end. It is not 0, since the forces change within the step.
    std::vector<Displacement> bends;
};

/// Whether the time step is too long for friction: springs, applied forces or drag act on an island
/// with friction, and the fastest forces of the world may reverse a motion within the step, even
/// where they act on other bodies. Friction, which is constant in a step, could add energy then.
/// @param pulled  for each body, whether springs, applied forces or drag act on it
bool is_too_long_for_friction(const World& world, ContactProblem& problem,
                              const std::vector<bool>& pulled);

/// Free flight computes springs and drag along the path of a body without contacts. This path is
/// wrong where contacts hold the body: a block on the ground falls, and the damper of a spring on
/// the block brakes this fall. Therefore the flight is repeated with the impulses of the contact
/// stage as constant forces, and the contact stage is repeated with the changes of velocity by the
/// other forces along this flight, until its impulses are those of the flight. The iteration is
/// accelerated by the method of Anderson (1965, "Iterative procedures for nonlinear integral
/// equations", J. ACM 12) with one earlier iterate.
///
/// This is done for islands of at most `most_refined` bodies (detection/overlap_depth.hpp) on which
/// springs, applied forces or drag act, and which got impulses in the contact stage but none in the
/// collision stage. Integrators whose step has a single stage (symplectic Euler) need none of this.
///
/// @param problem  the velocities and impulses of these islands are replaced
/// @param before_forces  the bodies before the forces
/// @param pulled   for each body, whether springs, applied forces or drag act on it
/// @param flown    the states after free flight, or after the flight that follows a bounce
///                 (bounced_flight.hpp)
/// @return nothing if there is no such island
std::optional<SupportedFlight> fly_supported(World& world, ContactProblem& problem,
                                             const std::vector<Body>& before_forces,
                                             const std::vector<bool>& pulled,
                                             const std::vector<RigidState>& flown);

/// The displacement from the pose of the state `a` to that of `b`.
Displacement displacement_between(const RigidState& a, const RigidState& b);

} // namespace rigor
