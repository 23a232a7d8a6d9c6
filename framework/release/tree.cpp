// SPDX-License-Identifier: MIT
#include "release/tree.hpp"

#include "errors/input_error.hpp"
#include "formulas/table.hpp"
#include "grading/process.hpp"
#include "release/withheld.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <set>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// The parts of the project that both trees have, except for those in `grading_parts`. A name that
// ends with a slash is a folder. Whatever is not named here is left out, so a new folder of the
// project is not handed out by accident.
constexpr std::string_view shared_parts[] = {
    ".clang-format",  ".editorconfig",       ".gitignore",
    "CMakeLists.txt", "CMakePresets.json",   "LICENSE",
    "assignments/",   "framework/",          "rigor",
    "student/",       "tests/graded/",       "tests/diagnosis/",
    "tests/support/", "tests/CMakeLists.txt"};
// The parts that only the tree for an autograder has.
constexpr std::string_view grading_parts[] = {"reference/",
                                              "tests/graded/hidden/",
                                              "framework/release/students/",
                                              "assignments/instructor.md",
                                              "assignments/grading.md",
                                              "assignments/course.md"};
// The page for students, which becomes README.md of their tree.
constexpr std::string_view students_page = "assignments/students.md";

bool is_part(std::string_view path, std::string_view part)
{
    return part.ends_with('/') ? path.starts_with(part) : path == part;
}

template <class Parts> bool is_among(std::string_view path, const Parts& parts)
{
    return std::any_of(std::begin(parts), std::end(parts),
                       [&](std::string_view part) { return is_part(path, part); });
}

// The paths of the files that git tracks.
std::vector<std::string> controlled_files(const fs::path& source)
{
    require_git();
    Command command;
    command.arguments = {"git", "-C", source.string(), "-c", "core.quotePath=false", "ls-files"};
    std::vector<std::string> paths;
    const Ended ended = run(command, [&](std::string_view line) { paths.emplace_back(line); });
    if (ended.ok()) return paths;
    throw InputError(fmt::format("git cannot list the files of {}: {}", source.string(),
                                 paths.empty() ? "it says nothing" : paths.back()));
}

std::vector<std::string> files_of(const fs::path& source)
{
    std::vector<std::string> paths;
    if (fs::exists(source / ".git")) {
        paths = controlled_files(source);
    } else {
        for (const auto& entry : fs::directory_iterator(source)) {
            const std::string name = entry.path().filename().string();
            if (entry.is_regular_file()) paths.push_back(name);
            if (!entry.is_directory() || name == "build" || name == "out") continue;
            for (const auto& inner : fs::recursive_directory_iterator(entry.path()))
                if (inner.is_regular_file())
                    paths.push_back(inner.path().lexically_relative(source).generic_string());
        }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

ReleasedFile file_at(const fs::path& source, const std::string& path)
{
    const auto permissions = fs::status(source / path).permissions();
    return {path, file_content(source / path),
            (permissions & fs::perms::owner_exec) != fs::perms::none};
}

// Checks that student/ has stubs only: a solved formula would be handed out to everybody.
void require_stubs(const ReleasedTree& tree)
{
    for (const Formula& formula : formulas) {
        const std::string path = fmt::format("student/{}.cpp", formula.topic);
        const std::string stub =
            fmt::format("throw NotImplemented(\"{}::{}\");", formula.topic, formula.name);
        const auto file = std::find_if(tree.begin(), tree.end(),
                                       [&](const ReleasedFile& f) { return f.path == path; });
        if (file == tree.end() || file->content.find(stub) == std::string::npos)
            throw InputError(fmt::format("{}: expected the untouched stub of {} {}, found none; "
                                         "solved formulas must not be handed out (`git checkout "
                                         "student` brings the stubs back)",
                                         path, formula.tag, formula.name));
    }
}

} // namespace

void require_git()
{
    if (!is_installed("git")) throw InputError("git is not installed: apt-get install git");
}

std::string file_content(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file.string() + ": expected a file that can be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

ReleasedTree students_tree(const fs::path& source)
{
    ReleasedTree tree;
    for (const std::string& path : files_of(source)) {
        if (path == students_page)
            add_file(tree, {"README.md", file_content(source / path), false});
        if (!is_among(path, shared_parts) || is_among(path, grading_parts) || path == students_page)
            continue;
        ReleasedFile file = file_at(source, path);
        if (const std::string_view other = replacement_of(path); !other.empty())
            file.content = file_content(source / other);
        add_file(tree, std::move(file));
    }
    require_stubs(tree);
    return tree;
}

ReleasedTree grading_tree(const fs::path& source)
{
    ReleasedTree tree;
    for (const std::string& path : files_of(source))
        if (is_among(path, shared_parts) || is_among(path, grading_parts))
            add_file(tree, file_at(source, path));
    return tree;
}

void add_file(ReleasedTree& tree, ReleasedFile file)
{
    const auto place =
        std::lower_bound(tree.begin(), tree.end(), file.path,
                         [](const ReleasedFile& f, const std::string& p) { return f.path < p; });
    tree.insert(place, std::move(file));
}

namespace {

void write_file(const ReleasedFile& file, const fs::path& place)
{
    std::error_code error;
    fs::create_directories(place.parent_path(), error);
    const bool is_there = fs::is_regular_file(place, error) && file_content(place) == file.content;
    if (!is_there) {
        std::ofstream out(place, std::ios::binary | std::ios::trunc);
        out << file.content;
        out.close();
        if (!out) throw InputError(place.string() + ": cannot be written: " + std::strerror(errno));
    }
    using fs::perms;
    const perms read =
                    perms::owner_read | perms::owner_write | perms::group_read | perms::others_read,
                execute = perms::owner_exec | perms::group_exec | perms::others_exec;
    fs::permissions(place, file.is_executable ? read | execute : read, error);
}

} // namespace

void write_tree(const ReleasedTree& tree, const fs::path& folder, const std::string& keep)
{
    std::set<std::string> expected;
    for (const ReleasedFile& file : tree)
        expected.insert(file.path);
    std::vector<fs::path> others;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string path = entry->path().lexically_relative(folder).generic_string();
        if (!keep.empty() && path == keep)
            entry.disable_recursion_pending();
        else if (!entry->is_directory(error) && !expected.count(path))
            others.push_back(entry->path());
    }
    for (const fs::path& other : others)
        fs::remove(other, error);
    for (const ReleasedFile& file : tree)
        write_file(file, folder / file.path);
}

} // namespace rigor
