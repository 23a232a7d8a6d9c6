// SPDX-License-Identifier: MIT
#include "grading/intake/folder.hpp"

#include "grading/intake/refused.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
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
