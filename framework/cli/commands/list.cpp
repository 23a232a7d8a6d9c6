// SPDX-License-Identifier: MIT
#include "cli/commands/list.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "grading/assignment.hpp"
#include "grading/places.hpp"
#include "grading/selection.hpp"
#include "report/terminal.hpp"
#include "scene/keys/scene_keys.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace rigor {

namespace {

struct ListOptions {
    std::vector<std::string> what;
    bool json = false, scenes = false;
};

using Json = nlohmann::ordered_json;

Json as_json(const Assignment& assignment)
{
    Json tasks = Json::array();
    for (const Task& task : assignment.tasks)
        tasks.push_back({{"tag", task.tag},
                         {"name", task.name()},
                         {"formula", task.formula.empty() ? Json(nullptr) : Json(task.formula)},
                         {"points", task.points},
                         {"visibility", task.is_hidden ? "hidden" : "visible"},
                         {"builds_on", task.builds_on}});
    return {{"assignment", assignment.name}, {"title", assignment.title},
            {"topic", assignment.topic},     {"submit", assignment.submit},
            {"points", assignment.points()}, {"tasks", tasks},
            {"scenes", assignment.scenes}};
}

void print_scenes(const Assignment& assignment, bool color)
{
    if (assignment.scenes.empty()) return;
    fmt::print("  {}\n", colored("scenes", Color::dim, color));
    for (const std::string& file : assignment.scenes) {
        const Scene scene = load_scene(assignment.folder / "scenes" / file);
        fmt::print("    {} {}\n", padded(scene.name, 24), wrapped(scene.description, 51, 29));
    }
}

void print_assignment(const Assignment& assignment, bool color)
{
    const std::string title = fmt::format("{}: {}", assignment.name, assignment.title);
    fmt::print("{} {:>8}\n", colored(padded(title, 66), Color::bold, color),
               fmt::format("{:g} points", assignment.points()));
    for (const Task& task : assignment.tasks)
        fmt::print("  {:<6} {} {:>3g}{}\n", task.tag, padded(task.name(), 58), task.points,
                   task.is_hidden ? "  hidden" : "");
}

int list(const ListOptions& options)
{
    const std::vector<Selection> selections =
        select_tasks(load_assignments(places().assignments()), options.what);
    if (options.json) {
        Json all = Json::array();
        for (const Selection& selection : selections)
            all.push_back(as_json(selection.assignment));
        fmt::print("{}\n", all.dump(2));
        return exit_done;
    }
    const bool color = wants_color(STDOUT_FILENO);
    for (const Selection& selection : selections) {
        if (&selection != selections.data()) fmt::print("\n");
        print_assignment(selection.assignment, color);
        if (options.scenes || !options.what.empty())
            print_scenes(selection.assignment, color);
        else if (!selection.assignment.scenes.empty())
            fmt::print(
                "  scenes: {}\n",
                wrapped(fmt::format("{}", fmt::join(selection.assignment.scenes, " ")), 70, 10));
    }
    return exit_done;
}

} // namespace

Action declare_list(Options& options)
{
    const auto chosen = std::make_shared<ListOptions>();
    options.words("WHAT", chosen->what, "Assignments or topics; without one, all");
    options.flag("--scenes", chosen->scenes, "Say what each scene shows");
    options.flag("--json", chosen->json, "Print JSON");
    options.examples(
        {"list            all assignments", "list collision  one of them, with its scenes"});
    return [chosen] { return list(*chosen); };
}

} // namespace rigor
