// SPDX-License-Identifier: MIT
#include "grading/machine/disk_room.hpp"

#include "framework/grading/memory_disk.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace rigor::testing::disk_room_test {

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::EndsWith;

constexpr std::uint64_t megabyte = std::uint64_t{1} << 20;

} // namespace

TEST_CASE("disk room: where there is some, nothing is left of the file", "[build]")
{
    const TemporaryFolder folder;
    CHECK_NOTHROW(require_room(folder.path(), megabyte));
    CHECK(fs::is_empty(folder.path()));
    CHECK_THROWS(require_room(folder.path() / "nowhere", megabyte));
}

TEST_CASE("disk room: a disk without space or without inodes has none", "[build]")
{
    const TemporaryFolder folder;
    for (const char* options : {"size=1m", "nr_inodes=1"}) {
        const MemoryDisk disk(folder.path() / "disk", options);
        if (!disk.is_mounted()) {
            WARN("left out: this user cannot mount a small disk");
            return;
        }
        CAPTURE(options);
        CHECK_THROWS_WITH(require_room(folder.path() / "disk", 2 * megabyte),
                          EndsWith("No space left on device"));
        CHECK(fs::is_empty(folder.path() / "disk"));
    }
}

TEST_CASE("disk room: a limit on the size of files leaves none", "[build]")
{
    const TemporaryFolder folder;
    rlimit before = {};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    const rlimit low = {megabyte, before.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &low) == 0);
    CHECK_THROWS_WITH(require_room(folder.path(), 2 * megabyte), EndsWith("File too large"));
    REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
}

TEST_CASE("disk room: the owner of the folder makes the file, also for root", "[build]")
{
    if (geteuid() != 0) return; // nobody else can become the owner
    const TemporaryFolder folder;
    const fs::path out = folder.path() / "out";
    fs::create_directories(out);
    REQUIRE(chown(out.c_str(), 60000, 60000) == 0);
    CHECK_NOTHROW(require_room(out, megabyte));
    fs::permissions(out, fs::perms::owner_read | fs::perms::owner_exec);
    CHECK_THROWS_WITH(require_room(out, megabyte), EndsWith("Permission denied"));
}

} // namespace rigor::testing::disk_room_test
