// SPDX-License-Identifier: MIT
// Builds a worker from a folder of topic files, with the commands that build student/.
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
    std::vector<std::string> needed_targets; // outputs of the main build to link
    std::vector<std::string> borrowed;       // topics taken from student/
};

/// Writes the rules, if they changed. @throws InputError if the folder holds no topic's file
///
/// @param without  topics whose files are left out, as if the folder lacked them
SubmissionBuild prepare_submission_build(const std::filesystem::path& folder,
                                         const std::vector<std::string>& without = {});

/// The objects of the files of student/, relative to the build folder.
std::vector<std::string> student_objects();

} // namespace rigor
