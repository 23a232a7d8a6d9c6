// SPDX-License-Identifier: MIT
// The framework's own tests need no worker.
#include "support/run.hpp"

namespace rigor::testing {

void prepare(const RunOptions&) {}
void begin_test_case() {}

} // namespace rigor::testing
