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
    std::map<std::string, std::string> files; // texts by name, relative to the wanted file's folder
    std::vector<std::string> ignored;         // names of all other files
};

/// Takes the file that an assignment asks for, and the sources in its folder and below.
/// @param wanted  name of the file that the assignment asks for, such as "collision.cpp"
/// @throws Refused if there is no such file, or if there are several
Intake take_files_for(const std::string& wanted, const Contents& contents);

/// The name of the archive in a folder, if it is the only file of the student there, as in a
/// download from Moodle; otherwise empty.
std::string only_archive_in(const Contents& folder);

/// Reads an archive, a folder or a single source, and takes the files for an assignment. A folder
/// with nothing but an archive counts as this archive. @throws Refused if the submission cannot be
/// read or lacks the wanted file
Intake take_submission(const std::filesystem::path& path, const std::string& wanted);

/// At most four names from the front of a list, in quotes, and how many more there are:
/// `"a", "b", "c", "d" and 2 more`.
std::string first_names(const std::vector<std::string>& names);

} // namespace rigor
