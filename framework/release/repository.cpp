// SPDX-License-Identifier: MIT
#include "release/repository.hpp"

#include "errors/input_error.hpp"
#include "grading/process.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <vector>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// A file in .git that says who made the repository.
constexpr const char* our_mark = "rigor-release";

// Environment variables for git: it uses none of the user's settings, hooks and templates, and a
// fixed author and date.
std::vector<std::string> fixed_surroundings()
{
    const std::string who = "Rigor", mail = "rigor@localhost", when = "2000-01-01T00:00:00 +0000";
    return {"GIT_CONFIG_GLOBAL=/dev/null", "GIT_CONFIG_NOSYSTEM=1",
            "GIT_AUTHOR_NAME=" + who,      "GIT_COMMITTER_NAME=" + who,
            "GIT_AUTHOR_EMAIL=" + mail,    "GIT_COMMITTER_EMAIL=" + mail,
            "GIT_AUTHOR_DATE=" + when,     "GIT_COMMITTER_DATE=" + when,
            "GIT_TEMPLATE_DIR=",           "GIT_CONFIG_COUNT=0",
            "GIT_TERMINAL_PROMPT=0",       "LC_ALL=C"};
}

struct GitPlaces {
    fs::path repository, work, index;
};

// Runs git. @return what it printed
std::string git(const GitPlaces& at, const std::vector<std::string>& arguments)
{
    require_git();
    Command command;
    command.arguments = {"git",
                         "-c",
                         "core.autocrlf=false",
                         "-c",
                         "core.fileMode=true",
                         "-c",
                         "safe.directory=*",
                         "-c",
                         "advice.detachedHead=false"};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    command.environment = fixed_surroundings();
    command.environment.push_back("GIT_DIR=" + at.repository.string());
    command.environment.push_back("GIT_WORK_TREE=" + at.work.string());
    command.environment.push_back("GIT_INDEX_FILE=" + at.index.string());
    command.folder = at.work;
    std::string text;
    const Ended ended = run(command, [&](std::string_view line) {
        text += (text.empty() ? "" : "\n") + std::string(line);
    });
    if (ended.ok()) return text;
    throw InputError(fmt::format("git {} failed in {}: {}", arguments.front(), at.work.string(),
                                 text.substr(text.rfind('\n') + 1)));
}

GitPlaces places_in(const fs::path& folder)
{
    return {folder / ".git", folder, folder / ".git/index"};
}

// Whether a folder is a repository that `write_repository` made, and in which nobody has changed a
// file or added a commit.
bool is_untouched_release(const fs::path& folder)
{
    if (!fs::exists(folder / ".git" / our_mark)) return false;
    const GitPlaces at = places_in(folder);
    return git(at, {"status", "--porcelain", "--ignored"}).empty() &&
           git(at, {"rev-list", "--all", "--count"}) == "1";
}

} // namespace

std::string write_repository(const ReleasedTree& tree, const fs::path& folder)
{
    write_tree(tree, folder);
    const GitPlaces at = places_in(folder);
    git(at, {"init", "--quiet", "--initial-branch=main"});
    git(at, {"config", "core.logAllRefUpdates", "false"});
    // --force: the .gitignore of this tree must not leave files out.
    git(at, {"add", "--all", "--force", "."});
    git(at, {"commit", "--quiet", "--no-verify", "--no-gpg-sign", "-m", "rigor: the assignments"});
    // The index is made again without the files' time stamps, which would differ from run to run.
    fs::remove(at.index);
    git(at, {"read-tree", "HEAD"});
    fs::remove(folder / ".git/COMMIT_EDITMSG");
    write_tree({{our_mark, "made by ./rigor release\n", false}}, folder / ".git/mark");
    fs::rename(folder / ".git/mark" / our_mark, folder / ".git" / our_mark);
    fs::remove(folder / ".git/mark");
    return git(at, {"rev-parse", "HEAD"});
}

void write_commit(const fs::path& repository, const fs::path& work)
{
    fs::create_directories(work);
    const GitPlaces at = {repository / ".git", fs::canonical(work),
                          fs::canonical(work).string() + ".index"};
    git(at, {"read-tree", "--reset", "-u", "HEAD"});
    git(at, {"clean", "--quiet", "-ffdx", "-e", "/build"});
}

DraftFolder::DraftFolder(const fs::path& place) : place_(fs::absolute(place).lexically_normal())
{
    if (!place_.has_filename()) place_ = place_.parent_path();
    std::error_code error;
    const bool exists = fs::exists(fs::symlink_status(place_, error));
    if (exists && !fs::is_directory(place_))
        throw InputError("expected a folder, found " + place.string() + ", which is none");
    if (exists && !fs::is_empty(place_, error) && !is_untouched_release(place_))
        throw InputError("expected a new or empty folder, or an earlier release that nobody has "
                         "changed, found " +
                         place.string());
    fs::create_directories(place_.parent_path(), error);
    draft_ = place_.parent_path() / fmt::format(".{}.{}.new", place_.filename().string(), getpid());
    fs::remove_all(draft_, error);
    if (!fs::create_directory(draft_, error))
        throw InputError(fmt::format("{}: cannot be written: {}", place_.parent_path().string(),
                                     error.message()));
}

DraftFolder::~DraftFolder()
{
    std::error_code error;
    fs::remove_all(draft_, error);
}

void DraftFolder::publish()
{
    const fs::path old = draft_.string() + ".old";
    std::error_code error;
    if (fs::exists(place_)) fs::rename(place_, old, error);
    if (!error) fs::rename(draft_, place_, error);
    if (error) {
        std::error_code ignored;
        if (fs::exists(old)) fs::rename(old, place_, ignored);
        throw InputError(place_.string() + ": cannot be written: " + error.message());
    }
    fs::remove_all(old, error);
}

} // namespace rigor
