// SPDX-License-Identifier: MIT
// The guard at the engine's boundary: a formula may return anything.
#pragma once

#include "rigid/bodies/world.hpp"

#include <stdexcept>

namespace rigor {

/// A body's state is not a number any more, or is infinite. Says which body, which quantity and
/// when.
struct NonFiniteState : std::runtime_error {
    NonFiniteState(std::string body_name, std::string quantity_name, double at_time);

    std::string body, quantity; // "V", or "inertia"
    double time = 0;            // [s]
};

/// @throws NonFiniteState naming the first of X, q, V, L that is not finite
void require_finite(const RigidBody& body, const RigidState& state, double time);

} // namespace rigor
