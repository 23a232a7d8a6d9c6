// SPDX-License-Identifier: MIT
// Selects the tasks that the words of the command line name. Each word is compared, in lower case,
// with the names, topics, tags and formulas of all assignments. A word that names nothing is an
// error with a hint: the range of tags if it looks like a tag, or else the nearest name.
#include "grading/selection.hpp"

#include "errors/input_error.hpp"
#include "errors/nearest.hpp"
#include "errors/quotes.hpp"

#include <algorithm>
#include <cctype>

namespace rigor {

namespace {

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool names(const std::string& word, const Assignment& assignment)
{
    return word == assignment.name || word == assignment.label() || word == assignment.topic;
}

// Marks the tasks that a word names. @return whether there are any
bool mark(const std::string& word, const std::vector<Assignment>& assignments,
          std::vector<std::vector<bool>>& marked)
{
    bool found = false;
    for (std::size_t a = 0; a < assignments.size(); ++a)
        for (std::size_t t = 0; t < assignments[a].tasks.size(); ++t) {
            const Task& task = assignments[a].tasks[t];
            const bool named = names(word, assignments[a]) || word == lower(task.tag) ||
                               word == lower(task.formula);
            if (named) found = marked[a][t] = true;
        }
    return found;
}

bool is_number(std::string_view text)
{
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

// A hint for a word that looks like a tag, such as a6.11 or a9: the range of the assignment's tags,
// or the command that lists all tags. The result is empty for any other word.
std::string tags_there_are(const std::string& word, const std::vector<Assignment>& assignments)
{
    const std::size_t point = word.find('.');
    if (word[0] != 'a' || !is_number(std::string_view(word).substr(1, point - 1))) return "";
    if (point != std::string::npos && !is_number(std::string_view(word).substr(point + 1)))
        return "";
    for (const Assignment& assignment : assignments)
        if (word.substr(0, point) == assignment.label())
            return "; its tasks are " + assignment.tasks.front().tag + " to " +
                   assignment.tasks.back().tag;
    return "; `rigor list` names them";
}

// What to tell a user about a word that names nothing: the range of existing tags, or the nearest
// name.
std::string suggestion_for(const std::string& word, const std::vector<Assignment>& assignments)
{
    if (const std::string tags = tags_there_are(word, assignments); !tags.empty()) return tags;
    std::vector<std::string> known;
    for (const Assignment& assignment : assignments) {
        const std::string& name = assignment.name; // such as "a4-collision"
        known.insert(known.end(), {assignment.topic, name, name.substr(0, name.find('-'))});
        for (const Task& task : assignment.tasks) {
            known.push_back(lower(task.tag));
            if (!task.formula.empty()) known.push_back(task.formula);
        }
    }
    return suggestion(word, known);
}

} // namespace

std::vector<Selection> select_tasks(const std::vector<Assignment>& assignments,
                                    const std::vector<std::string>& words)
{
    std::vector<std::vector<bool>> marked;
    marked.reserve(assignments.size());
    for (const Assignment& assignment : assignments)
        marked.emplace_back(assignment.tasks.size(), words.empty());
    for (const std::string& word : words)
        if (word.empty() || !mark(lower(word), assignments, marked))
            throw InputError("expected an assignment, a topic, a task's tag or a formula, found " +
                             in_quotes(word) + suggestion_for(lower(word), assignments));

    std::vector<Selection> result;
    for (std::size_t a = 0; a < assignments.size(); ++a) {
        Selection selection = {assignments[a], {}};
        for (std::size_t t = 0; t < assignments[a].tasks.size(); ++t)
            if (marked[a][t]) selection.tags.push_back(assignments[a].tasks[t].tag);
        if (!selection.tags.empty()) result.push_back(selection);
    }
    return result;
}

} // namespace rigor
