// SPDX-License-Identifier: MIT
#include "release/proof.hpp"

#include "grading/process.hpp"
#include "release/tree.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace rigor {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

// Runs `rigor check --json` of the tree and returns what it writes to stdout. Its stderr is shown.
std::string checked(const fs::path& tree, const std::vector<std::string>& options)
{
    Command command;
    command.arguments = {(tree / "rigor").string(), "check", "--json"};
    command.arguments.insert(command.arguments.end(), options.begin(), options.end());
    command.environment = {"RIGOR_PRESET=release"};
    command.folder = tree;
    command.shares_stderr = true;
    std::string text;
    const Ended ended = run(command, [&](std::string_view line) { text.append(line) += '\n'; });
    if (ended.signal == 0 && ended.status <= 1) return text;
    throw std::runtime_error(
        fmt::format("{} check ended with status {}", command.arguments.front(), ended.status));
}

std::string fault_of_task(const Json& task, bool solved)
{
    const std::string tag = task.at("tag"), status = task.at("status");
    const double score = task.at("score"), most = task.at("max_score");
    if (task.at("visibility") == "hidden")
        return most == 0 ? "" : fmt::format("hidden task {} counts in the students' tree", tag);
    if (most <= 0) return fmt::format("visible task {} did not run", tag);
    const char* expected = solved ? "passed" : "not_implemented";
    if (status != expected || score != (solved ? most : 0))
        return fmt::format("{}: expected {} for the {}, found {} with {:g} of {:g} points", tag,
                           expected, solved ? "reference" : "stub", status, score, most);
    return "";
}

} // namespace

std::string fault_of_tree(const std::string& json, bool solved, TreeProof& proof)
{
    const Json results = Json::parse(json, nullptr, false);
    if (!results.is_array() || results.empty()) return "it printed no list of results";
    proof = {};
    for (const Json& result : results) {
        if (result.at("status") != "graded")
            return fmt::format("{} is {}: {}", result.at("assignment").dump(),
                               result.at("status").dump(), result.at("message").dump());
        for (const Json& task : result.at("tests")) {
            if (std::string fault = fault_of_task(task, solved); !fault.empty()) return fault;
            if (task.at("visibility") == "hidden") continue;
            ++proof.tasks;
            proof.points += task.at("max_score").get<double>();
        }
    }
    return proof.tasks > 0 ? "" : "it has no visible task";
}

void write_solved_files(const fs::path& reference, const fs::path& folder)
{
    std::map<std::string, std::string> files;
    std::set<fs::path> sources;
    for (const auto& entry : fs::directory_iterator(reference))
        if (entry.is_regular_file()) sources.insert(entry.path());
    for (const fs::path& source : sources) {
        const std::string name = source.filename().string(),
                          topic = name.substr(0, name.find_first_of("_."));
        files[source.extension() == ".cpp" ? topic + ".cpp" : name] += file_content(source);
    }
    ReleasedTree tree;
    for (const auto& [name, content] : files)
        add_file(tree, {name, content, false});
    write_tree(tree, folder);
}

TreeProof prove_students_tree(const fs::path& tree, const fs::path& reference,
                              const OnProofStep& on_step)
{
    TreeProof proof;
    const fs::path solved_files = tree.string() + ".solved";
    write_solved_files(reference, solved_files);
    for (const bool solved : {false, true}) {
        on_step(solved ? "checking that the reference gets every visible point there"
                       : "building the students' tree and checking that its stubs get no point");
        const std::vector<std::string> options =
            solved ? std::vector<std::string>{"--with", solved_files.string()}
                   : std::vector<std::string>{};
        std::string fault = fault_of_tree(checked(tree, options), solved, proof);
        if (!fault.empty()) { // on a busy machine a task may not end in time
            std::fprintf(stderr, "once more, since %s\n", fault.c_str());
            fault = fault_of_tree(checked(tree, options), solved, proof);
        }
        if (!fault.empty())
            throw std::runtime_error("the students' tree is not handed out: " + fault);
    }
    return proof;
}

} // namespace rigor
