// SPDX-License-Identifier: MIT
#include "grading/intake/folder.hpp"

#include "grading/intake/refused.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <atomic>
#include <cstdio>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

namespace rigor::testing::folder_test {

namespace {

std::string refusal_of(const std::filesystem::path& folder, const IntakeLimits& limits = {})
{
    try {
        read_folder(folder, limits);
        return "";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

} // namespace

TEST_CASE("folder: a link is neither followed nor taken", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("collision.cpp", "int x;\n");
    REQUIRE(refusal_of(folder.path()).empty());
    std::filesystem::create_symlink("/etc", folder.path() / "etc");
    REQUIRE(refusal_of(folder.path()) == "expected files and folders, found a link, \"etc\"");
}

TEST_CASE("folder: a link that took the place of the whole folder is not followed", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("hidden/collision.cpp", "int x;\n");
    std::filesystem::create_directory_symlink("hidden", folder.path() / "alice");
    REQUIRE(refusal_of(folder.path() / "hidden").empty());
    REQUIRE(refusal_of(folder.path() / "alice") == "\".\" cannot be read: Not a directory");
}

TEST_CASE("folder: a folder that turns into a link again and again is never left", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("hidden/secret.hpp", "secret\n");
    folder.write("alice/own/secret.hpp", "own\n");
    const std::filesystem::path own = folder.path() / "alice/own", link = folder.path() / "link";
    std::filesystem::create_directory_symlink("../hidden", link);
    std::atomic<bool> done = false;
    std::thread student([&] {
        while (!done) // the folder and the link change places
            renameat2(AT_FDCWD, own.c_str(), AT_FDCWD, link.c_str(), RENAME_EXCHANGE);
    });
    int taken = 0, refused = 0;
    std::string read;
    for (int i = 0; i < 2000; ++i) {
        try {
            const Contents contents = read_folder(folder.path() / "alice");
            for (const auto& [name, text] : contents.sources())
                read += text == "own\n" ? "" : text;
            ++taken;
        } catch (const Refused&) {
            ++refused;
        }
    }
    done = true;
    student.join();
    REQUIRE(read.empty());
    REQUIRE(taken > 0);
    REQUIRE(refused > 0);
}

TEST_CASE("folder: a pipe is refused without waiting for a writer", "[intake]")
{
    const TemporaryFolder folder;
    REQUIRE(mkfifo((folder.path() / "collision.cpp").c_str(), 0600) == 0);
    REQUIRE(refusal_of(folder.path()) ==
            "expected files and folders, found a pipe, \"collision.cpp\"");
}

TEST_CASE("folder: a socket is refused", "[intake]")
{
    const TemporaryFolder folder;
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    (folder.path() / "s").string().copy(address.sun_path, sizeof address.sun_path - 1);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    REQUIRE(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    REQUIRE(refusal_of(folder.path()) == "expected files and folders, found a socket, \"s\"");
    close(socket);
}

TEST_CASE("folder: names that cannot be shown are refused", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("a\x1b[31m.cpp", "");
    REQUIRE(refusal_of(folder.path()).find("\"a\\x1b[31m.cpp\"") != std::string::npos);
}

TEST_CASE("folder: limits on files and bytes", "[intake]")
{
    const TemporaryFolder folder;
    for (int i = 0; i < 4; ++i)
        folder.write(std::to_string(i) + ".cpp", std::string(1000, 'x'));
    IntakeLimits limits;
    limits.entries = 3;
    REQUIRE(refusal_of(folder.path(), limits) == "expected at most 3 files, found more");
    limits = {};
    limits.source_bytes = 3500;
    REQUIRE(refusal_of(folder.path(), limits).find("sources") != std::string::npos);
    limits.source_bytes = 4000;
    REQUIRE(refusal_of(folder.path(), limits).empty());
}

} // namespace rigor::testing::folder_test
