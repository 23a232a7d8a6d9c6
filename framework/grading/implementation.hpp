// SPDX-License-Identifier: MIT
// An implementation of the formulas, from its sources to the worker that runs it.
#pragma once

#include "grading/ninja.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

struct Implementation {
    std::string name;                // "student", "reference" or a folder, as asked for
    std::filesystem::path folder;    // where its sources are
    std::filesystem::path worker;    // the executable
    std::vector<std::string> broken; // topics left out: not asked for, and they do not compile
    /// Topics taken from student/: the broken ones and those that the folder lacks.
    std::vector<std::string> borrowed;
    /// The steps that ninja ran; empty if everything was up to date.
    std::vector<std::string> build_steps;
    double build_seconds = 0;
    std::string compile_error; // the compiler's first errors; empty if it was built

    bool built() const { return compile_error.empty(); }
    /// The file of a topic, as messages show it: "student/inertia.cpp".
    std::string shown_file(const std::string& topic) const;
    /// The path of the same file.
    std::filesystem::path file(const std::string& topic) const;
};

/// Builds the worker of `student`, `reference` or a folder that holds some of the topics' files.
/// Only what is out of date is built. A folder's files are compiled with the same commands as
/// student/.
///
/// @param asked  topics whose files must compile. If the file of another topic does not, student/'s
///     file takes its place. Empty: all files of the folder must compile.
/// @throws InputError if there is no such implementation, std::runtime_error if code of the
///     framework does not compile
Implementation build_implementation(const std::string& name, const OnBuildStep& on_step = {},
                                    const std::vector<std::string>& asked = {});

/// Builds targets of the framework. @throws std::runtime_error with the compiler's first errors
void build_targets(const std::vector<std::string>& targets, const OnBuildStep& on_step = {});

} // namespace rigor
