// SPDX-License-Identifier: MIT
// Checks that states are finite and in range, since a student's formula may return any value.
#pragma once

#include "rigid/bodies/world.hpp"

#include <stdexcept>

namespace rigor {

/// The largest magnitude of a number in a scene: of a state, and of what a formula returns there.
/// Products of two states, which energies and forces are made of, then fit in a double.
inline constexpr double largest_in_scene = 1e100;

/// A body's state or mass properties contain a value that is infinite, not a number, or beyond
/// `largest_in_scene`. The message names the body, the quantity and the time.
struct NonFiniteState : std::runtime_error {
    /// @param is_finite  true: finite, but beyond `largest_in_scene`
    NonFiniteState(std::string body_name, std::string quantity_name, double at_time,
                   bool is_finite = false);

    std::string body, quantity; // names; the quantity is for example "velocity V"
    double time = 0;            // [s]
};

/// @throws NonFiniteState unless each number of `v` is finite and at most `largest_in_scene`
void require_in_range(const Vector3d& v, const std::string& name, const char* quantity,
                      double time);

/// @throws NonFiniteState if X, q, V or L is not finite or out of range; the exception names the
///                        first of these
void require_finite(const RigidBody& body, const RigidState& state, double time);

} // namespace rigor
