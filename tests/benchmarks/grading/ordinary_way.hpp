// SPDX-License-Identifier: MIT
#pragma once

#include "support/bench/bench.hpp"

namespace rigor {

/// Times A2 from a saved file to its verdicts: here, and in the ordinary way, in which a student's
/// file and the tests are configured, compiled and linked as one program, which is then run.
void measure_ordinary_way(Bench& bench);

/// Times `check` of each topic with the reference in turns with that of another tree, whose path
/// the variable RIGOR_BEFORE has, such as the commit before a change, built in the same way.
void measure_against_before(Bench& bench);

} // namespace rigor
