// SPDX-License-Identifier: MIT
// A small class, and what `rigor grade` wrote about it.
#pragma once

#include "class/made_class.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

namespace rigor::testing {

inline std::string text_in(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Writes a class of A0 into a folder. @return the folder with its submissions
inline std::filesystem::path small_class(const TemporaryFolder& folder, int count)
{
    write_class(made_class(RIGOR_SOURCE_DIR, "pipeline", count, 3), "pipeline",
                folder.path() / "class");
    return folder.path() / "class";
}

/// The files for the whole class, which do not depend on the time.
inline std::map<std::string, std::string> class_files(const std::filesystem::path& out)
{
    std::map<std::string, std::string> files;
    for (const char* name : {"gradebook.csv", "summary.txt", "canvas.csv", "moodle.csv"})
        files[name] = text_in(out / name);
    return files;
}

/// Whether there is a file that was begun and not finished.
inline bool has_drafts(const std::filesystem::path& out)
{
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out))
        if (entry.path().extension() == ".new") return true;
    return false;
}

/// Whether the last line of an output is the only message of `rigor`, and has this part.
inline bool is_one_line(const std::string& text, const std::string& part)
{
    const std::size_t at = text.find("rigor: ");
    return at != std::string::npos && text.find('\n', at) == text.size() - 1 &&
           text.find(part, at) != std::string::npos;
}

} // namespace rigor::testing
