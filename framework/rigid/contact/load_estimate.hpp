// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact/solvers/sweeps.hpp"

namespace rigor {

/// A first guess at the impulses of an island that lies on something static: weight flows down.
///
/// From the highest body to the lowest, each hands its own weight's impulse M |g| h and what lies on
/// it to the contacts below it in equal parts: upright where friction can hold that, else along the
/// normal. For a stack that is the answer; for a pile it saves the iteration most of its way, which
/// would carry weight down by one body a sweep. It is a guess only: the iteration corrects it.
/// Without gravity, or where nothing below is static: no guess.
///
/// @param held  contacts of the island; those that carry weight get their `guess`
void estimate_loads(ContactProblem& problem, const Island& island, std::span<const int> active);

} // namespace rigor
