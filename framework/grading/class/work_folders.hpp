// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace rigor {

/// The folders that the submissions of a class are unpacked in. The destructor removes them, with
/// what was built from them. The constructor removes folders that a killed run has left. In both
/// cases no process may work in them any more.
class WorkFolders {
public:
    /// @param out  the results' folder, which tells the runs apart
    /// @param part  the prefix of the names of the folders, for one part of the run; if it is
    ///     empty, the object manages all folders of the run
    explicit WorkFolders(const std::filesystem::path& out, const std::string& part = {});
    ~WorkFolders();
    WorkFolders(const WorkFolders&) = delete;
    WorkFolders& operator=(const WorkFolders&) = delete;

    std::filesystem::path make(const std::string& name) const;
    void remove(const std::string& name) const;
    /// Keeps the destructor from removing the folders, because somebody may still work in them.
    void leave() { are_left_ = true; }
    bool are_left() const { return are_left_; }

private:
    void clear() const;

    std::filesystem::path folder_;
    std::string prefix_; // the names of this part's folders begin with it
    bool are_left_ = false;
};

} // namespace rigor
