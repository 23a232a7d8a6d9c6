// SPDX-License-Identifier: MIT
// The names that Canvas and Moodle give to the files of a class when they are downloaded.
#pragma once

#include <optional>
#include <string>

namespace rigor {

/// What the name of a downloaded file or folder says.
struct DownloadedName {
    std::string student;         // such as "doejane_4711"; no other student has it
    std::string file;            // the name that the student gave the file; empty for a folder
    bool is_online_text = false; // whether it is a text typed into a page of Moodle
};

/// Parses a name from Canvas or Moodle; empty for any other name. Canvas:
/// `doejane_LATE_4711_99_collision.cpp`. Moodle: `Jane Doe_17_assignsubmission_file` for a folder,
/// or `Jane Doe_17_assignsubmission_file_collision.cpp` where Moodle makes no folder.
std::optional<DownloadedName> downloaded_name(const std::string& name);

/// Whether the student's name for a file is the wanted one. Canvas adds a number when a file is
/// handed in again: `collision-1.cpp`.
bool is_called(const std::string& file, const std::string& wanted);

} // namespace rigor
