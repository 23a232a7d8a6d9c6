// SPDX-License-Identifier: MIT
// `rigor check` under other umasks. Where root grades, the compiler and the worker are other users,
// who must reach what is theirs and must not be able to change anything else.
#include "command.hpp"
#include "grading/build/compiled_folder.hpp"
#include "grading/build/submission_build.hpp"
#include "sandbox/tier.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing::umask_test {

namespace {

namespace fs = std::filesystem;

Run checked_under(const std::string& umask, const std::string& tier, const fs::path& submission)
{
    const std::string program = std::string(RIGOR_BINARY_DIR) + "/bin/rigor";
    Command command;
    command.arguments = {"/bin/sh", "-c",     "umask " + umask + "; exec \"$@\"",
                         "sh",      program,  "check",
                         "A2.14",   "--with", submission.string()};
    command.environment = {"RIGOR_TIER=" + tier};
    return run_command(command);
}

std::string first_that_all_may_change(const fs::path& folder)
{
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_symlink() &&
            (entry.status().permissions() & fs::perms::others_write) != fs::perms::none)
            return entry.path().string();
    return "";
}

} // namespace

TEST_CASE("umask: a submission passes under any and leaves nothing that all may change",
          "[cli][submission]")
{
    for (const auto& [name, tier] : {std::pair("A", Tier::a), std::pair("B", Tier::b)})
        for (const char* umask : {"077", "027", "000"}) {
            if (!is_possible(tier, possible_walls())) continue;
            const TemporaryFolder folder; // another one each time, so that all is built anew
            fs::copy_file(RIGOR_SOURCE_DIR "/tests/samples/complete/inertia.cpp",
                          folder.path() / "inertia.cpp");
            const Run run = checked_under(umask, name, folder.path());
            CAPTURE(umask, name, run.output);
            CHECK(run.status == 0);
            const fs::path place = CompiledFolder::place_of(folder.path());
            CHECK(fs::exists(place / "worker"));
            CHECK(first_that_all_may_change(place) == "");
            remove_submission_build(folder.path());
        }
}

} // namespace rigor::testing::umask_test
