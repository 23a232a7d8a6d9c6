// SPDX-License-Identifier: MIT
// Ninja, run and understood.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rigor {

/// Called with each step of a build that is done.
using OnBuildStep = std::function<void(int done, int total, const std::string& step)>;

/// What a run of ninja did.
struct NinjaRun {
    bool ok = false;
    bool timed_out = false;          // one file took longer than the limit
    std::vector<std::string> steps;  // "Building CXX object …", "Linking CXX executable …"
    std::vector<std::string> failed; // outputs that could not be made
    std::string errors;              // the compiler's first errors
    double seconds = 0;
};

/// Longest time for a single file [s]. Student code can keep a compiler busy for ever.
inline constexpr double compile_limit = 120;

/// Runs ninja in the build folder; the compiler's lists of what it included stay. @param arguments
/// targets and options
NinjaRun run_ninja(const std::vector<std::string>& arguments, const OnBuildStep& on_step = {});

/// The commands that make a target, in order, one a line.
std::vector<std::string> ninja_commands(const std::string& target);

/// Names of the programs of the build that begin with `prefix`, without it, sorted.
std::vector<std::string> ninja_programs(const std::string& prefix);

/// The first errors of a compiler's or linker's output: at most 20 lines, from the first one that
/// speaks of an error.
std::string first_errors(const std::vector<std::string>& lines);

} // namespace rigor
