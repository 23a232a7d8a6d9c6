// SPDX-License-Identifier: MIT
#include "grading/class/class_folder.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "report/write_whole.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr const char* run_file = "run.json";
constexpr const char* unconfirmed_file = "unconfirmed";
constexpr const char* gradebook_file = "gradebook.csv";

void make_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (fs::is_directory(folder)) return;
    const bool is_other = fs::exists(fs::symlink_status(folder));
    throw InputError("--out: expected a folder, found " + folder.string() +
                     (is_other ? ", which is none" : ", which cannot be made: " + error.message()));
}

// The unconfirmed results that a file lists, as pairs: the name of a submission, and the
// fingerprint (hash) of its result. The list may have several results for one submission.
std::set<std::pair<std::string, std::string>> unconfirmed(const fs::path& file)
{
    std::ifstream in(file);
    if (!in) return {};
    try {
        return Json::parse(in).get<std::set<std::pair<std::string, std::string>>>();
    } catch (const Json::exception&) {
        throw InputError(file.string() + ": expected names and fingerprints, found another text: "
                                         "remove it, and the results that are younger than it");
    }
}

} // namespace

ClassFolder::ClassFolder(const fs::path& folder, const std::string& assignment,
                         const std::vector<std::string>& submissions)
{
    make_folder(folder);
    folder_ = fs::canonical(folder);
    state_ = folder_ / ".rigor";
    check_owner(assignment, submissions);
    make_folder(state_);
    lock();
    write_whole(state_ / run_file, Json({{"assignment", assignment}, {"submissions", submissions}})
                                           .dump(2, ' ', false, Json::error_handler_t::replace) +
                                       "\n");
}

ClassFolder::~ClassFolder()
{
    if (descriptor_ >= 0) close(descriptor_);
}

void ClassFolder::lock()
{
    const fs::path file = state_ / "lock";
    descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
        throw InputError(file.string() + ": cannot be written: " + std::strerror(errno));
    // The child processes of a run that was killed hold the lock for a moment longer.
    for (int tries = 0; flock(descriptor_, LOCK_EX | LOCK_NB) != 0; ++tries) {
        if (tries == 30) {
            close(descriptor_);
            descriptor_ = -1;
            throw InputError("--out: another rigor writes its results to " + folder_.string());
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

void ClassFolder::check_owner(const std::string& assignment,
                              const std::vector<std::string>& submissions) const
{
    std::ifstream in(state_ / run_file);
    const Json run = in ? Json::parse(in, nullptr, false) : Json();
    if (!run.is_object() || !run.contains("assignment") || !run.contains("submissions")) {
        for (const auto& entry : fs::directory_iterator(folder_))
            if (entry.path() != state_)
                throw InputError(fmt::format(
                    "--out: expected an empty folder or one with results of {}, found {} in {}",
                    assignment, in_quotes(entry.path().filename().string()), folder_.string()));
        return;
    }
    if (run["assignment"] != assignment)
        throw InputError(fmt::format("--out: expected a folder with results of {}, found those of "
                                     "{} in {}",
                                     assignment, run["assignment"].dump(), folder_.string()));
    // A complete run writes all results, so a result that is missing now was removed on purpose.
    const bool has_all = fs::exists(folder_ / gradebook_file) && !has_unconfirmed();
    for (const Json& entry : run["submissions"]) {
        const std::string name = entry.is_string() ? entry.get<std::string>() : entry.dump();
        const bool is_named =
            std::find(submissions.begin(), submissions.end(), name) != submissions.end();
        const bool is_withdrawn = has_all && !fs::exists(folder_ / name);
        if (!is_named && !is_withdrawn)
            throw InputError(fmt::format(
                "--out: {} has a result of {}, which this run does not name: name all submissions, "
                "or another folder, or remove {} if this one is withdrawn",
                folder_.string(), entry.dump(), (folder_ / name).string()));
    }
}

fs::path ClassFolder::result_of(const std::string& submission) const
{
    return folder_ / submission / "result.json";
}

std::optional<Row> ClassFolder::row_of(const std::string& submission) const
{
    std::ifstream in(result_of(submission), std::ios::binary);
    return read_row({std::istreambuf_iterator<char>(in), {}});
}

bool ClassFolder::has_unconfirmed() const
{
    return fs::exists(state_ / unconfirmed_file);
}

void ClassFolder::begin_unconfirmed(const std::map<std::string, std::string>& fingerprints) const
{
    std::set<std::pair<std::string, std::string>> all = unconfirmed(state_ / unconfirmed_file);
    all.insert(fingerprints.begin(), fingerprints.end());
    write_whole(state_ / unconfirmed_file,
                Json(all).dump(0, ' ', false, Json::error_handler_t::replace) + "\n");
}

void ClassFolder::confirm() const
{
    fs::remove(state_ / unconfirmed_file);
}

void ClassFolder::drop_unconfirmed() const
{
    for (const auto& [submission, fingerprint] : unconfirmed(state_ / unconfirmed_file)) {
        const std::optional<Row> row = row_of(submission);
        std::error_code error;
        if (row && row->fingerprint == fingerprint) fs::remove(result_of(submission), error);
    }
}

} // namespace rigor
