// SPDX-License-Identifier: MIT
#include "grading/assignment.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "formulas/table.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/values.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <set>
#include <sstream>

namespace rigor {

namespace {

std::vector<std::string> texts(const Value& value, std::string_view what)
{
    std::vector<std::string> result;
    for (const Value& item : array(value, fmt::format("a list of {}", what)))
        result.push_back(line_of_text(item, what));
    return result;
}

// A task while it is read, and the JSON values whose lines the error messages name.
struct TaskDraft {
    Task task;
    const Value *tag = nullptr, *formula = nullptr, *scenes = nullptr, *parts = nullptr;
};

constexpr Key<PartOfPoints> part_keys[] = {
    {"law", "needed: the name of a test of the task",
     [](PartOfPoints& p, const Value& v) { p.law = line_of_text(v, "the name of a test"); }},
    {"points", "needed: > 0",
     [](PartOfPoints& p, const Value& v) { p.points = positive(v, "points"); }},
};

std::vector<PartOfPoints> parts_of(const Value& value)
{
    std::vector<PartOfPoints> parts;
    for (const Value& item : array(value, "a list of parts {\"law\": …, \"points\": …}")) {
        PartOfPoints part;
        read_object<PartOfPoints>(item, "a part {\"law\": …, \"points\": …}", part_keys, part);
        if (part.law.empty() || part.points == 0)
            throw Mistake{item.line, "expected \"law\" and \"points\" in the part"};
        for (const PartOfPoints& other : parts)
            if (other.law == part.law) expected("a law that no other part names", item);
        parts.push_back(std::move(part));
    }
    return parts;
}

constexpr std::string_view visibilities[] = {"visible", "hidden"};
constexpr std::string_view disclosures[] = {"all", "law", "nothing"};

constexpr Key<TaskDraft> task_keys[] = {
    {"tag", "needed: such as \"A2.14\"",
     [](TaskDraft& d, const Value& v) {
         d.task.tag = line_of_text(v, "a tag");
         d.tag = &v;
     }},
    {"formula", "the formula of that tag; or `title`",
     [](TaskDraft& d, const Value& v) {
         d.task.formula = line_of_text(v, "a formula");
         d.formula = &v;
     }},
    {"title", "of a task that is no formula",
     [](TaskDraft& d, const Value& v) { d.task.title = line_of_text(v, "a title"); }},
    {"points", "needed: > 0",
     [](TaskDraft& d, const Value& v) { d.task.points = positive(v, "points"); }},
    {"parts", "points for single laws, less than the points of the task in all",
     [](TaskDraft& d, const Value& v) {
         d.task.parts = parts_of(v);
         d.parts = &v;
     }},
    {"visibility", "needed: \"visible\" or \"hidden\"",
     [](TaskDraft& d, const Value& v) { d.task.is_hidden = one_of(v, visibilities) == 1; }},
    {"hint", "needed: one sentence for a student whose solution fails",
     [](TaskDraft& d, const Value& v) { d.task.hint = line_of_text(v, "a hint"); }},
    {"builds_on", "tags of the tasks whose formulas its tests call too",
     [](TaskDraft& d, const Value& v) { d.task.builds_on = texts(v, "tags"); }},
    {"discloses", "what a failure tells: \"all\", \"law\" or \"nothing\" (\"all\")",
     [](TaskDraft& d, const Value& v) {
         d.task.discloses = static_cast<Disclosure>(one_of(v, disclosures));
     }},
    {"scenes", "files of scenes/ that it is judged by",
     [](TaskDraft& d, const Value& v) {
         d.task.scenes = texts(v, "scene files");
         d.scenes = &v;
     }},
};

struct Draft {
    Assignment assignment;
    std::vector<TaskDraft> tasks;
    const Value *name = nullptr, *topic = nullptr, *tasks_value = nullptr, *scenes = nullptr;
};

void read_task(Draft& draft, const Value& value)
{
    TaskDraft task;
    read_object<TaskDraft>(value, "a task {\"tag\": …}", task_keys, task);
    for (const std::string_view key : {"tag", "points", "visibility", "hint"})
        if (!find(value, key))
            throw Mistake{value.line, fmt::format("expected \"{}\" in the task, found none", key)};
    if (task.task.formula.empty() == task.task.title.empty())
        throw Mistake{value.line,
                      fmt::format("expected either \"formula\" or \"title\" in the task, found {}",
                                  task.task.title.empty() ? "neither" : "both")};
    double sum = 0;
    for (const PartOfPoints& part : task.task.parts)
        sum += part.points;
    if (sum > 0 && sum >= task.task.points)
        throw Mistake{task.parts->line,
                      fmt::format("expected parts of less than {:g} points in all, found {:g}",
                                  task.task.points, sum)};
    draft.tasks.push_back(std::move(task));
}

constexpr Key<Draft> assignment_keys[] = {
    {"assignment", "needed: the folder's name",
     [](Draft& d, const Value& v) {
         d.assignment.name = line_of_text(v, "a name");
         d.name = &v;
     }},
    {"title", "needed",
     [](Draft& d, const Value& v) { d.assignment.title = line_of_text(v, "a title"); }},
    {"topic", "needed: a topic of the table of formulas",
     [](Draft& d, const Value& v) {
         d.assignment.topic = line_of_text(v, "a topic");
         d.topic = &v;
     }},
    {"submit", "needed: the files that a student hands in",
     [](Draft& d, const Value& v) { d.assignment.submit = texts(v, "file names"); }},
    {"tasks", "needed: one for each formula of the topic, and more",
     [](Draft& d, const Value& v) {
         d.tasks_value = &v;
         for (const Value& item : array(v, "a list of tasks"))
             read_task(d, item);
     }},
    {"scenes", "files of scenes/ to watch",
     [](Draft& d, const Value& v) {
         d.assignment.scenes = texts(v, "scene files");
         d.scenes = &v;
     }},
};

const Formula* formula_of_tag(std::string_view tag)
{
    const auto found = std::find_if(std::begin(formulas), std::end(formulas),
                                    [&](const Formula& row) { return row.tag == tag; });
    return found == std::end(formulas) ? nullptr : found;
}

// Checks that the formula that a task names has the same tag in the table of formulas.
void check_formula(const Assignment& assignment, const TaskDraft& draft)
{
    const Task& task = draft.task;
    const Formula* row = formula_of_tag(task.tag);
    const bool of_topic = row && row->topic == assignment.topic;
    if (task.formula.empty()) {
        if (row) expected("the tag of no formula for a task with a title", *draft.tag);
    } else if (!of_topic) {
        expected(fmt::format("the tag of a formula of topic {}", assignment.topic), *draft.tag);
    } else if (row->name != task.formula) {
        expected(fmt::format("{}, the formula {}", row->name, row->tag), *draft.formula);
    }
}

void check_scenes(const Assignment& assignment, const std::vector<std::string>& scenes,
                  const Value* value)
{
    for (const std::string& scene : scenes)
        if (!std::filesystem::exists(assignment.folder / "scenes" / scene))
            throw Mistake{value->line,
                          fmt::format("expected files of scenes/, found {}", in_quotes(scene))};
}

// Checks that each tag has only one task, that each formula of the topic has a task, and that the
// scenes of the tasks exist.
void check_tasks(const Draft& draft)
{
    std::set<std::string_view> tags;
    for (const TaskDraft& task : draft.tasks) {
        if (!tags.insert(task.task.tag).second) expected("a tag that no other task has", *task.tag);
        check_formula(draft.assignment, task);
        check_scenes(draft.assignment, task.task.scenes, task.scenes);
    }
    bool is_topic = false;
    for (const Formula& row : formulas) {
        if (row.topic != draft.assignment.topic) continue;
        is_topic = true;
        if (!tags.count(row.tag))
            throw Mistake{draft.tasks_value->line,
                          fmt::format("expected a task for {} {}, found none", row.tag, row.name)};
    }
    if (!is_topic) expected("a topic of the table of formulas", *draft.topic);
}

Assignment read_assignment(const std::string& text, const std::filesystem::path& folder)
{
    const Value value = parse_json(text);
    Draft draft;
    draft.assignment.folder = folder;
    read_object<Draft>(value, "an assignment {\"assignment\": …}", assignment_keys, draft);
    for (const std::string_view key : {"assignment", "title", "topic", "submit", "tasks"})
        if (!find(value, key))
            throw Mistake{value.line, fmt::format("expected \"{}\", found none", key)};
    if (draft.assignment.name != folder.filename())
        expected(fmt::format("{}, the folder's name", folder.filename().string()), *draft.name);
    if (draft.tasks.empty()) expected("at least one task", *draft.tasks_value);
    if (draft.assignment.submit.empty())
        throw Mistake{value.line, "expected a file in \"submit\", found none"};
    check_tasks(draft);
    check_scenes(draft.assignment, draft.assignment.scenes, draft.scenes);
    for (TaskDraft& task : draft.tasks)
        draft.assignment.tasks.push_back(std::move(task.task));
    return draft.assignment;
}

} // namespace

const Task* Assignment::task(std::string_view tag) const
{
    for (const Task& task : tasks)
        if (task.tag == tag) return &task;
    return nullptr;
}

double Assignment::points() const
{
    double sum = 0;
    for (const Task& task : tasks)
        sum += task.points;
    return sum;
}

Assignment load_assignment(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    std::stringstream content;
    content << stream.rdbuf();
    if (!stream) throw InputError(file.string() + ": cannot be read");
    try {
        return read_assignment(content.str(), file.parent_path());
    } catch (const Mistake& mistake) {
        throw InputError(fmt::format("{}:{}: {}", file.string(), mistake.line, mistake.message));
    }
}

std::vector<Assignment> load_assignments(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (std::filesystem::exists(entry.path() / "assignment.json"))
            files.push_back(entry.path() / "assignment.json");
    if (files.empty())
        throw InputError(folder.string() +
                         ": expected folders with an assignment.json, found none");
    std::sort(files.begin(), files.end());
    std::vector<Assignment> assignments;
    assignments.reserve(files.size());
    for (const auto& file : files)
        assignments.push_back(load_assignment(file));
    return assignments;
}

} // namespace rigor
