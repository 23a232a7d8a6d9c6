// SPDX-License-Identifier: MIT
// Runs ninja and parses what it prints. Each line is a step, the name of a failed output, its
// command, or a message of the compiler. The messages are cut to the first errors.
#include "grading/build/ninja.hpp"

#include "grading/places.hpp"
#include "grading/process.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <stdexcept>

namespace rigor {

namespace {

// The limit on the address space of ninja, and of each program that it starts [bytes].
constexpr std::uint64_t compiler_memory = std::uint64_t(6) << 30;
// The longest time between two lines that ninja prints [s]; it prints one after each file. Here
// ninja compiles only files of the framework, so only a slow or busy machine needs much time.
constexpr double longest_silence = 3600;

bool speaks_of_an_error(const std::string& line)
{
    return line.find("error:") != std::string::npos ||
           line.find("undefined reference") != std::string::npos ||
           line.find("undefined symbol") != std::string::npos;
}

// Sorts ninja's lines into steps, failures and the compiler's messages.
class NinjaLines {
public:
    NinjaLines(NinjaRun& run, const OnBuildStep& on_step) : run_(run), on_step_(on_step) {}

    void take(const std::string& line)
    {
        int done = 0, total = 0, length = 0;
        if (std::sscanf(line.c_str(), "[%d/%d] %n", &done, &total, &length) == 2 && length > 0) {
            take_step(done, total, line.substr(static_cast<std::size_t>(length)));
        } else if (line.rfind("FAILED: ", 0) == 0) {
            run_.failed.push_back(line.substr(8, line.find_last_not_of(' ') - 7));
            next_is_command_ = true;
        } else if (next_is_command_) {
            next_is_command_ = false;
        } else if (line.rfind("ninja: ", 0) != 0 || line.rfind("ninja: error", 0) == 0) {
            if (said_.size() < 2000) said_.push_back(line);
        }
    }

    const std::vector<std::string>& said() const { return said_; }

private:
    void take_step(int done, int total, const std::string& step)
    {
        if (step.rfind("Re-checking globbed", 0) == 0) return; // only CMake's search for new files
        run_.steps.push_back(step);
        if (on_step_) on_step_(done, total, step);
    }

    NinjaRun& run_;
    const OnBuildStep& on_step_;
    std::vector<std::string> said_;
    bool next_is_command_ = false;
};

} // namespace

NinjaRun run_ninja(const std::vector<std::string>& arguments, const OnBuildStep& on_step)
{
    Command command;
    command.arguments = {"ninja", "-C", places().build.string()};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    command.silence = longest_silence;
    command.memory = compiler_memory;
    command.environment = {"NINJA_STATUS=[%f/%t] "};

    NinjaRun result;
    NinjaLines lines(result, on_step);
    const Ended ended = run(command, [&](std::string_view line) { lines.take(std::string(line)); });
    result.ok = ended.ok();
    result.seconds = ended.seconds;
    if (!result.ok) result.errors = first_errors(lines.said());
    if (ended.timed_out)
        result.errors += fmt::format("no file was done within {} s\n", longest_silence);
    else if (ended.signal != 0)
        result.errors += fmt::format("ninja was ended by signal {}\n", ended.signal);
    return result;
}

std::vector<std::string> ninja_commands(const std::string& target)
{
    std::vector<std::string> result;
    Command command;
    command.arguments = {"ninja", "-C", places().build.string(), "-t", "commands", target};
    const Ended ended = run(command, [&](std::string_view line) {
        if (line.rfind("ninja: ", 0) != 0) result.emplace_back(line);
    });
    if (!ended.ok() || result.empty())
        throw std::runtime_error("ninja knows no commands for " + target);
    return result;
}

std::vector<std::string> ninja_programs(const std::string& prefix)
{
    std::vector<std::string> result;
    Command command;
    command.arguments = {"ninja", "-C", places().build.string(), "-t", "targets", "all"};
    run(command, [&](std::string_view line) {
        // The line of a program is, for example,
        //     bin/bench_spin: CXX_EXECUTABLE_LINKER__bench_spin_Release
        if (line.starts_with("bin/" + prefix))
            result.emplace_back(line.substr(4 + prefix.size(), line.find(':') - 4 - prefix.size()));
    });
    std::sort(result.begin(), result.end());
    return result;
}

std::string first_errors(const std::vector<std::string>& lines)
{
    constexpr std::size_t most_lines = 20, longest_line = 400;
    std::size_t first = 0;
    while (first < lines.size() && !speaks_of_an_error(lines[first]))
        ++first;
    if (first == lines.size()) first = 0; // no line names an error
    if (first > 0 && lines[first - 1].find(": In ") != std::string::npos)
        --first; // include the line "… In function …:"
    std::string result;
    for (std::size_t i = first; i < lines.size() && i < first + most_lines; ++i)
        result += lines[i].substr(0, longest_line) + "\n";
    if (lines.size() > first + most_lines) result += "...\n";
    return result;
}

} // namespace rigor
