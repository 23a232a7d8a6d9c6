// SPDX-License-Identifier: MIT
// The rules of the tree, one function each. They look at folders, includes, the places of tests,
// the width of comments and prose, and the first lines of files. `check_tree` applies all of them.
#include "layout/layout.hpp"

#include "layout/comments.hpp"
#include "layout/modules.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace rigor::layout {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 25; // in a folder
constexpr std::size_t most_columns = 100;

const std::string licence_line = "// SPDX-License-Identifier: MIT";

std::string at_line(const File& file, std::size_t line)
{
    return file.path.generic_string() + ":" + std::to_string(line);
}

void check_width(const File& file, std::size_t line, Violations& violations)
{
    const std::size_t columns = width(file.lines[line - 1]);
    if (columns > most_columns)
        violations.push_back(
            {at_line(file, line),
             "a comment or text of " + std::to_string(columns) + " columns; the limit is 100"});
}

// Whether a line is one link, picture or word, which cannot be broken.
bool is_unbreakable(const std::string& line)
{
    const std::size_t start = line.find_first_not_of(" -*>");
    if (start == std::string::npos) return true;
    const std::size_t end = line.find_last_not_of(" .,;");
    const std::string text = line.substr(start, end + 1 - start);
    const bool is_link = (text.front() == '[' || text.starts_with("![")) && text.back() == ')' &&
                         std::count(text.begin(), text.end(), ']') == 1;
    return is_link || text.find(' ') == std::string::npos;
}

// Whether the source is the main of a program, or of a module that a program loads.
bool is_main(const File& file)
{
    if (file.path.parent_path().filename() == "main") return true;
    return std::any_of(file.lines.begin(), file.lines.end(),
                       [](const std::string& line) { return line.starts_with("int main("); });
}

void append(Violations& all, const Violations& some)
{
    all.insert(all.end(), some.begin(), some.end());
}

} // namespace

Violations large_folders(const Files& sources)
{
    std::map<std::string, std::size_t> count;
    for (const File& file : sources)
        ++count[file.path.parent_path().generic_string()];
    Violations violations;
    for (const auto& [folder, files] : count)
        if (files > most_files)
            violations.push_back({folder + "/", std::to_string(files) +
                                                    " sources and headers in one folder; the limit "
                                                    "is 25"});
    return violations;
}

Violations including_each_other(const Files& sources)
{
    Violations violations;
    for (const std::vector<std::string>& cycle : cycles(module_includes(sources))) {
        std::string others;
        for (std::size_t i = 1; i < cycle.size(); ++i)
            others += (i == 1 ? "" : ", ") + cycle[i];
        violations.push_back({cycle.front(), "includes itself through " + others});
    }
    return violations;
}

Violations sources_without_header(const Files& sources)
{
    std::set<fs::path> known;
    for (const File& file : sources)
        known.insert(file.path);
    Violations violations;
    for (const File& file : sources) {
        if (*file.path.begin() != "framework" || file.path.extension() != ".cpp") continue;
        if (!known.count(fs::path(file.path).replace_extension(".hpp")) && !is_main(file))
            violations.push_back({file.path.generic_string(),
                                  "a source of the framework without a header of its name"});
    }
    return violations;
}

Violations misplaced_tests(const Files& sources)
{
    const std::string ending = "_test.cpp";
    std::map<std::string, std::set<fs::path>> folders; // those that hold a source of this name
    for (const File& file : sources)
        if (*file.path.begin() == "framework")
            folders[file.path.stem().string()].insert(file.path.parent_path());
    Violations violations;
    for (const File& file : sources) {
        const std::string path = file.path.generic_string(), name = file.path.filename().string();
        if (!path.starts_with("tests/framework/") || !name.ends_with(ending)) continue;
        const auto found = folders.find(name.substr(0, name.size() - ending.size()));
        if (found == folders.end()) continue; // a test of several sources
        const fs::path mirrored = file.path.parent_path().lexically_relative("tests");
        if (found->second.count(mirrored)) continue;
        const std::string source = (*found->second.begin() / found->first).generic_string();
        violations.push_back({path, "a test with the name of " + source + " belongs in tests/" +
                                        found->second.begin()->generic_string() + "/"});
    }
    return violations;
}

Violations wide_comments(const Files& sources)
{
    Violations violations;
    for (const File& file : sources)
        for (const Comment& comment : comments(file.lines))
            check_width(file, comment.line, violations);
    return violations;
}

Violations wide_script_comments(const Files& scripts)
{
    Violations violations;
    for (const File& file : scripts)
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            const std::size_t start = line.find_first_not_of(" \t");
            if (start != std::string::npos && line[start] == '#')
                check_width(file, i + 1, violations);
        }
    return violations;
}

Violations wide_prose(const Files& texts)
{
    Violations violations;
    for (const File& file : texts) {
        bool in_code = false;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            const std::size_t start = line.find_first_not_of(' ');
            if (start == std::string::npos) continue;
            if (line.compare(start, 3, "```") == 0) in_code = !in_code;
            const bool is_table = line[start] == '|';
            if (!in_code && !is_table && !is_unbreakable(line))
                check_width(file, i + 1, violations);
        }
    }
    return violations;
}

Violations lines_that_begin_with_of(const Files& sources)
{
    Violations violations;
    for (const File& file : sources)
        for (const Comment& comment : comments(file.lines))
            if (comment.text.starts_with("of ") || comment.text.starts_with("Of "))
                violations.push_back({at_line(file, comment.line),
                                      "a comment line that begins with \"of\": say what it is, "
                                      "or break the line elsewhere"});
    return violations;
}

Violations graded_checks_without_words(const Files& sources)
{
    Violations violations;
    for (const File& file : sources) {
        if (!file.path.generic_string().starts_with("tests/graded/")) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            for (const char* name : {"REQUIRE(", "CHECK(", "REQUIRE_FALSE(", "CHECK_FALSE("}) {
                const std::size_t at = file.lines[i].find(name);
                if (at == std::string::npos || (at > 0 && file.lines[i][at - 1] != ' ')) continue;
                violations.push_back({at_line(file, i + 1),
                                      "a failure shows a student the code of the test: say in "
                                      "words what is expected, by check_that or check_count"});
            }
    }
    return violations;
}

Violations missing_first_lines(const Files& sources)
{
    Violations violations;
    for (const File& file : sources) {
        if (file.lines.empty() || file.lines.front() != licence_line)
            violations.push_back(
                {file.path.generic_string(), "the first line is not \"" + licence_line + "\""});
        if (file.path.extension() == ".hpp" &&
            std::find(file.lines.begin(), file.lines.end(), "#pragma once") == file.lines.end())
            violations.push_back({file.path.generic_string(), "a header without #pragma once"});
    }
    return violations;
}

Violations check_tree(const fs::path& top)
{
    const Files sources = layout::sources(top), texts = layout::texts(top);
    Violations violations;
    if (sources.empty()) violations.push_back({top.generic_string(), "no sources found"});
    if (texts.empty()) violations.push_back({top.generic_string(), "no Markdown found"});
    for (const auto rule : {large_folders, including_each_other, sources_without_header,
                            misplaced_tests, wide_comments, lines_that_begin_with_of,
                            graded_checks_without_words, missing_first_lines})
        append(violations, rule(sources));
    append(violations, wide_script_comments(scripts(top)));
    append(violations, wide_prose(texts));
    return violations;
}

} // namespace rigor::layout
