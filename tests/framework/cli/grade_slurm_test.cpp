// SPDX-License-Identifier: MIT
// `rigor grade --engine slurm` on a cluster of three nodes that runs on this machine.
#include "class/made_class.hpp"
#include "class/slurm_cluster.hpp"
#include "command.hpp"
#include "graded_class.hpp"
#include "grading/build/submission_files.hpp"
#include "grading/class/slurm/commands.hpp"
#include "grading/class/slurm/shared_folder.hpp"
#include "sandbox/argument_pointers.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace rigor::testing::grade_slurm_test {

namespace {

namespace fs = std::filesystem;

constexpr int not_prepared = 99; // an exit status

bool is_left_out()
{
    if (SlurmCluster::is_possible()) return false;
    WARN("left out: not installed: apt-get install slurm-wlm munge");
    return true;
}

std::vector<std::string> slurm_arguments(const fs::path& submissions, const fs::path& out)
{
    return {"grade",   "a0", submissions.string(), "--out", out.string(), "--engine", "slurm",
            "--chunk", "2"};
}

// Starts `rigor grade` in a new process, whose output goes to a file.
// @param prepare  called in the new process, which ends if the result is false
pid_t started(
    const fs::path& submissions, const fs::path& out, const fs::path& output,
    const std::function<bool()>& prepare = [] { return true; })
{
    std::vector<std::string> arguments = slurm_arguments(submissions, out);
    arguments.insert(arguments.begin(), std::string(RIGOR_BINARY_DIR) + "/bin/rigor");
    const std::vector<char*> pointers = argument_pointers(arguments);
    const pid_t process = fork();
    if (process == 0) {
        setpgid(0, 0);
        if (!std::freopen(output.c_str(), "w", stdout) || dup2(STDOUT_FILENO, STDERR_FILENO) < 0)
            _exit(126);
        if (!prepare()) _exit(not_prepared);
        execv(pointers[0], pointers.data());
        _exit(127);
    }
    return process;
}

bool comes_true(const std::function<bool()>& is_so, int seconds = 120)
{
    for (int i = 0; i < 20 * seconds && !is_so(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return is_so();
}

std::size_t results_in(const fs::path& out)
{
    std::size_t count = 0;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(out, error))
        count += fs::exists(entry.path() / "result.json");
    return count;
}

int state_of(pid_t process)
{
    int state = 0;
    REQUIRE(waitpid(process, &state, 0) == process);
    return state;
}

// The number of the job, which the run wrote to its folder. It is empty while there is none, or
// while an earlier run has a folder too.
std::string job_of(const fs::path& out)
{
    const std::vector<slurm::SharedFolder> runs = slurm::SharedFolder::all(out);
    return runs.size() == 1 ? runs[0].job() : "";
}

// Whether none of the tasks of a job runs any more.
bool is_over(const std::string& job, const fs::path& out)
{
    const std::string name = fmt::format("rigor-{:016x}", hash_of(fs::canonical(out).string()));
    const auto counts = slurm::task_counts(job, name);
    return counts && counts->is_over();
}

} // namespace

TEST_CASE("slurm: a class whose node is lost has the gradebook of one machine bit for bit",
          "[.long][class][slurm]")
{
    if (is_left_out()) return;
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 12), local = folder.path() / "local",
                   out = folder.path() / "slurm", output = folder.path() / "output";
    REQUIRE(rigor({"grade", "a0", submissions.string(), "--out", local.string()}).status == 0);

    SlurmCluster cluster;
    const pid_t process = started(submissions, out, output);
    // A node is lost in the middle of the run: it is busy, and some results are there.
    const bool is_in_the_middle =
        comes_true([&] { return results_in(out) >= 1 && cluster.is_busy(2); });
    CAPTURE(text_in(output));
    REQUIRE(is_in_the_middle);
    CHECK(results_in(out) < 12);
    cluster.lose(2);
    const int state = state_of(process);
    CAPTURE(text_in(output));
    REQUIRE(WIFEXITED(state));
    CHECK(WEXITSTATUS(state) == 0);
    CHECK(class_files(out) == class_files(local));
    CHECK(!has_drafts(out));
    CHECK(!fs::exists(out / ".rigor/slurm"));

    const Run again = rigor({"grade", "a0", submissions.string(), "--out", out.string()});
    CHECK(contains(again.output, "0 graded now, 12 as before"));
}

TEST_CASE("slurm: a run that is killed goes on where it was", "[.long][class][slurm]")
{
    if (is_left_out()) return;
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 8), local = folder.path() / "local",
                   out = folder.path() / "slurm", output = folder.path() / "output";
    REQUIRE(rigor({"grade", "a0", submissions.string(), "--out", local.string()}).status == 0);
    const SlurmCluster cluster;
    const pid_t process = started(submissions, out, output);
    REQUIRE(comes_true([&] { return results_in(out) >= 1; }));
    kill(process, SIGKILL);
    REQUIRE(WIFSIGNALED(state_of(process)));
    const Run resumed = rigor(slurm_arguments(submissions, out));
    CAPTURE(resumed.output);
    REQUIRE(resumed.status == 0);
    CHECK(!contains(resumed.output, "8 graded now"));
    CHECK(class_files(out) == class_files(local));
    CHECK(!fs::exists(out / ".rigor/slurm"));
}

TEST_CASE("slurm: what goes wrong with the cluster is one line", "[.long][class][slurm]")
{
    if (is_left_out()) return;
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 6), out = folder.path() / "slurm",
                   output = folder.path() / "output";
    SlurmCluster cluster;

    // Ctrl-C ends the job.
    pid_t process = started(submissions, out, output);
    REQUIRE(comes_true([&] { return !job_of(out).empty() && cluster.is_busy(1); }));
    kill(process, SIGINT);
    int state = state_of(process);
    CHECK((WIFSIGNALED(state) && WTERMSIG(state) == SIGINT));
    CHECK(contains(text_in(output), "is cancelled, and the same command goes on from here"));
    std::string job = job_of(out);
    CHECK(is_over(job, out));

    // Somebody cancels the job.
    process = started(submissions, out, output);
    REQUIRE(comes_true(
        [&] { return !job_of(out).empty() && job_of(out) != job && cluster.is_busy(1); }));
    job = job_of(out);
    REQUIRE(rigor::run({{"scancel", job}, {}, 60, 0, {}, false}, [](std::string_view) {}).ok());
    state = state_of(process);
    CAPTURE(text_in(output));
    CHECK((WIFEXITED(state) && WEXITSTATUS(state) == 2));
    CHECK(is_one_line(without_waiting(text_in(output)), "job " + job + " was cancelled"));

    // The controller does not answer.
    cluster.stop_controller();
    const Run silent = rigor(slurm_arguments(submissions, out));
    CAPTURE(silent.output);
    CHECK(silent.status == 2);
    CHECK(is_one_line(silent.output, "Slurm does not answer"));
}

TEST_CASE("slurm: a results folder that the nodes do not see is one line", "[.long][class][slurm]")
{
    if (is_left_out()) return;
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 2), out = folder.path() / "own/out";
    fs::create_directories(folder.path() / "own");
    const SlurmCluster cluster;
    // The run has its own view of the file system (mount namespace), in which another folder takes
    // the place of this one.
    const fs::path output = folder.path() / "output";
    const pid_t process = started(submissions, out, output, [&] {
        return unshare(CLONE_NEWNS) == 0 &&
               mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               mount("tmpfs", (folder.path() / "own").c_str(), "tmpfs", 0, nullptr) == 0;
    });
    const int state = state_of(process);
    if (WIFEXITED(state) && WEXITSTATUS(state) == not_prepared) {
        WARN("left out: this user cannot have a view of the file system of its own");
        return;
    }
    CAPTURE(text_in(output));
    CHECK((WIFEXITED(state) && WEXITSTATUS(state) == 2));
    CHECK(is_one_line(without_waiting(text_in(output)), "expected a folder that all nodes see"));
}

TEST_CASE("slurm: without Slurm the command says so in one line", "[cli][class][slurm]")
{
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 1), out = folder.path() / "out";
    const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
    const fs::path ninja_alone = folder.path() / "ninja_alone"; // `rigor` builds `rigor_class`
    fs::create_directory(ninja_alone);
    fs::create_symlink(RIGOR_NINJA, ninja_alone / "ninja");
    setenv("PATH", ninja_alone.c_str(), 1);
    const Run missing = rigor(slurm_arguments(submissions, out));
    setenv("PATH", path.c_str(), 1);
    CHECK(missing.status == 2);
    CHECK(is_one_line(missing.output, "found no sbatch in PATH"));
    CHECK(!fs::exists(out));
    const Run unknown =
        rigor({"grade", "a0", submissions.string(), "--out", out.string(), "--engine", "slrum"});
    CHECK(unknown.status == 2);
    CHECK(is_one_line(unknown.output, "expected local or slurm, found \"slrum\""));
    const Run chunk =
        rigor({"grade", "a0", submissions.string(), "--out", out.string(), "--chunk", "2"});
    CHECK(chunk.status == 2);
    const Run outside = rigor({"grade-chunk", (out / "plan").string()});
    CHECK(outside.status == 2);
    CHECK(is_one_line(outside.output, "SLURM_ARRAY_TASK_ID is not set"));
}

} // namespace rigor::testing::grade_slurm_test
