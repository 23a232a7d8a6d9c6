// SPDX-License-Identifier: MIT
// A shell script takes the place of the test program.
#include "grading/class/graded_submission.hpp"

#include "framework/grading/class/one_task.hpp"
#include "grading/build/submission_build.hpp"
#include "report/exports/row.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <stdexcept>

namespace rigor::testing::graded_submission_test {

namespace fs = std::filesystem;

namespace {

// A test program that judges a task of topic inertia, and then runs this shell command.
GradingRun run_that(const TemporaryFolder& folder, const std::string& command)
{
    const fs::path script = folder.write("tests", R"(#!/bin/sh
cat >&3 <<end
{"begin":"topic: a law","tag":"A2.1"}
{"tag":"A2.1","name":"topic: a law","status":"failed","message":"m","expected":"","actual":"","error":0,"tolerance":0,"class":"","seed":-1,"hidden":false,"seconds":0.1}
{"end":true}
end
)" + command + "\n");
    fs::permissions(script, fs::perms::owner_all);
    GradingRun run;
    run.test_program = script;
    return run;
}

} // namespace

TEST_CASE("graded submission: what is removed while it is graded costs no points", "[class]")
{
    const TemporaryFolder folder;
    const fs::path place = folder.path() / "place";
    const Submission submission{"alice", folder.write("inertia.cpp", "// nothing\n"), ""};
    const auto files_after = [&](const std::string& command) {
        fs::create_directories(place);
        return graded_submission(one_task(), submission, run_that(folder, command), place, "0001");
    };
    const std::optional<Row> row = read_row(files_after("").at("result.json"));
    REQUIRE(row);
    CHECK(row->status == "graded");
    CHECK(row->fingerprint == "0001");
    CHECK_THROWS_AS(files_after("rm -r " + place.string()), std::runtime_error);
    CHECK_THROWS_AS(files_after("echo >> " + (place / "inertia.cpp").string()), std::runtime_error);
    CHECK_THROWS_AS(files_after("rm \"$2\""), std::runtime_error); // the worker
    remove_submission_build(place);
}

} // namespace rigor::testing::graded_submission_test
