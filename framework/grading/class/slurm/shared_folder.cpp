// SPDX-License-Identifier: MIT
#include "grading/class/slurm/shared_folder.hpp"

#include "errors/input_error.hpp"
#include "errors/printable.hpp"
#include "errors/quotes.hpp"
#include "errors/utf8.hpp"
#include "grading/class/environment.hpp"
#include "report/write_whole.hpp"

#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

namespace rigor::slurm {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

std::optional<std::string> text_in(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) return {};
    return std::string{std::istreambuf_iterator<char>(in), {}};
}

// @throws InputError if the path is not UTF-8, because a plan cannot hold it
std::string in_plan(const fs::path& path)
{
    const std::string text = path.string();
    if (!is_plain_utf8(text))
        throw InputError("expected a path in UTF-8 without control characters, found " +
                         in_quotes(text));
    return text;
}

// Names of the files in a folder, without the files that are still being written (ending `.new`).
std::set<std::string> names_in(const fs::path& folder)
{
    std::set<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().extension() != ".new") names.insert(entry->path().filename().string());
    return names;
}

// Two tasks may write the same file: if Slurm takes a node for lost and starts its task again
// elsewhere, the first task may still run. So each writes a file of its own first, and renames it.
void write_by_task(const fs::path& file, const std::string& text)
{
    const fs::path own = fmt::format(
        "{}.{}_{}_{}.new", file.string(), environment_variable("SLURM_JOB_ID"),
        environment_variable("SLURM_RESTART_COUNT"), environment_variable("SLURMD_NODENAME"));
    write_whole(own, text);
    fs::rename(own, file);
}

std::string log_name(unsigned round, const std::string& task)
{
    return fmt::format("{}_{}.txt", round, task);
}

} // namespace

std::string new_run()
{
    std::random_device random;
    return fmt::format("{:08x}{:08x}", random(), random());
}

SharedFolder::SharedFolder(const fs::path& out, const std::string& run)
    : folder_(out / ".rigor" / "slurm" / run)
{
}

std::vector<SharedFolder> SharedFolder::all(const fs::path& out)
{
    std::vector<SharedFolder> folders;
    for (const std::string& run : names_in(out / ".rigor" / "slurm"))
        folders.emplace_back(out, run);
    return folders;
}

void SharedFolder::make() const
{
    for (const char* name : {"graded", "ended", "log"}) {
        std::error_code error;
        fs::create_directories(folder_ / name, error);
        if (error)
            throw InputError((folder_ / name).string() + ": cannot be made: " + error.message());
    }
    write_whole(script(), "#!/bin/sh\nexec \"$@\"\n");
}

void SharedFolder::remove() const
{
    std::error_code error;
    fs::remove_all(folder_, error);
    fs::remove(folder_.parent_path(), error); // if this was the only run
}

fs::path SharedFolder::write_plan(const Plan& plan) const
{
    Json submissions = Json::array();
    for (std::size_t i = 0; i < plan.submissions.size(); ++i) {
        const Submission& submission = plan.submissions[i];
        // one that is refused is not read, whatever its name is
        const std::string path = submission.refusal.empty() ? in_plan(submission.path) : "";
        submissions.push_back({{"name", submission.name},
                               {"path", path},
                               {"refusal", submission.refusal},
                               {"fingerprint", plan.fingerprints[i]}});
    }
    const Json json = {{"run", plan.run},
                       {"round", plan.round},
                       {"assignment", plan.assignment},
                       {"out", in_plan(plan.out)},
                       {"seed", plan.seed},
                       {"secret_file", in_plan(plan.secret_file)},
                       {"fingerprint", plan.fingerprint},
                       {"submissions", submissions},
                       {"chunks", plan.chunks}};
    const fs::path file = folder_ / fmt::format("plan_{}.json", plan.round);
    write_whole(file, json.dump(1) + "\n");
    return file;
}

Plan read_plan(const fs::path& file)
{
    try {
        const Json json = Json::parse(text_in(file).value_or(""));
        Plan plan = {json.at("run"),
                     json.at("round"),
                     json.at("assignment"),
                     json.at("out"),
                     json.at("seed"),
                     json.at("secret_file"),
                     json.at("fingerprint"),
                     {},
                     {},
                     json.at("chunks")};
        for (const Json& entry : json.at("submissions")) {
            plan.submissions.push_back(
                {entry.at("name"), entry.at("path").get<std::string>(), entry.at("refusal")});
            plan.fingerprints.push_back(entry.at("fingerprint"));
        }
        for (const auto& chunk : plan.chunks)
            for (const std::size_t i : chunk)
                if (i >= plan.submissions.size()) throw std::out_of_range("a chunk");
        return plan;
    } catch (const std::exception&) {
        throw InputError("expected the plan of a job that `grade --engine slurm` wrote, found " +
                         in_quotes(file.string()));
    }
}

std::string SharedFolder::job() const
{
    std::string text = text_in(folder_ / "job").value_or("");
    return text.substr(0, text.find('\n'));
}

void SharedFolder::write_job(const std::string& job) const
{
    write_whole(folder_ / "job", job + "\n");
}

std::optional<ResultFiles> SharedFolder::graded(const std::string& fingerprint) const
{
    const std::optional<std::string> text = text_in(folder_ / "graded" / fingerprint);
    return text ? std::optional(unpacked(*text)) : std::nullopt;
}

std::set<std::string> SharedFolder::all_graded() const
{
    return names_in(folder_ / "graded");
}

void SharedFolder::write_graded(const std::string& fingerprint, const ResultFiles& files) const
{
    write_by_task(folder_ / "graded" / fingerprint, packed(files));
}

void SharedFolder::write_ended(unsigned round, std::size_t task) const
{
    write_by_task(folder_ / "ended" / fmt::format("{}.{}", round, task), "");
}

std::set<std::size_t> SharedFolder::ended(unsigned round, std::size_t tasks) const
{
    const std::set<std::string> names = names_in(folder_ / "ended");
    std::set<std::size_t> ended;
    for (std::size_t task = 0; task < tasks; ++task)
        if (names.count(fmt::format("{}.{}", round, task))) ended.insert(task);
    return ended;
}

void SharedFolder::write_control_fault(const std::string& fault) const
{
    write_by_task(folder_ / "control_fault", fault);
}

std::string SharedFolder::control_fault() const
{
    return text_in(folder_ / "control_fault").value_or("");
}

fs::path SharedFolder::log_pattern(unsigned round) const
{
    return folder_ / "log" / log_name(round, "%a");
}

bool SharedFolder::has_log(unsigned round) const
{
    for (const std::string& name : names_in(folder_ / "log"))
        if (name.starts_with(fmt::format("{}_", round))) return true;
    return false;
}

std::string SharedFolder::last_words(unsigned round, std::size_t task) const
{
    std::string text =
        text_in(folder_ / "log" / log_name(round, std::to_string(task))).value_or("");
    while (text.ends_with('\n'))
        text.pop_back();
    return printable(text.substr(text.rfind('\n') + 1).substr(0, 300));
}

} // namespace rigor::slurm
