// SPDX-License-Identifier: MIT
#pragma once

#include "support/bench/bench.hpp"

namespace rigor {

/// Times one submission with the reference's files: the tests of each topic, everything but the
/// compiler for two topics, and a topic with a formula that never returns.
void measure_one_submission(Bench& bench);

} // namespace rigor
