// SPDX-License-Identifier: MIT
// Finds the submissions in the paths that the user names.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace rigor {

/// A folder, an archive or a single source that somebody handed in.
struct Submission {
    std::string name; // name of the folder, or of the file without its ending
    std::filesystem::path path;
    std::string refusal; // why it cannot be graded; empty if no reason is known yet
};

struct FoundSubmissions {
    std::vector<Submission> submissions; // sorted by name, each name once
    std::vector<std::string> notes;      // a line each: what was ignored, and what is doubtful
};

/// Finds all submissions. Each path is a submission or a folder of submissions. It is a folder of
/// submissions if it does not contain the wanted file, but contains archives, files with names that
/// Canvas or Moodle gives (downloaded_name.hpp), or several folders with the wanted file. If there
/// is no other path, a single folder with any content is enough. Each of these archives, files and
/// folders is a submission.
///
/// `notes` names each student who has several submissions, according to the names that Canvas or
/// Moodle gave.
///
/// A submission is refused, with the reason in `refusal`, if another one has the same name, or if
/// its name cannot be shown or is reserved. In these last two cases its name is changed.
/// @param wanted  name of the file that the assignment asks for
/// @param reserved  names that the results need for their own files
/// @throws InputError if a path does not exist, or if there is no submission
FoundSubmissions find_submissions(const std::vector<std::string>& paths, const std::string& wanted,
                                  const std::set<std::string>& reserved);

} // namespace rigor
