// SPDX-License-Identifier: MIT
// Laws for particular pairs of bodies: their restitution, their friction, and whether they collide
// at all.
#pragma once

#include "rigid/bodies/body.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// The law of one pair of bodies. A restitution or friction without a value follows from the
/// materials of the two bodies.
struct PairLaw {
    int body1 = 0, body2 = 0;                    // indices of the bodies, body1 < body2
    std::optional<double> restitution, friction; // ε and μ of this pair
    bool collides = true;                        // false: the bodies pass through each other
};

/// Makes `body1` the smaller index in each law, and sorts the laws by `body1`, then by `body2`. The
/// functions below expect this order.
void sort_by_pair(std::vector<PairLaw>& laws);

/// The law of two bodies, or null if no law is listed for this pair.
const PairLaw* law_of(std::span<const PairLaw> laws, int body1, int body2);

/// ε and μ of a contact between two bodies. A value that the law of this pair sets is taken from
/// the law. Otherwise ε is the smaller restitution of the two materials, and μ is the geometric
/// mean of their frictions.
Material material_between(std::span<const PairLaw> laws, std::span<const RigidBody> bodies,
                          int body1, int body2);

/// The laws between the bodies of a part of a world, with the indices that these bodies have in the
/// part.
/// @param bodies  for each body of the part, its index in the world
std::vector<PairLaw> laws_among(std::span<const PairLaw> laws, std::span<const int> bodies);

} // namespace rigor
