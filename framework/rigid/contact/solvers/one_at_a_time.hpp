// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Resolves the active contacts by ten iterations of the formula `resolve_contacts`. With `shock`,
/// it starts again with more iterations if bodies still approach fast; then `contact_levels` and
/// `shock_propagation` follow.
///
/// @param active  indices in `problem.contacts`, at least one
void resolve_one_at_a_time(ContactProblem& problem, std::span<const int> active, bool shock);

} // namespace rigor
