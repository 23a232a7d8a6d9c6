// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// A first guess at the impulses of an island that lies on something static: weight flows down.
///
/// From the highest body to the lowest, each hands its own weight's impulse M |g| h and what lies on
/// it to the contacts below it in equal parts: upright where friction can hold that, else along the
/// normal. For a stack that is the answer; for a pile it saves the iteration most of its way, which
/// would carry weight down by one body a sweep. It is a guess only: the iteration corrects it.
/// Without gravity, or where nothing below is static: no guess.
///
/// A warm start from the step before would do the same, but a step depends on nothing but its start.
///
/// @param contacts  of the island, by index in the problem
void guess_loads(ContactProblem& problem, const Island& island, const std::vector<int>& contacts);

} // namespace rigor
