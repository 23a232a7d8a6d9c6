// SPDX-License-Identifier: MIT
#include "cli/test_run.hpp"

#include "cli/progress.hpp"
#include "grading/build/ninja.hpp"
#include "grading/machine/allotment.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "report/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

SuiteResult tell(const std::string& name, SuiteResult::Verdict verdict, const std::string& detail)
{
    constexpr std::pair<const char*, Color> looks[] = {
        {"passed", Color::green}, {"FAILED", Color::red}, {"skipped", Color::yellow}};
    const auto& [words, color] = looks[verdict];
    fmt::print("  {} {} {}\n", padded(name, 44),
               colored(padded(words, 8), color, wants_color(STDOUT_FILENO)), detail);
    std::fflush(stdout);
    return {name, verdict};
}

std::vector<fs::path> sources()
{
    std::vector<fs::path> result;
    for (const char* folder : {"framework", "student", "reference", "tests"})
        if (fs::is_directory(places().source / folder))
            for (const auto& entry : fs::recursive_directory_iterator(places().source / folder))
                if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
                    result.push_back(entry.path());
    std::sort(result.begin(), result.end());
    return result;
}

// The last lines of a long output.
class Tail {
public:
    void take(std::string_view line)
    {
        lines_.emplace_back(line);
        constexpr std::size_t most_lines = 60; // enough to see why a build failed
        if (lines_.size() > most_lines) lines_.erase(lines_.begin());
    }
    void print() const
    {
        for (const std::string& line : lines_)
            fmt::print("    {}\n", line);
    }

private:
    std::vector<std::string> lines_;
};

// Runs one command of a build, such as `cmake --preset`. @return whether the command succeeded
bool make(const std::string& name, const Command& command)
{
    Tail tail;
    Progress progress(name);
    const Ended ended = run(command, [&](std::string_view line) {
        int done = 0, total = 0;
        if (std::sscanf(std::string(line.substr(0, 40)).c_str(), "[%d/%d]", &done, &total) == 2 &&
            total > 0)
            progress.update(static_cast<double>(done) / total,
                            std::string(line.substr(line.rfind('/') + 1)));
        else
            tail.take(line);
    });
    progress.clear();
    tell(name, ended.ok() ? SuiteResult::passed : SuiteResult::failed,
         fmt::format("{:.1f} s", ended.seconds));
    if (!ended.ok()) tail.print();
    return ended.ok();
}

// Turns CTest's lines, such as
//     "1/12 Test  #1: framework.scene ......   Passed    0.05 sec",
// into verdicts, and prints the output of each failed test.
class CTestLines {
public:
    CTestLines(const std::string& preset, std::vector<SuiteResult>& results)
        : preset_(preset), results_(results)
    {
    }

    void take(const std::string& line)
    {
        int number = 0, total = 0, index = 0;
        if (std::sscanf(line.c_str(), " %d/%d Test #%d:", &number, &total, &index) == 3) {
            take_verdict(line);
        } else if (line.find(" tests passed, ") != std::string::npos) {
            showing_ = false; // CTest's summary follows, which is not shown
        } else if (showing_) {
            fmt::print("    {}\n", line);
        }
    }

private:
    void take_verdict(const std::string& line)
    {
        const std::size_t start = line.find(": ", line.find('#')) + 2;
        const std::string name = preset_ + "  " + line.substr(start, line.find(' ', start) - start);
        const std::size_t seconds = line.find_last_not_of(" 0123456789.sec");
        const bool passed = line.find(" Passed ") != std::string::npos,
                   skipped = line.find("Skipped") != std::string::npos;
        const std::string time = seconds == std::string::npos
                                     ? ""
                                     : line.substr(line.find_first_not_of(' ', seconds + 1));
        results_.push_back(tell(name,
                                passed    ? SuiteResult::passed
                                : skipped ? SuiteResult::skipped
                                          : SuiteResult::failed,
                                time));
        showing_ = results_.back().verdict == SuiteResult::failed;
    }

    std::string preset_;
    std::vector<SuiteResult>& results_;
    bool showing_ = false;
};

// The longest time for a test [s]. A test that takes longer fails, so that a test that hangs does
// not keep the others from running.
constexpr const char* longest_test = "1200";

SuiteResult build_preset(const std::string& preset, const fs::path& build, SuiteSize size)
{
    fs::create_directories(build);
    const BuildLock lock(build); // released before the tests, which take it to build submissions
    if (!fs::exists(build / "build.ninja")) {
        Command configure;
        configure.arguments = {"cmake", "--preset", preset};
        configure.folder = places().source;
        if (!make(preset + "  configure", configure))
            return {preset + "  configure", SuiteResult::failed};
    }
    Command ninja;
    ninja.arguments = {"ninja", "-C", build.string(),
                       "-k",    "0",  size == SuiteSize::all ? "all" : "sample"};
    ninja.environment = {"NINJA_STATUS=[%f/%t] "};
    return {preset + "  build",
            make(preset + "  build", ninja) ? SuiteResult::passed : SuiteResult::failed};
}

// Whether clang++ is installed with its sanitizers.
bool has_clang()
{
    Command command;
    command.arguments = {"sh", "-c",
                         "echo 'int main() {}' | "
                         "clang++ -fsanitize=address,undefined -x c++ - -o /dev/null"};
    return run(command, [](std::string_view) {}).ok();
}

} // namespace

SuiteResult check_format()
{
    if (!is_installed("clang-format"))
        return tell("format", SuiteResult::skipped, "clang-format is not installed");
    Command command;
    command.arguments = {"clang-format", "--dry-run", "--Werror"};
    for (const fs::path& source : sources())
        command.arguments.push_back(source.string());
    constexpr std::size_t longest_line = 200, most_lines = 10; // limits of the printed errors
    std::vector<std::string> wrong;
    const Ended ended = run(command, [&](std::string_view line) {
        if (line.find("error: ") != std::string::npos)
            wrong.emplace_back(line.substr(0, longest_line));
    });
    tell("format", ended.ok() ? SuiteResult::passed : SuiteResult::failed,
         fmt::format("{:.1f} s", ended.seconds));
    for (std::size_t i = 0; i < wrong.size() && i < most_lines; ++i)
        fmt::print("    {}\n", wrong[i]);
    return {"format", ended.ok() ? SuiteResult::passed : SuiteResult::failed};
}

std::vector<SuiteResult> run_preset(const std::string& preset, SuiteSize size)
{
    if (preset == "clang" && !has_clang())
        return {tell("clang", SuiteResult::skipped,
                     "not installed: apt-get install clang libclang-rt-dev")};
    const fs::path build = places().source / "build" / preset;
    const SuiteResult built = build_preset(preset, build, size);
    if (built.verdict == SuiteResult::failed) return {built};

    std::vector<SuiteResult> results = {built};
    CTestLines lines(preset, results);
    // Some tests wait for time limits, so there is one more of them than processors.
    const unsigned jobs = usable_processors() + 1;
    Command ctest;
    ctest.arguments = {"ctest",
                       "--test-dir",
                       build.string(),
                       "-LE",
                       size == SuiteSize::all ? "^(sample|proof)$" : "^(long|proof)$",
                       "--output-on-failure",
                       "--no-tests=error",
                       "--timeout",
                       longest_test,
                       "-j" + std::to_string(jobs)};
    const Ended ended = run(ctest, [&](std::string_view line) { lines.take(std::string(line)); });
    const auto failed = [](const SuiteResult& result) {
        return result.verdict == SuiteResult::failed;
    };
    const bool told = std::any_of(results.begin(), results.end(), failed);
    if (!ended.ok() && !told)
        results.push_back(tell(preset + "  ctest", SuiteResult::failed, "it ran no test"));
    return results;
}

} // namespace rigor
