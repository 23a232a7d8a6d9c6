// SPDX-License-Identifier: MIT
// Does with an autograder what Gradescope does, in another folder than /autograder. Gradescope
// unpacks the zip to /autograder/source, copies run_autograder beside it, runs setup.sh once, and
// for each submission fills /autograder/submission and runs /autograder/run_autograder.
#include "release/autograder_proof.hpp"

#include "grading/process.hpp"
#include "release/zip.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// The user and group `nobody` of Debian and Ubuntu.
constexpr int nobody = 65534;

// The user who runs the programs in the layout, which is the folder that takes the place of
// /autograder: `nobody` if this process runs as root and `nobody` can write to the layout,
// otherwise the user of this process.
class LayoutUser {
public:
    explicit LayoutUser(const fs::path& layout) : layout_(layout)
    {
        if (geteuid() != 0) return;
        give_away();
        Command probe;
        probe.arguments = as_nobody({"test", "-w", layout.string()});
        is_nobody_ = run(probe, [](std::string_view) {}).ok();
    }

    bool is_nobody() const { return is_nobody_; }

    // Makes `nobody` the owner of everything in the layout, if this process runs as root.
    void give_away() const
    {
        if (geteuid() != 0) return;
        Command command;
        command.arguments = {"chown", "-R", fmt::format("{}:{}", nobody, nobody), layout_.string()};
        run(command, [](std::string_view) {});
    }

    void run_script(const fs::path& script) const
    {
        Command command;
        command.arguments = {script.string()};
        if (is_nobody_) command.arguments = as_nobody(command.arguments);
        command.environment = {"RIGOR_PRESET=release", "HOME=" + layout_.string()};
        command.folder = layout_;
        command.shares_stderr = true;
        std::string last;
        const Ended ended = run(command, [&](std::string_view line) { last = line; });
        if (!ended.ok())
            throw std::runtime_error(fmt::format("{} ended with status {}: {}",
                                                 script.filename().string(), ended.status, last));
    }

private:
    static std::vector<std::string> as_nobody(const std::vector<std::string>& arguments)
    {
        std::vector<std::string> all = {"setpriv", fmt::format("--reuid={}", nobody),
                                        fmt::format("--regid={}", nobody), "--clear-groups"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return all;
    }

    fs::path layout_;
    bool is_nobody_ = false;
};

// Unpacks the autograder as Gradescope does, without the folders of a submission and its results.
void lay_out(const fs::path& zip, const fs::path& layout)
{
    write_tree(unzipped(zip), layout / "source", "rigor/build");
    fs::copy_file(layout / "source/run_autograder", layout / "run_autograder",
                  fs::copy_options::overwrite_existing);
}

// Hands in the files of a submission and runs the autograder. @return its results.json
std::string results_json_after(const ReleasedTree& submission, const fs::path& layout,
                               const LayoutUser& user)
{
    const fs::path results = layout / "results/results.json";
    fs::remove_all(layout / "results");
    fs::create_directories(layout / "submission");
    write_tree(submission, layout / "submission");
    user.give_away();
    user.run_script(layout / "run_autograder");
    return fs::exists(results) ? file_content(results) : std::string();
}

// The submission of a student who has solved everything: the topic's file and the headers beside
// it.
ReleasedTree solved_submission(const fs::path& reference, const fs::path& folder,
                               const std::string& file)
{
    write_solved_files(reference, folder);
    ReleasedTree submission;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename() == file || entry.path().extension() == ".hpp")
            add_file(submission,
                     {entry.path().filename().string(), file_content(entry.path()), false});
    return submission;
}

} // namespace

std::string fault_of_results(const std::string& json, double score, double most)
{
    const nlohmann::json results = nlohmann::json::parse(json, nullptr, false);
    if (!results.is_object() || !results.contains("score") || !results.contains("tests"))
        return "expected a score and tests, found " + json.substr(0, 100);
    double sum = 0, largest = 0;
    for (const auto& test : results.at("tests")) {
        sum += test.at("score").get<double>();
        largest += test.at("max_score").get<double>();
    }
    const double found = results.at("score").get<double>();
    if (found == score && sum == score && largest == most) return "";
    return fmt::format("expected {:g} of {:g} points, found {:g}; its tests give {:g} of {:g}",
                       score, most, found, sum, largest);
}

std::string prove_autograder(const fs::path& zip, const fs::path& layout,
                             const Assignment& assignment, const fs::path& source,
                             const OnProofStep& on_step)
{
    const std::string file = assignment.topic + ".cpp";
    lay_out(zip, layout);
    const LayoutUser user(layout);
    on_step("building the autograder by its setup.sh");
    user.run_script(layout / "source/setup.sh");

    on_step("checking that run_autograder gives a solved submission every point");
    const std::string solved = results_json_after(
        solved_submission(source / "reference", layout.string() + ".solved", file), layout, user);
    const nlohmann::json json = nlohmann::json::parse(solved, nullptr, false);
    // How many points there are depends on the machine: hidden tasks count only if the sandbox is
    // strong enough to run them. So the score is compared with the sum of the tests' maxima.
    const double most = json.is_object() ? json.value("score", 0.0) : 0.0;
    if (most <= 0) throw std::runtime_error("the autograder gives a solution no points");
    if (const std::string fault = fault_of_results(solved, most, most); !fault.empty())
        throw std::runtime_error("the autograder and a solved submission: " + fault);

    const std::pair<const char*, ReleasedTree> worthless[] = {
        {"a file without formulas", {{file, "// nothing yet\n", false}}},
        {"an empty submission", {}}};
    for (const auto& [what, submission] : worthless) {
        on_step(fmt::format("checking that run_autograder gives {} no point", what));
        const std::string fault =
            fault_of_results(results_json_after(submission, layout, user), 0, most);
        if (!fault.empty())
            throw std::runtime_error(fmt::format("the autograder and {}: {}", what, fault));
    }
    return user.is_nobody() ? "nobody" : "this user";
}

} // namespace rigor
