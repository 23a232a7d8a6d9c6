// SPDX-License-Identifier: MIT
// Grading one submission: the tests of each topic, what a formula that never returns costs, and the
// same by one ordinary program; with RIGOR_BEFORE also the time of `check` in another tree.
// Grading a class: submissions a minute with one and with two jobs, whether both give the same
// gradebook, the time of a run in which nothing has changed, and the memory of the grader. The
// class has as many members as the variable RIGOR_CLASS_SIZE says.
#include "class/made_class.hpp"
#include "grading/places.hpp"
#include "one_submission.hpp"
#include "ordinary_way.hpp"
#include "support/bench/bench.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace rigor;
using namespace rigor::testing;
namespace fs = std::filesystem;

constexpr const char* topic = "kinematics";
constexpr const char* assignment = "a1";
constexpr int many = 1000, few = 100; // submissions without a file

struct GradeRun {
    double seconds = 0;
    double megabytes = 0; // largest memory of the grader itself
};

// The largest resident memory of a process so far [MB]; 0 if it has ended.
double peak_memory(pid_t process)
{
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
    return 0;
}

GradeRun grade(const fs::path& submissions, const fs::path& out, const char* jobs)
{
    const std::string program = places().program("rigor").string();
    const auto start = std::chrono::steady_clock::now();
    const pid_t process = fork();
    if (process == 0) {
        const int nothing = open("/dev/null", O_WRONLY);
        dup2(nothing, STDOUT_FILENO);
        dup2(nothing, STDERR_FILENO);
        execl(program.c_str(), "rigor", "grade", assignment, submissions.c_str(), "--out",
              out.c_str(), "--jobs", jobs, nullptr);
        _exit(127);
    }
    GradeRun run;
    int state = 0;
    while (waitpid(process, &state, WNOHANG) != process) {
        if (const double now = peak_memory(process); now > 0) run.megabytes = now;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!WIFEXITED(state) || WEXITSTATUS(state) != 0)
        throw std::runtime_error("rigor grade did not end with status 0");
    return run;
}

std::string gradebook(const fs::path& out)
{
    std::ifstream in(out / "gradebook.csv");
    return {std::istreambuf_iterator<char>(in), {}};
}

int class_size()
{
    const char* text = std::getenv("RIGOR_CLASS_SIZE");
    const int size = text ? std::atoi(text) : 24;
    if (size < 1) throw std::runtime_error("RIGOR_CLASS_SIZE: expected a number of submissions");
    return size;
}

void measure_jobs(Bench& bench, const fs::path& place)
{
    const int size = class_size();
    const fs::path submissions = place / "class", one = place / "one", two = place / "two";
    // What all submissions share is built before anything is measured.
    write_class(made_class(places().source, topic, 1, 0), topic, place / "first");
    grade(place / "first", place / "first.out", "1");
    const auto members = made_class(places().source, topic, size, 1);
    write_class(members, topic, submissions);
    const GradeRun slow = grade(submissions, one, "1"), fast = grade(submissions, two, "2");
    const GradeRun again = grade(submissions, two, "2");
    for (const auto& [jobs, run] : {std::pair("1", slow), std::pair("2", fast)})
        bench.row({{"jobs", jobs},
                   {"submissions", static_cast<double>(size)},
                   {"time [s]", run.seconds},
                   {"a minute", 60 * size / run.seconds},
                   {"memory [MB]", run.megabytes}});
    const bool is_same = !gradebook(one).empty() && gradebook(one) == gradebook(two);
    bench.reach(
        {"throughput of --jobs 2 over --jobs 1", slow.seconds / fast.seconds, 1.8, "higher"});
    bench.reach({"gradebooks that differ between --jobs 1 and 2", is_same ? 0.0 : 1.0, 0});
    bench.note("--jobs needs two processors with nothing else to do; nothing changed: " +
               std::to_string(again.seconds) + " s");
}

void measure_size(Bench& bench, const fs::path& place)
{
    double memory[2] = {}, unchanged = 0;
    for (const int count : {few, many}) {
        const fs::path submissions = place / ("empty" + std::to_string(count)),
                       out = submissions.string() + ".out";
        write_class(empty_class(count), topic, submissions);
        const GradeRun first = grade(submissions, out, "2"), again = grade(submissions, out, "2");
        memory[count == many] = first.megabytes;
        unchanged = again.seconds;
        bench.row({{"submissions without a file", static_cast<double>(count)},
                   {"time [s]", first.seconds},
                   {"nothing changed [s]", again.seconds},
                   {"memory [MB]", first.megabytes}});
    }
    bench.reach({"time of a run over 1000 known submissions [s]", unchanged, 5});
    bench.reach({"memory for 1000 submissions over that for 100", memory[1] / memory[0], 1.5});
}

} // namespace

int main(int argc, char** argv)
{
    try {
        Bench bench("grading");
        const TemporaryFolder place;
        measure_one_submission(bench);
        measure_ordinary_way(bench);
        measure_against_before(bench);
        measure_jobs(bench, place.path());
        measure_size(bench, place.path());
        return bench.finish(wants_json(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
