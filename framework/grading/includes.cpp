// SPDX-License-Identifier: MIT
// Finds files that a solution may not include. The compiler lists every file that it opened for an
// object; each path of that list is resolved, with its links, and compared with the allowed
// folders. Macros and relative paths cannot hide an include, since the list has the
// files that were opened.
#include "grading/includes.hpp"

#include "grading/places.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rigor {

namespace fs = std::filesystem;

namespace {

fs::path list_of(const std::string& object)
{
    return places().build / (object + ".d");
}

bool is_within(const fs::path& file, const fs::path& folder)
{
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

// The files in a list "object: file file \<newline> file", with the paths that the compiler opened.
// ninja's own log cannot be used: it shortens "link/../file" to "file", which is another file if
// `link` leads elsewhere.
std::vector<std::string> listed_files(const std::string& object)
{
    std::ifstream file(list_of(object));
    std::stringstream content;
    content << file.rdbuf();
    const std::string text = content.str();
    const std::size_t colon = text.find(": ");
    if (colon == std::string::npos)
        throw std::runtime_error(list_of(object).string() +
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

// Whether a solution in `folder` may include `file`. The links of both paths are resolved before.
bool may_include(const fs::path& file, const fs::path& folder)
{
    const fs::path tree = fs::weakly_canonical(places().source);
    const fs::path build = fs::weakly_canonical(places().build);
    if (is_within(file, tree / "framework/formulas")) return true;
    if (is_within(file, build / "framework/CMakeFiles/eigen_precompiled.dir")) return true;
    const bool is_ours = is_within(file, tree) || is_within(file, build);
    return !is_ours || (is_within(file, folder) && !is_within(tree, folder));
}

// The path for messages, relative to the top of the tree.
std::string shown(const fs::path& file)
{
    const fs::path tree = fs::weakly_canonical(places().source);
    return is_within(file, tree) ? file.lexically_relative(tree).string() : file.string();
}

std::string source_name(const std::string& object)
{
    // "inertia" for "inertia.o", "inertia.cpp" for "inertia.cpp.o"
    const fs::path stem = fs::path(object).stem();
    return stem.has_extension() ? stem.string() : stem.string() + ".cpp";
}

} // namespace

void remove_unlisted(const std::vector<std::string>& objects)
{
    for (const std::string& object : objects)
        if (!fs::exists(list_of(object))) fs::remove(places().build / object);
}

std::string forbidden_include(const std::vector<std::string>& objects, const fs::path& folder)
{
    const fs::path own = fs::weakly_canonical(folder);
    for (const std::string& object : objects) {
        for (const std::string& name : listed_files(object)) {
            std::error_code missing;
            const fs::path file = fs::canonical(places().build / name, missing);
            if (!missing && may_include(file, own)) continue;
            return source_name(object) + ": includes " + (missing ? name : shown(file)) +
                   ": a solution may include framework/formulas/, its own folder and what the "
                   "system offers\n";
        }
    }
    return {};
}

} // namespace rigor
