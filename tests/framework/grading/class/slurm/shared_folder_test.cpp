// SPDX-License-Identifier: MIT
#include "grading/class/slurm/shared_folder.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing {

TEST_CASE("slurm: a plan comes back as it was written", "[class][slurm]")
{
    const TemporaryFolder folder;
    const slurm::SharedFolder shared(folder.path(), "run");
    shared.make();
    slurm::Plan plan;
    plan.run = "run";
    plan.round = 2;
    plan.assignment = "a4-collision";
    plan.out = folder.path().string();
    plan.secret_file = "/home/course/secret";
    plan.seed = 4000000000u;
    plan.fingerprint = 0xfedcba9876543210u;
    plan.submissions = {{"bob \"b\"", "/in/bob", ""},
                        {"carol\\xff", "/in/carol\xff", "expected a name in UTF-8"}};
    plan.fingerprints = {"0001", "0002"};
    plan.chunks = {{1}, {0}};
    const slurm::Plan read = slurm::read_plan(shared.write_plan(plan));
    CHECK(read.run == plan.run);
    CHECK(read.round == plan.round);
    CHECK(read.assignment == plan.assignment);
    CHECK(read.out == plan.out);
    CHECK(read.secret_file == plan.secret_file);
    CHECK(read.seed == plan.seed);
    CHECK(read.fingerprint == plan.fingerprint);
    REQUIRE(read.submissions.size() == 2);
    for (int i = 0; i < 2; ++i) {
        CHECK(read.submissions[i].name == plan.submissions[i].name);
        CHECK(read.submissions[i].refusal == plan.submissions[i].refusal);
    }
    CHECK(read.submissions[0].path == plan.submissions[0].path);
    CHECK(read.submissions[1].path.empty()); // it is not read
    CHECK(read.fingerprints == plan.fingerprints);
    CHECK(read.chunks == plan.chunks);
}

TEST_CASE("slurm: a class in a folder that no plan can name is refused", "[class][slurm]")
{
    const TemporaryFolder folder;
    const slurm::SharedFolder shared(folder.path(), "run");
    shared.make();
    slurm::Plan plan;
    plan.out = folder.path().string();
    plan.submissions = {{"alice", "/in\xff/alice", ""}};
    plan.fingerprints = {"0001"};
    plan.chunks = {{0}};
    CHECK_THROWS_AS(shared.write_plan(plan), InputError);
    plan.submissions.clear();
    plan.out = "/out\xff";
    CHECK_THROWS_AS(shared.write_plan(plan), InputError);
}

TEST_CASE("slurm: what is no plan is one clear error", "[class][slurm]")
{
    const TemporaryFolder folder;
    for (const char* text : {"", "{}", "[1, 2]", "{\"round\": 1"})
        CHECK_THROWS_AS(slurm::read_plan(folder.write("plan", text)), InputError);
    CHECK_THROWS_AS(slurm::read_plan(folder.path() / "none"), InputError);
    // A chunk has a submission that the plan lacks.
    CHECK_THROWS_AS(
        slurm::read_plan(folder.write(
            "plan", R"({"run": "run", "round": 1, "assignment": "a0", "out": "/", "seed": 0,
                        "secret_file": "", "fingerprint": 1, "submissions": [],
                        "chunks": [[0]]})")),
        InputError);
}

TEST_CASE("slurm: results and ends of tasks are seen whole or not at all", "[class][slurm]")
{
    const TemporaryFolder folder;
    const slurm::SharedFolder shared(folder.path(), "run");
    shared.make();
    CHECK(!shared.graded("00ff"));
    shared.write_graded("00ff", {{"result.json", "{}"}, {"report.txt", "half"}});
    shared.write_graded("00ff", {{"result.json", "{}"}, {"report.txt", "whole"}});
    folder.write(".rigor/slurm/run/graded/00aa.7__n1.new", "{");
    CHECK(shared.all_graded() == std::set<std::string>{"00ff"});
    REQUIRE(shared.graded("00ff"));
    CHECK(shared.graded("00ff")->at("report.txt") == "whole");
    shared.write_ended(1, 11);
    shared.write_ended(11, 1);
    CHECK(shared.ended(1, 12) == std::set<std::size_t>{11});
    shared.remove();
    CHECK(!std::filesystem::exists(folder.path() / ".rigor/slurm"));
}

TEST_CASE("slurm: only tasks that this job has are counted", "[class][slurm]")
{
    const TemporaryFolder folder;
    const slurm::SharedFolder shared(folder.path(), "run");
    shared.make();
    for (const std::size_t task : {0, 2, 3})
        shared.write_ended(1, task);
    folder.write(".rigor/slurm/run/ended/1.x", "");
    folder.write(".rigor/slurm/run/ended/1.99999999999999999999999", "");
    CHECK(shared.ended(1, 3) == std::set<std::size_t>{0, 2});
}

TEST_CASE("slurm: each run has a folder of its own", "[class][slurm]")
{
    const TemporaryFolder folder;
    const std::string name = slurm::new_run();
    CHECK(name.size() == 16);
    REQUIRE(slurm::new_run() != name);
    const slurm::SharedFolder old(folder.path(), name), shared(folder.path(), slurm::new_run());
    CHECK(slurm::SharedFolder::all(folder.path()).empty());
    old.make();
    shared.make();
    CHECK(slurm::SharedFolder::all(folder.path()).size() == 2);
    old.write_job("7");
    old.write_graded("00ff", {{"result.json", "{}"}});
    old.write_ended(1, 0);
    old.write_control_fault("wrong");
    CHECK(shared.job().empty());
    CHECK(shared.all_graded().empty());
    CHECK(shared.ended(1, 1).empty());
    CHECK(shared.control_fault().empty());
    shared.remove();
    CHECK(old.job() == "7");
}

} // namespace rigor::testing
