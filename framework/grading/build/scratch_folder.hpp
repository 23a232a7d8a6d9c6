// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <system_error>
#include <utility>

namespace rigor {

/// An empty folder for the files of tools. The destructor removes the folder with all files that
/// the tools have left in it.
class ScratchFolder {
public:
    explicit ScratchFolder(std::filesystem::path folder) : folder_(std::move(folder))
    {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~ScratchFolder()
    {
        std::error_code error; // ignored: the next run removes the folder
        std::filesystem::remove_all(folder_, error);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return folder_; }

private:
    std::filesystem::path folder_;
};

} // namespace rigor
