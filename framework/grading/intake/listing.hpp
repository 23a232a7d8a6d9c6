// SPDX-License-Identifier: MIT
// What lies in a folder, sorted by what may be a submission.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace rigor {

/// The content of a folder. Folders and archives that programs made, such as `.git`, are only in
/// the list `dotted`; other files that programs made are in no list.
struct Listing {
    std::vector<std::filesystem::path> folders, archives, links, others;
    /// Single files and typed texts, named by Canvas or Moodle.
    std::vector<std::filesystem::path> downloaded;
    std::vector<std::filesystem::path> dotted; // folders and archives that programs made
    std::error_code error;                     // why the folder cannot be read

    bool is_empty() const
    {
        return folders.empty() && archives.empty() && links.empty() && others.empty() &&
               downloaded.empty();
    }
};

/// Reads the names in a folder. If that is not possible, `error` says why.
Listing listing_of(const std::filesystem::path& folder);

/// Whether a folder has an entry of this name that is no folder itself. A student may have called a
/// folder so.
bool holds(const std::filesystem::path& folder, const std::string& wanted);

/// Whether a folder, or a folder in it, `holds` an entry of this name.
bool has_wanted_near(const std::filesystem::path& folder, const std::string& wanted);

} // namespace rigor
