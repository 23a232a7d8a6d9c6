// SPDX-License-Identifier: MIT
// The names that Canvas and Moodle give to the files of a class when they are downloaded.
#pragma once

#include <optional>
#include <string>

namespace rigor {

/// The learning platforms whose names for downloaded files can be parsed.
enum class LearningSystem { canvas, moodle };

/// What the name of a downloaded file or folder says.
struct DownloadedName {
    LearningSystem system = LearningSystem::canvas;
    std::string name;            // the student's name in the system: "doejane", "Jane Doe"
    std::string number;          // the student's id in the system: "4711"
    std::string file;            // the name that the student gave the file; empty for a folder
    bool is_online_text = false; // whether it is a text typed into a page of Moodle

    /// A name that no other student has, such as "doejane_4711".
    std::string student() const { return name + "_" + number; }
};

/// Parses a name from Canvas or Moodle; empty for any other name. Canvas:
/// `doejane_LATE_4711_99_collision.cpp`. Moodle: `Jane Doe_17_assignsubmission_file` for a folder,
/// or `Jane Doe_17_assignsubmission_file_collision.cpp` where Moodle makes no folder. The name of a
/// `Submission`, which lacks the ending of the file, gives the same student. Whatever name the
/// student gave the file or, in Moodle, chose as the own name, the result is never another student:
/// a name with Moodle's words in it twice is none from Moodle.
std::optional<DownloadedName> downloaded_name(const std::string& name);

/// Whether the student's name for a file is the wanted one. Canvas adds a number when a file is
/// handed in again: `collision-1.cpp`.
bool is_called(const std::string& file, const std::string& wanted);

} // namespace rigor
