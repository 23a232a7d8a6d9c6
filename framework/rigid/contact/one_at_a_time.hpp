// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Resolves the active contacts by `resolve_contacts`, and with `shock` then by `contact_levels` and
/// `shock_propagation`.
void resolve_one_at_a_time(ContactProblem& problem, std::span<const int> active, bool shock);

} // namespace rigor
