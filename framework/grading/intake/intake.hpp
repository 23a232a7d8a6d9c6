// SPDX-License-Identifier: MIT
// Decides which files of a submission are graded.
#pragma once

#include "grading/intake/contents.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rigor {

/// What is taken from a submission.
struct Intake {
    std::map<std::string, std::string> files; // names below the folder of the assignment's file
    std::vector<std::string> ignored; // names of all other files, as the submission has them
};

/// Takes the file that an assignment asks for, and the sources in its folder and below.
/// @param wanted  its name, such as "collision.cpp"
/// @throws Refused if there is no such file, or if there are several
Intake take_files_for(const std::string& wanted, const Contents& contents);

/// The archive that lies in a folder with no other file of the student, as Moodle downloads it;
/// empty if there is none.
std::string only_archive_in(const Contents& folder);

/// Reads an archive or a folder, and takes the files for an assignment. A folder with nothing but
/// an archive is taken for that archive. @throws Refused
Intake take_submission(const std::filesystem::path& path, const std::string& wanted);

/// The first names of a list, in quotes, and how many there are beside them: `"a", "b" and 4 more`.
std::string first_names(const std::vector<std::string>& names);

} // namespace rigor
