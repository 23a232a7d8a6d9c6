// SPDX-License-Identifier: MIT
// Builds a worker, the program that runs the formulas, from a folder of topic files such as
// inertia.cpp. The compiler and the linker run behind walls (in a sandbox), in a private folder. If
// a file does not compile, only the formulas of this file are missing. A topic's file is compiled
// again only if something that its object depends on has changed (compiled_folder.hpp).
#pragma once

#include "grading/build/ninja.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rigor {

struct SubmissionBuild {
    std::filesystem::path worker;
    std::map<std::string, std::string> broken; // by topic, the first errors of its file
    std::vector<std::string> borrowed;  // topics that the folder lacks; student/ has their files
    std::vector<std::string> left_out;  // headers and other sources not copied, and why
    std::vector<std::string> undefined; // names that are used but defined nowhere
    std::vector<std::string> steps;     // what was done, such as "Building inertia.cpp"
    std::string digest;                 // SHA-256 of the folder's files
    double seconds = 0;
};

/// Builds the worker of a folder with some topics' files. Builds of one folder run one after the
/// other. Other builds wait only for what they share: the framework and student/.
/// @throws InputError if the folder has no file of any topic, std::system_error if the sandbox
///     cannot be set up, std::runtime_error for other faults, such as code of the framework that
///     does not compile, or files that somebody removes during the build
SubmissionBuild build_submission(const std::filesystem::path& folder, const OnBuildStep& on_step);

/// Builds what all submissions share: the framework's part of a worker, and the objects of
/// student/, which stand in for files that a submission lacks. Processes that are forked afterwards
/// need not build these again.
void prepare_submission_builds(const OnBuildStep& on_step);

/// Removes what was built from a folder, even if the folder itself is gone. A build of this folder
/// that runs at the same time loses its files, and throws.
void remove_submission_build(const std::filesystem::path& folder);

} // namespace rigor
