// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// Least |n·up| of a contact that carries weight: its tangent plane is less than 73° from level. A
/// smaller value would count walls as supports, a larger one would leave out steep supports.
inline constexpr double least_lift = 0.3;

/// A first estimate of the impulses of an island that rests on something static.
///
/// From the highest body to the lowest, each body passes the impulse of its own weight, M |g| h,
/// and the load on it to the contacts below it in equal parts. The push is vertical if it lies
/// within the friction cone of the contact, otherwise along the normal. For a stack this is already
/// the solution. For a pile it saves most of the iterations, since a sweep carries weight down by
/// only one body. The sweeps correct the estimate. Without gravity, or if no body rests on a static
/// one, nothing is estimated.
///
/// @param active  contacts of the island; those that carry weight get their `initial_impulse`
void estimate_loads(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
