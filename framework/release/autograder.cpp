// SPDX-License-Identifier: MIT
#include "release/autograder.hpp"

#include "grading/build/replace_all.hpp"
#include "grading/class/called_stubs.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace rigor {

namespace {

constexpr std::string_view setup_script = R"sh(#!/usr/bin/env bash
# Gradescope runs this once, as root, when it builds the image of the autograder. It installs the
# packages, builds everything, and shows that the reference gets every point here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. /etc/os-release
case "$ID $VERSION_ID" in
"debian 12" | "debian 13" | "ubuntu 24.04") ;;
*) echo "expected an image with Ubuntu 24.04, Debian 12 or Debian 13, found $PRETTY_NAME" >&2 ;;
esac
"$here/rigor/rigor" grade --help >/dev/null # builds the program that grades
"$here/rigor/rigor" check ASSIGNMENT --with reference
)sh";

constexpr std::string_view run_script = R"sh(#!/usr/bin/env bash
# Gradescope runs this for each submission, from /autograder. It grades /autograder/submission and
# writes /autograder/results/results.json. Without that file Gradescope says that the autograder
# failed, and gives no points: so it is with every fault that is not the student's.
set -euo pipefail
home=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/class" "$home/results"
rm -f "$home/results/results.json"
cp -rP "$home/submission" "$work/class/submission"
"$home/source/rigor/rigor" grade ASSIGNMENT "$work/class" --out "$work/grades" --jobs 1OPTIONS
cp "$work/grades/submission/gradescope.json" "$home/results/results.json.new"
mv "$home/results/results.json.new" "$home/results/results.json" # whole or not at all
)sh";

// @param options  what `grade` gets besides, such as ` --secret FILE`
std::string script(std::string_view text, const Assignment& assignment,
                   const std::string& options = "")
{
    std::string result(text);
    replace_all(result, "ASSIGNMENT", assignment.name);
    replace_all(result, "OPTIONS", options);
    return result;
}

// The identifier of a task's step: "a4-8" for A4.8.
std::string step_of(const Task& task)
{
    std::string id = task.tag;
    for (char& c : id)
        c = c == '.' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return id;
}

// The name under which GitHub Classroom looks for the results of a step: the step's identifier in
// capitals, followed by _RESULTS.
std::string results_of(const std::string& step)
{
    std::string name = step;
    for (char& c : name)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name + "_RESULTS";
}

constexpr std::string_view workflow_head = R"(# Checks the visible tasks of ASSIGNMENT at each push.
name: Autograding Tests
on:
  - push
  - workflow_dispatch
permissions:
  checks: write
  actions: read
  contents: read
jobs:
  run-autograding-tests:
    runs-on: ubuntu-24.04
    if: github.actor != 'github-classroom[bot]'
    steps:
      - name: Checkout code
        uses: actions/checkout@v4
      - name: Install, build and show the report
        run: ./rigor check ASSIGNMENT || [ $? -eq 1 ]
)";

} // namespace

ReleasedTree gradescope_tree(const std::filesystem::path& source, const Assignment& assignment,
                             const std::string& secret)
{
    ReleasedTree tree;
    const std::vector<std::string> stubs = called_stubs(source, assignment.topic);
    for (ReleasedFile& file : grading_tree(source)) {
        for (const std::string& topic : stubs)
            if (file.path == "student/" + topic + ".cpp")
                file.content = file_content(source / "reference" / (topic + ".cpp"));
        file.path = "rigor/" + file.path;
        tree.push_back(std::move(file));
    }
    add_file(tree, {"setup.sh", script(setup_script, assignment), true});
    if (!secret.empty()) add_file(tree, {"secret", secret + "\n", false});
    const std::string options = secret.empty() ? "" : " --secret \"$home/source/secret\"";
    add_file(tree, {"run_autograder", script(run_script, assignment, options), true});
    return tree;
}

std::string classroom_workflow(const Assignment& assignment)
{
    std::string text = script(workflow_head, assignment), results, runners;
    for (const Task& task : assignment.tasks) {
        if (task.is_hidden) continue;
        const std::string step = step_of(task);
        text += fmt::format("      - name: {0} {1}\n"
                            "        id: {2}\n"
                            "        uses: classroom-resources/autograding-command-grader@v1\n"
                            "        with:\n"
                            "          test-name: {0} {1}\n"
                            "          command: ./rigor check {0}\n"
                            "          timeout: 10\n"
                            "          max-score: {3:g}\n",
                            task.tag, task.name(), step, task.points);
        results += fmt::format("          {}: \"${{{{steps.{}.outputs.result}}}}\"\n",
                               results_of(step), step);
        runners += (runners.empty() ? "" : ",") + step;
    }
    return text +
           "      - name: Autograding Reporter\n"
           "        uses: classroom-resources/autograding-grading-reporter@v1\n"
           "        env:\n" +
           results + "        with:\n          runners: " + runners + "\n";
}

} // namespace rigor
