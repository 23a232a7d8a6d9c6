// SPDX-License-Identifier: MIT
// The content of assignments/<name>/assignment.json: the tasks of an assignment, their points and
// hints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// What a student is told about a test that failed.
enum class Disclosure {
    all,    // the law, the case, and the numbers
    law,    // the law that broke, and how
    nothing // that the task failed
};

/// Points for one law of a task, which are earned even if another law breaks.
struct PartOfPoints {
    std::string law; // the name of a test case
    double points = 0;
};

struct Task {
    std::string tag;                 // "A2.14"
    std::string formula;             // "combine"; empty for a task about scenes
    std::string title;               // name of a task that is not about a formula
    double points = 0;               // for the task as a whole
    std::vector<PartOfPoints> parts; // less than `points` in all; the rest is for all laws together
    bool is_hidden = false;          // its tests compare with the reference
    std::string hint;                // for a student whose solution fails
    std::vector<std::string> builds_on; // tags of the tasks whose formulas its tests call too
    std::vector<std::string> scenes;    // files of the scenes it is judged by
    Disclosure discloses = Disclosure::all;

    const std::string& name() const { return formula.empty() ? title : formula; }
};

struct Assignment {
    std::string name;                // "a2-inertia", the name of the folder
    std::string title;               // "Inertia tensors"
    std::string topic;               // "inertia"
    std::vector<std::string> submit; // the files a student hands in
    std::vector<Task> tasks;         // in the order of their tags
    std::vector<std::string> scenes; // files in scenes/
    std::filesystem::path folder;

    std::string label() const { return name.substr(0, name.find('-')); } // "a2"
    const Task* task(std::string_view tag) const;
    double points() const;
};

/// Reads one assignment.json and checks it against the table of formulas: each formula of the topic
/// has exactly one task, with the same tag.
/// @throws InputError that names the file, the place in it, what was expected and what was found
Assignment load_assignment(const std::filesystem::path& file);

/// Reads all assignments, `folder`/*/assignment.json, sorted by name. @throws InputError also if
/// there is none
std::vector<Assignment> load_assignments(const std::filesystem::path& folder);

} // namespace rigor
