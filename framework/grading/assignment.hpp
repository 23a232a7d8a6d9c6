// SPDX-License-Identifier: MIT
// The content of assignments/<name>/assignment.json: the tasks of an assignment, their points and
// hints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// What a student is told about a test that failed. The law of a test is the statement that it
/// checks.
enum class Disclosure {
    all,    // the law, the case and the numbers that were compared
    law,    // the law, and a status such as `crashed`
    nothing // only a status such as `crashed`
};

/// Points for one law of a task, that is, for one statement that a test case checks. They are
/// earned if this law holds, even if other laws do not.
struct PartOfPoints {
    std::string law; // the name of the test case that checks this law
    double points = 0;
};

struct Task {
    std::string tag;     // such as "A2.14"
    std::string formula; // such as "combine"; empty if the task has a `title`
    std::string title;   // the task's name if it has no `formula`
    double points = 0;   // for the whole task, including `parts`
    /// The points of the parts add up to less than `points`. The difference is earned only if all
    /// laws hold.
    std::vector<PartOfPoints> parts;
    bool is_hidden = false;             // whether its tests are hidden; they need the reference
    std::string hint;                   // shown to a student whose solution fails
    std::vector<std::string> builds_on; // tags of other tasks whose formulas its tests call
    std::vector<std::string> scenes;    // files in scenes/ that its tests run
    Disclosure discloses = Disclosure::all;

    const std::string& name() const { return formula.empty() ? title : formula; }
};

struct Assignment {
    std::string name;                // the name of the folder, such as "a2-inertia"
    std::string title;               // such as "Inertia tensors"
    std::string topic;               // such as "inertia"
    std::vector<std::string> submit; // the files a student hands in
    std::vector<Task> tasks;         // in the order of assignment.json
    std::vector<std::string> scenes; // files in scenes/ that a student can watch
    std::filesystem::path folder;

    std::string label() const { return name.substr(0, name.find('-')); } // such as "a2"
    const Task* task(std::string_view tag) const;
    double points() const;
};

/// Reads one assignment.json and checks it against the table of formulas: each formula of the topic
/// has exactly one task, with the same tag.
/// @throws InputError that names the file, the line, what was expected and what was found
Assignment load_assignment(const std::filesystem::path& file);

/// Reads all assignments, `folder`/*/assignment.json, sorted by name. @throws InputError if a file
/// has an error, or if there is no such file
std::vector<Assignment> load_assignments(const std::filesystem::path& folder);

} // namespace rigor
