// SPDX-License-Identifier: MIT
// Checks that results of formulas are finite, since a student's formula may return any value.
#pragma once

#include "rigid/bodies/world.hpp"

#include <stdexcept>

namespace rigor {

/// A body's state or mass properties contain a value that is infinite or not a number. The message
/// names the body, the quantity and the time.
struct NonFiniteState : std::runtime_error {
    NonFiniteState(std::string body_name, std::string quantity_name, double at_time);

    std::string body, quantity; // names; the quantity is for example "velocity V"
    double time = 0;            // [s]
};

/// @throws NonFiniteState if X, q, V or L is not finite; the exception names the first of these
///                        that is not finite
void require_finite(const RigidBody& body, const RigidState& state, double time);

} // namespace rigor
