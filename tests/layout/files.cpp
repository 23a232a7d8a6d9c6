// SPDX-License-Identifier: MIT
#include "layout/files.hpp"

#include <algorithm>
#include <fstream>

namespace rigor::layout {

namespace {

namespace fs = std::filesystem;

File read(const fs::path& top, const fs::path& path)
{
    File file{path.lexically_relative(top), {}};
    std::ifstream stream(path);
    for (std::string line; std::getline(stream, line);)
        file.lines.push_back(line);
    return file;
}

// The files below a folder for which `wanted` is true, without builds, output and hidden folders.
template <class Wanted>
void collect(const fs::path& top, const fs::path& folder, const Wanted& wanted, Files& files)
{
    if (!fs::is_directory(folder)) return;
    std::vector<fs::path> found;
    for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::end(entry); ++entry) {
        const std::string name = entry->path().filename().string();
        if (entry->is_directory() && (name.front() == '.' || name == "build" || name == "out"))
            entry.disable_recursion_pending();
        else if (entry->is_regular_file() && wanted(entry->path()))
            found.push_back(entry->path());
    }
    std::sort(found.begin(), found.end());
    for (const fs::path& path : found)
        files.push_back(read(top, path));
}

} // namespace

Files sources(const fs::path& top)
{
    const auto is_source = [](const fs::path& path) {
        return path.extension() == ".cpp" || path.extension() == ".hpp";
    };
    Files files;
    for (const char* folder : {"framework", "student", "reference", "tests"})
        collect(top, top / folder, is_source, files);
    return files;
}

Files scripts(const fs::path& top)
{
    const auto is_script = [](const fs::path& path) {
        return path.filename() == "CMakeLists.txt" || path.filename() == "rigor" ||
               path.extension() == ".sh";
    };
    Files files;
    collect(top, top, is_script, files);
    return files;
}

Files texts(const fs::path& top)
{
    Files files;
    collect(
        top, top, [](const fs::path& path) { return path.extension() == ".md"; }, files);
    return files;
}

} // namespace rigor::layout
