// SPDX-License-Identifier: MIT
// An implementation of the formulas, from its sources to the worker, the program that runs them.
#pragma once

#include "grading/build/ninja.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rigor {

struct Implementation {
    std::string name;             // "student", "reference" or a folder, as the user named it
    std::filesystem::path folder; // where its sources are
    std::filesystem::path worker;
    /// The topics whose files do not compile, each with the first errors. The worker is built
    /// without these files, and their formulas are missing in it.
    std::map<std::string, std::string> broken;
    std::vector<std::string> borrowed;  // topics that `folder` lacks, taken from student/
    std::vector<std::string> left_out;  // headers and other sources not compiled with it, and why
    std::vector<std::string> undefined; // names that are used but defined nowhere
    /// What was built again, such as "Building inertia.cpp"; empty if everything was up to date.
    std::vector<std::string> build_steps;
    double build_seconds = 0;
    std::string digest; // SHA-256 of the files in `folder`; for the reference, of its name

    bool is_broken(const std::string& topic) const { return broken.count(topic) > 0; }
    /// The errors of all topics' files, one after the other; empty if there are none.
    std::string errors() const;
    /// The file of a topic, as messages show it: "student/inertia.cpp".
    std::string shown_file(const std::string& topic) const;
    /// The path of the file of a topic.
    std::filesystem::path file(const std::string& topic) const;
};

/// Builds the worker of `student`, `reference` or a folder that holds some of the topics' files.
/// Only what is out of date is built. If a file does not compile, only the formulas of this file
/// are missing.
///
/// @throws InputError if there is no such implementation, std::runtime_error if code of the
///     framework or of the reference does not compile, std::system_error if the sandbox cannot be
///     set up
Implementation build_implementation(const std::string& name, const OnBuildStep& on_step = {});

/// Builds targets of the framework. @throws std::runtime_error with the compiler's first errors
void build_targets(const std::vector<std::string>& targets, const OnBuildStep& on_step = {});

} // namespace rigor
