// SPDX-License-Identifier: MIT
// Which formulas this program has called. The reference's sources are compiled so that each
// function reports its start.
#pragma once

#include <set>
#include <string>

namespace rigor::handouts {

/// The tags of the formulas that were called.
std::set<std::string> called_formulas();

/// As if no formula had been called yet.
void forget_calls();

} // namespace rigor::handouts
