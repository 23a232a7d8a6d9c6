// SPDX-License-Identifier: MIT
// Finds the submissions in the paths that the user names.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace rigor {

/// A folder, an archive or a single source that a student handed in.
struct Submission {
    std::string name; // name of the folder, or of the file without its ending
    std::filesystem::path path;
    std::string refusal; // why it cannot be graded; empty if no reason is known yet
};

struct FoundSubmissions {
    std::vector<Submission> submissions; // sorted by name, each name once
    std::vector<std::string> notes;      // lines about ignored files and about doubtful cases
};

/// Finds all submissions. A single path is a submission or a folder of submissions: the latter if
/// it lacks the wanted file and contains an archive, a folder, or a file with a name that Canvas or
/// Moodle gives (downloaded_name.hpp).
///
/// Several paths are folders of submissions if each of them looks like one: if it lacks the wanted
/// file and contains a file that Canvas or Moodle has named, or at least two of archives and
/// folders with the wanted file in them or in a folder inside. Otherwise each path is one
/// submission, whatever it contains, and a note names those that look like folders of submissions.
/// So with `class/*` no student's folder can count as several submissions, with names of others.
///
/// In a folder of submissions, its archives and folders are submissions, and so are its files from
/// Canvas or Moodle. Such a file is passed over if it has another name than the wanted one and its
/// student has another submission.
///
/// `notes` names each student who has several submissions, according to the names that Canvas or
/// Moodle gave.
///
/// A submission is refused, with the reason in `refusal`, in these cases:
/// 1. Another submission has the same name.
/// 2. Its name cannot be shown, or is reserved. Then its name is changed.
/// 3. It is a link, except as the only path, or anything else that is neither a folder nor a file.
/// 4. It is a file from Canvas or Moodle with another name than the wanted one, and the student has
///    no other submission.
/// @param wanted  name of the file that the assignment asks for
/// @param reserved  names that the results need for their own files
/// @throws InputError if a path does not exist, if there is no submission, or if a folder has both
///     the wanted file and what looks like the submissions of a class
FoundSubmissions find_submissions(const std::vector<std::string>& paths, const std::string& wanted,
                                  const std::set<std::string>& reserved);

} // namespace rigor
