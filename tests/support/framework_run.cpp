// SPDX-License-Identifier: MIT
// The framework's own tests need no worker.
#include "support/run.hpp"

namespace rigor::testing {

void prepare(const RunOptions&) {}
void begin_test_case(const std::string&, bool, const StalledLine&) {}
std::string last_call_text()
{
    return "";
}
CostSoFar cost_so_far()
{
    return {};
}
std::string mistake_text(const std::string&)
{
    return "";
}

} // namespace rigor::testing
