// SPDX-License-Identifier: MIT
#include "cli/hints.hpp"

#include "errors/input_error.hpp"

#include <cctype>
#include <fstream>

namespace rigor {

namespace {

bool is_numbered(const std::string& line)
{
    return line.size() > 3 && std::isdigit(static_cast<unsigned char>(line[0])) != 0 &&
           line.compare(1, 2, ". ") == 0;
}

} // namespace

std::vector<std::string> hints_of(const Assignment& assignment, const Task& task)
{
    const std::filesystem::path file = assignment.folder / "hints.md";
    std::ifstream lines(file);
    if (!lines) throw InputError("expected the hints of " + task.tag + " in " + file.string());
    std::vector<std::string> hints = {task.hint};
    bool is_here = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## "))
            is_here = line == "## " + task.tag;
        else if (!is_here || line.empty())
            continue;
        else if (is_numbered(line))
            hints.push_back(line.substr(3));
        else if (hints.size() > 1) // a further line of the last hint
            hints.back() += " " + line.substr(line.find_first_not_of(' '));
    }
    return hints;
}

} // namespace rigor
