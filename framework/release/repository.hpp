// SPDX-License-Identifier: MIT
// A tree as a git repository with one commit. The same files give the same commit and the same
// bytes: author, date and settings are fixed, and the git settings of the user are not used.
#pragma once

#include "release/tree.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// Writes the files to a folder, and in it a git repository with one commit that has all of them.
/// @param folder  a new folder
/// @return the commit, 40 hexadecimal digits
/// @throws InputError if git is not installed or a file cannot be written
std::string write_repository(const ReleasedTree& tree, const std::filesystem::path& folder);

/// Writes the files of the repository's commit to the folder `work`, and removes all others except
/// `build/`. Files that have not changed since the last time keep their time stamps, so that a
/// build there compiles only what has changed.
void write_commit(const std::filesystem::path& repository, const std::filesystem::path& work);

/// A folder that gets its name only when its content is complete: a run that fails leaves nothing
/// under that name, and an earlier release stays as it was.
class DraftFolder {
public:
    /// @param place  a new or empty folder, or a repository that `write_repository` made and nobody
    ///     changed
    /// @throws InputError if `place` is anything else, or cannot be written
    explicit DraftFolder(const std::filesystem::path& place);
    ~DraftFolder();
    DraftFolder(const DraftFolder&) = delete;
    DraftFolder& operator=(const DraftFolder&) = delete;

    const std::filesystem::path& draft() const { return draft_; }
    /// Renames the draft to `place`. @throws InputError if this fails
    void publish();

private:
    std::filesystem::path place_, draft_;
};

} // namespace rigor
