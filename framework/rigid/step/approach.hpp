// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

#include <optional>

namespace rigor {

/// The state of a contact from which its closing is predicted: its gap [m], its v·n (`speed`) [m/s]
/// and the rate at which v·n changes [m/s²].
struct Approach {
    double gap = 0, speed = 0, rate = 0;

    /// The time t when the gap closes, gap + speed t + ½ rate t² = 0 [s]. It is infinity if the gap
    /// never closes, and 0 if the gap is closed now.
    double closes() const;
};

/// The contact of a pair that closes first.
/// @return nothing if none of the contacts closes
std::optional<Approach> first_to_close(const World& world, const ContactProblem& problem,
                                       const ContactPair& pair);

} // namespace rigor
