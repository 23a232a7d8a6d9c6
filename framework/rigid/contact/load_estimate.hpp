// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// A contact counts as carrying weight only if |n·up| is at least this value, so that its tangent
/// plane is tilted by less than 73° from horizontal. A smaller value would count walls as supports,
/// a larger one would leave out steep supports.
inline constexpr double least_lift = 0.3;

/// A first estimate of the impulses of an island that rests on at least one static body.
///
/// From the highest body to the lowest, each body passes the impulse of its own weight, M |g| h (M:
/// its mass, h: time step), and the load on it to the contacts below it in equal parts. The
/// impulse of a contact is vertical if it then lies within the friction cone, otherwise along the
/// normal. For a straight stack this is already the solution. For a pile it saves most of the
/// sweeps, since one sweep carries weight down by only one body. The sweeps then correct the
/// estimate. Without gravity, or if no body rests on a static one, nothing is estimated.
///
/// @param active  indices of contacts of the island; for those that carry weight, `initial_impulse`
///                is set
void estimate_loads(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
