// SPDX-License-Identifier: MIT
// Finds files that a solution may not include. The compiler lists every file that it opened for an
// object. For each path in that list, symbolic links are resolved, and the result is compared with
// the allowed folders. Macros and relative paths cannot hide an include, since the list has the
// files that were opened.
#include "grading/build/includes.hpp"

#include "grading/build/toolchain.hpp"
#include "grading/places.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace rigor {

namespace fs = std::filesystem;

namespace {

bool is_within(const fs::path& file, const fs::path& folder)
{
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

// The files in the compiler's list, "object: file file \<newline> file": the paths that it opened.
std::vector<std::string> listed_files(const fs::path& list)
{
    std::ifstream file(list);
    std::stringstream content;
    content << file.rdbuf();
    const std::string text = content.str();
    const std::size_t colon = text.find(": ");
    if (colon == std::string::npos)
        throw std::runtime_error(list.string() +
                                 ": expected the compiler's list of what it included");
    std::vector<std::string> files(1);
    for (std::size_t i = colon + 1; i < text.size(); ++i) {
        const char next = i + 1 < text.size() ? text[i + 1] : '\n';
        const bool is_escaped =
            (text[i] == '\\' && (next == ' ' || next == '#')) || (text[i] == '$' && next == '$');
        if (is_escaped)
            files.back() += text[++i];
        else if (text[i] == ' ' || text[i] == '\n' || (text[i] == '\\' && next == '\n'))
            files.emplace_back();
        else
            files.back() += text[i];
    }
    std::erase(files, "");
    return files;
}

// Whether a solution in `folder` may include `file`. The caller has resolved the links in both
// paths.
bool may_include(const fs::path& file, const fs::path& folder)
{
    const fs::path tree = fs::weakly_canonical(places().source);
    const fs::path build = fs::weakly_canonical(places().build);
    if (is_within(file, tree / "framework/formulas") || is_within(file, folder)) return true;
    if (is_within(file, build / "framework/CMakeFiles/eigen_precompiled.dir")) return true;
    if (file == fs::weakly_canonical(no_file_queries())) return true;
    return !is_within(file, tree) && !is_within(file, build);
}

// Whether a path goes back by `..` from a folder that a solution may not include from. The path
// shows whether this folder exists, although it may lead to an allowed file.
bool makes_detour(const fs::path& path, const fs::path& folder)
{
    const fs::path formulas = fs::weakly_canonical(places().source) / "framework/formulas";
    fs::path walked;
    for (const fs::path& part : path) {
        if (part == "..") {
            const bool is_on_the_way = is_within(folder, walked) || is_within(formulas, walked);
            if (!is_on_the_way && !may_include(walked, folder)) return true;
            walked = walked.parent_path();
        } else if (part != ".") {
            walked /= part;
        }
    }
    return false;
}

// The path for messages, relative to the top of the tree.
std::string shown(const fs::path& file)
{
    const fs::path tree = fs::weakly_canonical(places().source);
    return is_within(file, tree) ? file.lexically_relative(tree).string() : file.string();
}

} // namespace

std::string forbidden_include(const fs::path& list, const fs::path& folder)
{
    const fs::path own = fs::weakly_canonical(folder);
    for (const std::string& name : listed_files(list)) {
        std::error_code missing;
        const fs::path file = fs::canonical(own / name, missing);
        if (!missing && may_include(file, own) && !makes_detour(own / name, own)) continue;
        return list.stem().string() + ".cpp: includes " + (missing ? name : shown(file)) +
               ": a solution may include framework/formulas/, its own folder and what the "
               "system offers\n";
    }
    return {};
}

bool includes_one_of(const std::vector<std::string>& names, const fs::path& list,
                     const fs::path& folder)
{
    const fs::path own = fs::weakly_canonical(folder);
    const auto is_one_of_them = [&](const std::string& file) {
        const fs::path found = fs::weakly_canonical(own / file);
        return std::any_of(names.begin(), names.end(),
                           [&](const std::string& name) { return found == own / name; });
    };
    const std::vector<std::string> files = listed_files(list);
    return std::any_of(files.begin(), files.end(), is_one_of_them);
}

} // namespace rigor
