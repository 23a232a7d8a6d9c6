// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

#include <span>

namespace rigor {

/// Sweeps that also share the load of a body evenly among the static and driven bodies that it lies
/// on, if one of these turns.
///
/// The law of contact does not determine the loads of a body that lies on more than three points:
/// a table has four legs, but its balance gives three equations. Plain sweeps find loads that
/// depend on the order of the contacts. These loads all give the same motion where all contacts
/// slide in the same direction. But where the supports move in different directions, as two rollers
/// do, an uneven load turns the body. So before each sweep the normal impulses jₙ are replaced by
/// those of equally stiff springs at the contacts, unless one of these would pull. The new impulses
/// have the same sum and the same moments. They are a linear function of the position in the plane
/// where the contacts lie. No other impulses with this sum and these moments have a smaller Σ jₙ².
///
/// @return `sweeps` itself, unless the island is a single body on at least two static or driven
///         bodies, of which one turns, and its contacts are closed and have parallel normals
std::unique_ptr<Sweeps> with_shared_loads(const ContactProblem& problem, const Island& island,
                                          std::span<const int> active,
                                          std::unique_ptr<Sweeps> sweeps);

} // namespace rigor
