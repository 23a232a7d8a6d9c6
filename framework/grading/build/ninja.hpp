// SPDX-License-Identifier: MIT
// Runs ninja and parses its output.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rigor {

/// Called after each finished step of a build.
using OnBuildStep = std::function<void(int done, int total, const std::string& step)>;

/// The result of a run of ninja.
struct NinjaRun {
    bool ok = false;
    std::vector<std::string> steps;  // such as "Building CXX object …"
    std::vector<std::string> failed; // files that could not be built
    std::string errors;              // the compiler's first errors, or why ninja was ended
    double seconds = 0;
};

/// The largest processor time for the compilation of one file of a student [s]. Without a limit, a
/// file could keep the compiler busy forever. A file of the reference takes one to three seconds.
inline constexpr double compile_limit = 60;

/// Runs ninja in the build folder.
/// @param arguments  targets and options
NinjaRun run_ninja(const std::vector<std::string>& arguments, const OnBuildStep& on_step = {});

/// The commands that make a target, in order.
std::vector<std::string> ninja_commands(const std::string& target);

/// The names of the build's programs that begin with `prefix`, sorted and without the prefix.
std::vector<std::string> ninja_programs(const std::string& prefix);

/// The first errors of a compiler's or linker's output: at most 20 lines, each cut to 400
/// characters. They begin with the first line that names an error, or at the start if none does.
std::string first_errors(const std::vector<std::string>& lines);

} // namespace rigor
