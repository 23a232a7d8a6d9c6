// SPDX-License-Identifier: MIT
#include "grading/class/work_folders.hpp"

#include "grading/build/submission_build.hpp"
#include "grading/build/submission_files.hpp"
#include "grading/places.hpp"

#include <fmt/format.h>
#include <system_error>

namespace rigor {

namespace fs = std::filesystem;

WorkFolders::WorkFolders(const fs::path& out, const std::string& part)
    : folder_(places().build / "grading" / fmt::format("{:016x}", hash_of(out.string()))),
      prefix_(part.empty() ? "" : part + ".")
{
    clear();
    fs::create_directories(folder_);
}

WorkFolders::~WorkFolders()
{
    if (!are_left_) clear();
}

fs::path WorkFolders::make(const std::string& name) const
{
    fs::create_directories(folder_ / (prefix_ + name));
    return folder_ / (prefix_ + name);
}

void WorkFolders::remove(const std::string& name) const
{
    std::error_code error;
    remove_submission_build(folder_ / (prefix_ + name));
    fs::remove_all(folder_ / (prefix_ + name), error);
}

void WorkFolders::clear() const
{
    std::error_code error;
    for (fs::directory_iterator entry(folder_, error), end; !error && entry != end;
         entry.increment(error)) {
        if (!entry->path().filename().string().starts_with(prefix_)) continue;
        std::error_code kept;
        remove_submission_build(entry->path());
        fs::remove_all(entry->path(), kept);
    }
    if (prefix_.empty()) fs::remove_all(folder_, error);
}

} // namespace rigor
