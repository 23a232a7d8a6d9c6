// SPDX-License-Identifier: MIT
// A shell script takes the place of the test program. The submissions are refused, so that nothing
// but the control is built.
#include "grading/class/local_engine.hpp"

#include "framework/grading/class/one_task.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>

namespace rigor::testing::local_engine_test {

namespace fs = std::filesystem;

namespace {

constexpr const char* tests = R"(#!/bin/sh
cat >&3 <<end
{"begin":"topic: a law","tag":"A2.1"}
{"tag":"A2.1","name":"topic: a law","status":"failed","message":"m","expected":"","actual":"","error":0,"tolerance":0,"class":"","seed":-1,"hidden":false,"seconds":0.1}
{"end":true}
end
)";

} // namespace

TEST_CASE("local engine: a change of the tests ends the run with its name", "[class]")
{
    const TemporaryFolder folder;
    ClassWork work;
    work.selection = one_task();
    work.run.test_program = folder.write("tests", tests);
    fs::permissions(work.run.test_program, fs::perms::owner_all);
    work.parts = shared_parts(work.selection, work.run);
    work.submissions = {{"alice", "", "refused"}, {"bob", "", "refused"}};
    work.fingerprints = {"of_alice", "of_bob"};
    work.out = folder.path();
    // The tests change before a result is passed on that has this number.
    const auto passed_on = [&](std::size_t number_of_the_change) {
        std::size_t count = 0;
        const auto grade = [&] {
            return LocalEngine(1).grade(
                work, {0, 1}, [&](std::size_t, const ResultFiles&) { ++count; },
                [&](const std::string& doing, const std::string&) {
                    if (doing == "grading" && count == number_of_the_change)
                        std::ofstream(work.run.test_program, std::ios::app) << "# changed\n";
                });
        };
        if (number_of_the_change > 2)
            CHECK(grade().empty());
        else
            CHECK_THROWS_WITH(grade(), Catch::Contains("found changes in the tests"));
        return count;
    };
    CHECK(passed_on(3) == 2);
    CHECK(passed_on(1) == 1);
}

} // namespace rigor::testing::local_engine_test
