// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// A contact counts as a support only if |n·up| is at least this value, so that its tangent plane
/// is tilted by less than 73° from horizontal. A smaller value would count walls as supports; a
/// larger value would leave out steep supports.
inline constexpr double least_lift = 0.3;

/// A first estimate of the impulses of an island that rests on at least one static body.
///
/// From the highest body to the lowest, each body passes on to the contacts below it, in equal
/// parts, the impulse of its own weight, M |g| h (M: its mass, h: time step), and the load that
/// other bodies put on it. The impulse of a contact is vertical if it then lies within the friction
/// cone; otherwise it is the normal part of this vertical impulse. For a straight stack this is
/// already the solution. For a pile it saves most of the sweeps, since one sweep carries weight
/// down by only one body. The sweeps then correct the estimate. Without gravity, or if no body
/// rests on a static one, nothing is estimated.
///
/// @param active  indices of contacts of the island; `initial_impulse` is set for those that are
///                supports
void estimate_loads(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
