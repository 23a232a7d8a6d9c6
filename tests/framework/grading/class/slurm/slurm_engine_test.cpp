// SPDX-License-Identifier: MIT
// The engine with scripts in place of Slurm's commands. No task runs: while the engine waits for
// one, the test writes what it would write.
#include "grading/class/slurm/slurm_engine.hpp"

#include "errors/input_error.hpp"
#include "framework/grading/class/one_task.hpp"
#include "grading/build/submission_files.hpp"
#include "grading/class/slurm/shared_folder.hpp"
#include "grading/places.hpp"
#include "report/exports/row.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <map>

namespace rigor::testing::slurm_engine_test {

namespace fs = std::filesystem;

namespace {

// A class of three submissions, its results' folder, and Slurm's commands, which note what they are
// asked. Slurm gives each job the number 8.
class FakeSlurm {
public:
    // @param squeue  the commands of squeue, which may call `note WORD`
    explicit FakeSlurm(const std::string& squeue)
    {
        write_command("sbatch", "note sbatch; echo 8");
        write_command("scancel", "for job; do :; done; note scancel $job");
        write_command("squeue", squeue);
        setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
        work.out = folder_.path() / "out";
        fs::create_directories(work.out);
        work.selection = one_task();
        for (const char* name : {"alice", "bob", "carol"}) {
            work.submissions.push_back({name, "", "refused"});
            work.fingerprints.push_back(fmt::format("of_{}", name));
        }
        work.run.test_program = folder_.write("tests", "1");
        work.parts = shared_parts(work.selection, work.run);
    }
    ~FakeSlurm() { setenv("PATH", path_.c_str(), 1); }
    FakeSlurm(const FakeSlurm&) = delete;
    FakeSlurm& operator=(const FakeSlurm&) = delete;

    ResultFiles result_of(std::size_t i) const
    {
        return graded_submission(work.selection, work.submissions[i], work.run, "",
                                 work.fingerprints[i]);
    }

    // Grades these submissions. @param task  does what the tasks of the job would do
    std::string grade(const std::vector<std::size_t>& numbers,
                      const std::function<void(const slurm::SharedFolder&)>& task)
    {
        SlurmEngine engine(SlurmOptions{{"true"}, "", 8, 0, {}});
        return engine.grade(
            work, numbers,
            [&](std::size_t i, const ResultFiles& files) {
                rows[i] = read_row(files.at("result.json")).value();
            },
            [&](const std::string& doing, const std::string&) {
                for (const slurm::SharedFolder& shared : slurm::SharedFolder::all(work.out))
                    if (doing == "grading" && shared.job() == "8") task(shared);
            });
    }

    // A file of a task that may still run.
    fs::path file_of_a_task() const
    {
        const fs::path folder = places().build / "grading" /
                                fmt::format("{:016x}", hash_of(work.out.string())) / "7_.0";
        fs::create_directories(folder);
        std::ofstream(folder / "inertia.cpp") << "// a task compiles this\n";
        return folder / "inertia.cpp";
    }

    std::string notes() const
    {
        std::ifstream in(folder_.path() / "notes");
        std::string notes;
        for (std::string line; std::getline(in, line);)
            notes += line + "; ";
        return notes;
    }

    ClassWork work;
    std::map<std::size_t, Row> rows;

private:
    void write_command(const std::string& name, const std::string& commands) const
    {
        const fs::path notes = folder_.path() / "notes";
        fs::permissions(folder_.write(name, "#!/bin/sh\nnote() { echo \"$*\" >> " + notes.string() +
                                                "; }\nnotes=" + notes.string() + "\n" + commands +
                                                "\n"),
                        fs::perms::owner_all);
    }

    TemporaryFolder folder_;
    std::string path_ = std::getenv("PATH") ? std::getenv("PATH") : "";
};

// For squeue: a job runs, and ends slowly after it was canceled. Each answer then notes whether
// `file` is still there.
std::string ends_slowly(const fs::path& file)
{
    return "job=$(echo \"$*\" | sed 's/.*--jobs=//; s/ .*//')\n"
           "grep -q \"scancel $job\" $notes || { echo 'RUNNING|None'; exit; }\n"
           "test -e " +
           file.string() +
           " && note there || note gone\n"
           "test $(grep -c there $notes) -lt 3 && echo 'COMPLETING|None' || echo 'CANCELLED|None'";
}

} // namespace

TEST_CASE("slurm: what the tasks of a broken run work with stays until they have ended",
          "[class][slurm]")
{
    // The name of a temporary folder is only known when it exists.
    const TemporaryFolder link;
    FakeSlurm slurm(ends_slowly(link.path() / "file"));
    const fs::path file = slurm.file_of_a_task();
    fs::create_symlink(file, link.path() / "file");
    const slurm::SharedFolder broken(slurm.work.out, "broken");
    broken.make();
    broken.write_job("7");
    CHECK(slurm.grade({}, [](const slurm::SharedFolder& shared) { shared.write_ended(1, 0); })
              .empty());
    CHECK(slurm.notes() == "scancel 7; there; there; there; sbatch; ");
    CHECK(!fs::exists(file));
    CHECK(!fs::exists(slurm.work.out / ".rigor/slurm"));
}

TEST_CASE("slurm: as long as nobody knows whether a broken run has ended nothing is removed",
          "[class][slurm]")
{
    FakeSlurm slurm("note squeue; echo 'slurm_load_jobs error: Unable to contact'; exit 1");
    const fs::path file = slurm.file_of_a_task();
    const slurm::SharedFolder broken(slurm.work.out, "broken");
    broken.make();
    broken.write_job("7");
    CHECK_THROWS_AS(slurm.grade({}, [](const slurm::SharedFolder&) {}), InputError);
    CHECK(slurm.notes() == "scancel 7; squeue; ");
    CHECK(fs::exists(file));
    CHECK(broken.job() == "7");
    fs::remove_all(file.parent_path().parent_path());
}

TEST_CASE("slurm: after a wrong control nothing is removed until the tasks have ended",
          "[class][slurm]")
{
    const TemporaryFolder link;
    FakeSlurm slurm(ends_slowly(link.path() / "file"));
    fs::path file;
    const std::string fault = slurm.grade({0}, [&](const slurm::SharedFolder& shared) {
        file = slurm.file_of_a_task();
        fs::create_symlink(file, link.path() / "file");
        shared.write_control_fault("control after the last submission");
    });
    CHECK(fault == "control after the last submission");
    CHECK(slurm.notes() == "sbatch; scancel 8; there; there; there; ");
    CHECK(!fs::exists(file));
    CHECK(!fs::exists(slurm.work.out / ".rigor/slurm"));
}

TEST_CASE("slurm: of a broken run only right results count", "[class][slurm]")
{
    FakeSlurm slurm("echo 'RUNNING|None'");
    const slurm::SharedFolder broken(slurm.work.out, "broken"), wrong(slurm.work.out, "wrong");
    for (const slurm::SharedFolder& old : {broken, wrong}) {
        old.make();
        old.write_ended(1, 0);
    }
    broken.write_graded("of_alice", slurm.result_of(0));
    broken.write_graded("of_bob", faulty_submission(slurm.work.selection, slurm.work.submissions[1],
                                                    slurm.work.run, "a fault"));
    wrong.write_graded("of_carol", slurm.result_of(2));
    wrong.write_control_fault("control before the first submission");
    std::size_t taken_over = 0;
    const std::string fault = slurm.grade({0, 1, 2}, [&](const slurm::SharedFolder& shared) {
        taken_over = slurm.rows.size();
        CHECK(slurm::SharedFolder::all(slurm.work.out).size() == 1);
        for (const std::size_t i : {1, 2})
            shared.write_graded(slurm.work.fingerprints[i], slurm.result_of(i));
        shared.write_ended(1, 0);
    });
    CHECK(fault.empty());
    CHECK(taken_over == 1);
    REQUIRE(slurm.rows.size() == 3);
    for (const auto& [i, row] : slurm.rows)
        CHECK(row.fingerprint == slurm.work.fingerprints[i]);
}

TEST_CASE("slurm: after a change of the tests no further job is submitted", "[class][slurm]")
{
    FakeSlurm slurm("cd $(dirname $notes)/out/.rigor/slurm\n"
                    "ls */log/1_0.txt && echo 'NODE_FAIL|None' || echo 'RUNNING|None'");
    const auto task = [&](const slurm::SharedFolder& shared) {
        shared.write_graded("of_alice", slurm.result_of(0));
        std::ofstream(shared.log_pattern(1).parent_path() / "1_0.txt") << "begun\n";
        std::ofstream(slurm.work.run.test_program) << "2";
    };
    CHECK_THROWS_WITH(slurm.grade({0, 1}, task), Catch::Contains("found changes in the tests"));
    CHECK(slurm.notes() == "sbatch; ");
    CHECK(slurm.rows.size() == 1);
}

} // namespace rigor::testing::slurm_engine_test
