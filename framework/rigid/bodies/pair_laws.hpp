// SPDX-License-Identifier: MIT
// What holds for two bodies in particular: their restitution, their friction, and whether they
// collide at all.
#pragma once

#include "rigid/bodies/body.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// A value that is left out follows from the materials of the two bodies.
struct PairLaw {
    int body1 = 0, body2 = 0;                    // indices of the bodies, body1 < body2
    std::optional<double> restitution, friction; // ε and μ of this pair
    bool collides = true;                        // false: the bodies pass through each other
};

/// Sorts the laws by their bodies, as the other functions expect them.
void sort_by_pair(std::vector<PairLaw>& laws);

/// The law of two bodies, or null if they have no law of their own.
const PairLaw* law_of(std::span<const PairLaw> laws, int body1, int body2);

/// ε and μ of a contact between two bodies: those of their law, or else the smaller restitution and
/// the geometric mean of the frictions.
Material material_between(std::span<const PairLaw> laws, std::span<const RigidBody> bodies,
                          int body1, int body2);

/// The laws of a part of a world.
/// @param bodies  for each body of the part, its index in the world
std::vector<PairLaw> laws_among(std::span<const PairLaw> laws, std::span<const int> bodies);

} // namespace rigor
