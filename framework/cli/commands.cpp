// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include "cli/commands/bench.hpp"
#include "cli/commands/book.hpp"
#include "cli/commands/check.hpp"
#include "cli/commands/compare.hpp"
#include "cli/commands/demo.hpp"
#include "cli/commands/figures.hpp"
#include "cli/commands/hint.hpp"
#include "cli/commands/list.hpp"
#include "cli/commands/render.hpp"
#include "cli/commands/simulate.hpp"
#include "cli/commands/test.hpp"

namespace rigor {

std::span<const CommandEntry> commands()
{
    static constexpr CommandEntry all[] = {
        {"demo", "Render the showcase scenes and grade the sample submissions", declare_demo},
        {"test", "Check this tree in minutes, or all that CI checks", declare_test},
        {"list", "Show assignments, tasks, points and scenes", declare_list},
        {"check", "Grade your own files: the loop to live in", declare_check},
        {"grade", "Grade a class: folders and archives"},
        {"grade-chunk", "Grade a part of a class (Slurm starts this)"},
        {"release", "Make what students, Gradescope or GitHub get"},
        {"hint", "Give a hint for a task, and the next one each time", declare_hint},
        {"simulate", "Run a scene and store its trajectory", declare_simulate},
        {"render", "Draw a scene or a stored trajectory as frames", declare_render},
        {"compare", "Find the first step where two implementations differ", declare_compare},
        {"bench", "Measure run time against error", declare_bench},
        {"book", "Make one page of all handouts", declare_book},
        {"figures", "Draw the figures of the handouts", declare_figures},
    };
    return all;
}

} // namespace rigor
