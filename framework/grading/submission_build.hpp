// SPDX-License-Identifier: MIT
// How a folder of topic files becomes a worker: student/'s own commands, with other files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A private build of a folder. Paths are relative to the build folder.
struct SubmissionBuild {
    std::string folder;                      // "submissions/<name>-<hash>/"
    std::string ninja_file;                  // the rules
    std::string worker;                      // the executable
    std::vector<std::string> objects;        // made from the folder's files
    std::vector<std::string> needed_targets; // what of the main build the worker is linked with
    std::vector<std::string> borrowed;       // topics taken from student/
};

/// Writes the rules, if they changed. @throws InputError if the folder holds no topic's file
///
/// @param without  topics whose files are left out as if the folder lacked them
SubmissionBuild prepare_submission_build(const std::filesystem::path& folder,
                                         const std::vector<std::string>& without = {});

/// What the files of student/ are compiled to, relative to the build folder.
std::vector<std::string> student_objects();

} // namespace rigor
