// SPDX-License-Identifier: MIT
// Finds the submissions that paths name.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace rigor {

/// A folder, an archive or a single source that somebody handed in.
struct Submission {
    std::string name; // the folder's, or the file's without its ending
    std::filesystem::path path;
    std::string refusal; // why it cannot be graded; empty if nothing speaks against it yet
};

struct FoundSubmissions {
    std::vector<Submission> submissions; // sorted by name, each name once
    std::vector<std::string> notes;      // what was passed over, a line each
};

/// Finds all submissions. A path is a submission, or a folder of many. A folder holds many if the
/// wanted file does not lie in it and it has archives in it, or several folders with that file; if
/// it is the only path, any folder in it is a submission. A single file in such a folder is one if
/// it has a name that Canvas or Moodle gives (downloaded_name.hpp).
///
/// A student who has several submissions by the names of Canvas or Moodle gets a note.
///
/// A name that several submissions have, that cannot be shown, or that is reserved, is refused in
/// `refusal`; the last two are changed.
/// @param wanted  name of the file that the assignment asks for
/// @param reserved  names that the results need for their own files
/// @throws InputError if a path does not exist, or if there is no submission
FoundSubmissions find_submissions(const std::vector<std::string>& paths, const std::string& wanted,
                                  const std::set<std::string>& reserved);

} // namespace rigor
