// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"

#include <span>
#include <vector>

namespace rigor {

/// The angle by which a body that is not still turns in a step [rad], if it keeps the angular
/// velocity that it has in `state`. For a driven body the angle follows from its drive instead. No
/// formula is called for this estimate.
double angle_turned(const World& world, const RigidBody& body, const RigidState& state,
                    double time_step);

/// How a body moves in free flight during the step [m]. `moved` is the displacement of its center.
/// `at_last_velocity` is the displacement that its velocity at the end of the flight would give in
/// the whole step. `turned` is how far rotation moves its other points in addition.
struct Travel {
    Vector3d moved = Vector3d::Zero(), at_last_velocity = Vector3d::Zero();
    double turned = 0;
};

/// @param from, to  states at the start and at the end of the flight
/// @param angle     the angle by which the body turns during the flight [rad]; needed because the
///                  two orientations do not show how many revolutions the body makes
/// @param radius    the body's radius about its center of mass [m]
Travel travel_of(const RigidState& from, const RigidState& to, double angle, double radius,
                 double time_step);

/// An upper estimate of the distance by which a point of one body moves relative to a point of the
/// other [m].
double path_between(const Travel& a, const Travel& b);

/// The motions relative to which the travel of bodies is measured: those of still and of driven
/// bodies, without duplicates. In a world without such bodies, the only motion in the list is
/// that of the center of mass of all bodies.
/// @param flown  the states after free flight
std::vector<Travel> frames_of(const World& world, std::span<const RigidState> flown,
                              double time_step);

/// The displacement that is subtracted from each body's position at the end of free flight before
/// the bounds of the body are swept [m]. It is zero if any body is still, because the bounds of
/// still bodies are not swept.
/// @param frames  the result of `frames_of`
Vector3d frame_of_bounds(const World& world, const std::vector<Travel>& frames);

} // namespace rigor
