// SPDX-License-Identifier: MIT
#include "grading/class/slurm/commands.hpp"

#include "support/catch.hpp"

namespace rigor::testing {

TEST_CASE("slurm: tasks are counted by their states", "[class][slurm]")
{
    const slurm::TaskCounts counts = slurm::parsed_counts(
        {"PENDING|Resources", "RUNNING|None", "COMPLETING|None", "COMPLETED|None", "FAILED|x",
         "NODE_FAIL|None", "CANCELLED|None", "slurm_load_jobs error: not a state", ""});
    CHECK(counts.waiting == 1);
    CHECK(counts.running == 2);
    CHECK(counts.cancelled == 1);
    CHECK(counts.reason == "Resources");
    CHECK(!counts.is_over());
    CHECK(slurm::parsed_counts({"COMPLETED|None", "TIMEOUT|TimeLimit"}).is_over());
    CHECK(!slurm::parsed_counts({"A_STATE_OF_ANOTHER_VERSION|None"}).is_over());
}

} // namespace rigor::testing
