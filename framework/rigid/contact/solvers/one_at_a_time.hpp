// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Resolves the active contacts by the formula `resolve_contacts` in ten iterations. If `shock` is
/// true, this formula may run again with more iterations; then the formulas `contact_levels` and
/// `shock_propagation` follow.
///
/// @param active  indices in `problem.contacts`, at least one
void resolve_one_at_a_time(ContactProblem& problem, std::span<const int> active, bool shock);

} // namespace rigor
