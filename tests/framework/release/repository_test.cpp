// SPDX-License-Identifier: MIT
#include "release/repository.hpp"

#include "errors/input_error.hpp"
#include "grading/process.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <map>
#include <thread>

namespace rigor::testing {

namespace {

namespace fs = std::filesystem;

const ReleasedTree small_tree = {{".gitignore", "/build/\n*.log\n", false},
                                 {"a/ignored.log", "an ignored file belongs to it too\n", false},
                                 {"a/text.md", "words\n", false},
                                 {"rigor", "#!/bin/sh\n", true}};

std::map<std::string, std::string> bytes_of(const fs::path& folder)
{
    std::map<std::string, std::string> bytes;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream in(entry.path(), std::ios::binary);
        bytes[entry.path().lexically_relative(folder).string()] = {
            std::istreambuf_iterator<char>(in), {}};
    }
    return bytes;
}

std::string git(const fs::path& folder, std::vector<std::string> arguments)
{
    Command command;
    command.arguments = {"git", "-c", "safe.directory=*", "-C", folder.string()};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    std::string text;
    const Ended ended = run(command, [&](std::string_view line) { text.append(line) += '\n'; });
    CAPTURE(text);
    REQUIRE(ended.ok());
    return text;
}

// The message of the error; empty if there is none.
std::string error_of(const fs::path& place)
{
    try {
        const DraftFolder folder(place);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("release: the same files give the same repository byte for byte", "[release]")
{
    const TemporaryFolder folders;
    const std::string first = write_repository(small_tree, folders.path() / "first");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // a second later
    const std::string second = write_repository(small_tree, folders.path() / "second");
    CHECK(first == second);
    const auto a = bytes_of(folders.path() / "first"), b = bytes_of(folders.path() / "second");
    REQUIRE(a.size() > small_tree.size());
    for (const auto& [path, bytes] : a) {
        CAPTURE(path);
        REQUIRE(b.count(path) == 1);
        CHECK((bytes == b.at(path)));
    }
    CHECK(a.size() == b.size());
}

TEST_CASE("release: the repository has one commit and nothing but the files", "[release]")
{
    const TemporaryFolder folders;
    const fs::path folder = folders.path() / "tree";
    write_repository(small_tree, folder);
    CHECK(git(folder, {"rev-list", "--all", "--count"}) == "1\n");
    CHECK(git(folder, {"log", "--format=%an %ae %ad", "--date=short"}) ==
          "Rigor rigor@localhost 2000-01-01\n");
    CHECK(git(folder, {"status", "--porcelain", "--ignored"}).empty());
    CHECK(git(folder, {"ls-tree", "-r", "--name-only", "HEAD"}) ==
          ".gitignore\na/ignored.log\na/text.md\nrigor\n");
    CHECK(git(folder, {"fsck", "--unreachable", "--no-reflogs", "--no-progress"}).empty());
    // four files, two folders, the commit
    CHECK(git(folder, {"count-objects"}).starts_with("7 objects"));
    CHECK((fs::status(folder / "rigor").permissions() & fs::perms::owner_exec) != fs::perms::none);
}

TEST_CASE("release: a tree that is checked out again keeps its time stamps and its build",
          "[release]")
{
    const TemporaryFolder folders;
    const fs::path first = folders.path() / "first", second = folders.path() / "second",
                   work = folders.path() / "work";
    write_repository(small_tree, first);
    write_commit(first, work);
    std::ofstream(work / "left_over.cpp") << "int x;\n";
    fs::create_directories(work / "build");
    std::ofstream(work / "build/object.o") << "object\n";
    const auto before = fs::last_write_time(work / "a/text.md");

    ReleasedTree changed = small_tree;
    changed[3].content = "#!/bin/bash\n";
    changed.erase(changed.begin() + 1);
    write_repository(changed, second);
    write_commit(second, work);
    CHECK(fs::last_write_time(work / "a/text.md") == before);
    CHECK(bytes_of(work).at("rigor") == "#!/bin/bash\n");
    CHECK(!fs::exists(work / "a/ignored.log"));
    CHECK(!fs::exists(work / "left_over.cpp"));
    CHECK(fs::exists(work / "build/object.o"));
}

TEST_CASE("release: a missing git is said", "[release]")
{
    const TemporaryFolder folders;
    const std::string path = std::getenv("PATH");
    setenv("PATH", folders.path().c_str(), 1);
    std::string message;
    try {
        write_repository(small_tree, folders.path() / "tree");
    } catch (const InputError& error) {
        message = error.what();
    }
    setenv("PATH", path.c_str(), 1);
    CHECK(message == "git is not installed: apt-get install git");
}

TEST_CASE("release: a folder is replaced only if it is an earlier release", "[release]")
{
    const TemporaryFolder folders;
    const fs::path place = folders.path() / "out";
    CHECK(error_of(place).empty());
    CHECK(!fs::exists(place)); // a draft that is not published leaves nothing
    {
        DraftFolder folder(place);
        write_repository(small_tree, folder.draft());
        folder.publish();
    }
    CHECK(fs::exists(place / "rigor"));
    CHECK(error_of(place).empty());
    std::ofstream(place / "a/text.md") << "more words\n";
    CHECK(error_of(place).find("expected a new or empty folder, or an earlier release") == 0);
    CHECK(error_of(folders.path()).find("expected a new or empty folder") == 0);
    CHECK(error_of(folders.write("file", "")).find("expected a folder") == 0);
    int entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folders.path()))
        ++entries;
    CHECK(entries == 2); // no draft is left
}

} // namespace rigor::testing
