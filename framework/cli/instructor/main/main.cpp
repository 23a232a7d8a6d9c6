// SPDX-License-Identifier: MIT
// The program `rigor_class`: the commands for a course. `rigor` starts it for them, so that nobody
// who runs scenes or checks their own files has to build it.
#include "cli/command_line.hpp"
#include "cli/instructor/grade.hpp"
#include "cli/instructor/grade_chunk.hpp"
#include "cli/instructor/release.hpp"

#include <string_view>
#include <utility>
#include <vector>

int main(int argc, char** argv)
{
    using namespace rigor;
    constexpr std::pair<std::string_view, Action (*)(Options&)> functions[] = {
        {"grade", declare_grade},
        {"grade-chunk", declare_grade_chunk},
        {"release", declare_release},
    };
    std::vector<CommandEntry> own;
    for (const CommandEntry& command : commands())
        for (const auto& [name, declare] : functions)
            if (command.name == name) own.push_back({command.name, command.summary, declare});
    return run_command_line(argc, argv, own);
}
