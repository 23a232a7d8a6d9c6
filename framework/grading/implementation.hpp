// SPDX-License-Identifier: MIT
// An implementation of the formulas, from its sources to the worker that runs it.
#pragma once

#include "grading/ninja.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

struct Implementation {
    std::string name;                // as it was asked for: "student", "reference" or a folder
    std::filesystem::path folder;    // where its sources are
    std::filesystem::path worker;    // the executable
    std::vector<std::string> broken; // topics whose files do not compile, and nobody asked for
    std::vector<std::string>
        borrowed; // those and topics that the folder lacks, taken from student/
    std::vector<std::string>
        build_steps; // what had to be done, as ninja puts it; empty: it was up to date
    double build_seconds = 0;
    std::string compile_error; // the compiler's first errors; empty if it was built

    bool built() const { return compile_error.empty(); }
    /// The file of a topic, as a person finds it: "student/inertia.cpp".
    std::string shown_file(const std::string& topic) const;
    /// The same, as a path.
    std::filesystem::path file(const std::string& topic) const;
};

/// Builds the worker of `student`, `reference` or a folder that holds some of the topics' files;
/// only what is out of date. A folder's files are compiled by the very commands that compile
/// student/.
///
/// @param asked  topics of a folder whose files have to compile; of another, student/ can take the
/// place; none: all
/// @throws InputError if there is no such implementation, std::runtime_error if code of ours does
/// not compile
Implementation build_implementation(const std::string& name, const OnBuildStep& on_step = {},
                                    const std::vector<std::string>& asked = {});

/// Builds targets of ours. @throws std::runtime_error with the compiler's first errors
void build_targets(const std::vector<std::string>& targets, const OnBuildStep& on_step = {});

} // namespace rigor
