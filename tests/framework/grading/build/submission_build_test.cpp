// SPDX-License-Identifier: MIT
#include "grading/build/submission_build.hpp"

#include "framework/grading/memory_disk.hpp"
#include "grading/build/compiled_folder.hpp"
#include "grading/places.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace rigor::testing::submission_build_test {

namespace fs = std::filesystem;

namespace {

// A file for which compiler and linker write a table of 10 MB. So do the tools that keep its inline
// function apart from those of other files and hide the table.
constexpr const char* large_file = "inline int twice(int x) { return 2 * x; }\n"
                                   "int (*pointer)(int) = &twice;\nint table[2500000] = {1};\n";

enum class Built { whole, not_at_all, blamed };

Built built(const fs::path& folder)
{
    try {
        return build_submission(folder, {}).broken.empty() ? Built::whole : Built::blamed;
    } catch (const std::runtime_error&) {
        return Built::not_at_all;
    }
}

} // namespace

TEST_CASE("submission build: objects of student/ are linked as they were when they were lent",
          "[build]")
{
    const fs::path place = CompiledFolder::place_of(places().source / "student");
    const TemporaryFolder folder;
    folder.write("inertia.cpp", "");
    // As soon as pipeline.cpp of student/ is compiled for the submission, another rigor waits until
    // it may remove the object. If some other test compiles the file before, there is another try.
    std::jthread other;
    const auto start_other = [&](int, int, const std::string& step) {
        if (step != "Building pipeline.cpp" || other.joinable()) return;
        other = std::jthread([&] {
            const BuildLock lock(place);
            fs::remove(place / "pipeline.o");
        });
    };
    SubmissionBuild build;
    for (int i = 0; i < 10 && !other.joinable(); ++i) {
        prepare_submission_builds({});
        fs::remove(place / "pipeline.o");
        remove_submission_build(folder.path());
        build = build_submission(folder.path(), start_other);
    }
    REQUIRE(other.joinable());
    other.join();
    CHECK(build.broken.empty());
    CHECK(fs::exists(build.worker));
    remove_submission_build(folder.path());
}

TEST_CASE("submission build: a right file is not blamed for a full disk", "[build]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", large_file);
    prepare_submission_builds({});
    std::vector<std::string> disks;
    for (int size = 1; size < 80; size += 6) // [MB]
        disks.push_back("size=" + std::to_string(size) + "m");
    for (int files = 3; files < 30; files += 3)
        disks.push_back("nr_inodes=" + std::to_string(files));
    std::map<Built, int> count;
    for (const std::string& options : disks) {
        const MemoryDisk disk(CompiledFolder::place_of(folder.path()), options);
        if (!disk.is_mounted()) {
            WARN("left out: this user cannot mount a small disk");
            return;
        }
        CAPTURE(options);
        const Built how = built(folder.path());
        CHECK(how != Built::blamed);
        ++count[how];
    }
    CHECK(count[Built::whole] > 1);
    CHECK(count[Built::not_at_all] > 1);
    remove_submission_build(folder.path());
}

TEST_CASE("submission build: a right file is not blamed for a disk that is full when it is linked",
          "[build]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", large_file);
    prepare_submission_builds({});
    const Toolchain tools = student_toolchain();
    for (int size = 16; size < 56; size += 6) { // [MB]
        const MemoryDisk disk(CompiledFolder::place_of(folder.path()), "size=100m");
        if (!disk.is_mounted()) {
            WARN("left out: this user cannot mount a small disk");
            return;
        }
        CAPTURE(size);
        std::vector<std::string> steps;
        CompiledFolder(folder.path(), tools).compile({"inertia"}, {}, steps);
        bool is_small = false; // the kernel gives the room of removed files back a little later
        for (int tries = 0; !is_small && tries < 1000; ++tries) {
            is_small = disk.remount("size=" + std::to_string(size) + "m");
            std::this_thread::sleep_for(std::chrono::milliseconds(is_small ? 0 : 10));
        }
        REQUIRE(is_small);
        CHECK(built(folder.path()) == Built::not_at_all);
    }
    remove_submission_build(folder.path());
}

TEST_CASE("submission build: what is removed while it is built is no error of the student",
          "[build]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", "");
    // The object is gone before it is linked.
    const auto remove = [&](int, int, const std::string& step) {
        if (step == "Building inertia.cpp") remove_submission_build(folder.path());
    };
    CHECK_THROWS_AS(build_submission(folder.path(), remove), std::runtime_error);
    CHECK(build_submission(folder.path(), {}).broken.empty());
    remove_submission_build(folder.path());
    CHECK(!fs::exists(CompiledFolder::place_of(folder.path())));
}

} // namespace rigor::testing::submission_build_test
