// SPDX-License-Identifier: MIT
#include "grading/build/toolchain.hpp"

#include "grading/build/compiled_folder.hpp"
#include "grading/build/shown_errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <atomic>
#include <thread>

namespace rigor::testing::toolchain_test {

TEST_CASE("toolchain: a link reads its inputs by their paths and no folder of the tree", "[build]")
{
    const Toolchain tools = student_toolchain();
    std::size_t inputs = 0;
    for (const std::string& word : tools.link) {
        CAPTURE(word);
        CHECK((&word == tools.link.data() || word[0] == '-' || word[0] == '/'));
        inputs += word.ends_with(".o") || word.ends_with(".a") ? 1 : 0;
    }
    CHECK(inputs >= 1);
    CHECK(inputs == tools.linked_inputs.size());
}

TEST_CASE("toolchain: a tool that the system kills is no fault of a submission, one out of time is",
          "[build]")
{
    const TemporaryFolder folder;
    const std::filesystem::path out = folder.path() / "out";
    std::filesystem::create_directories(out);
    const auto runs = [&](const std::string& script, double time) {
        return run_tool({{"/bin/sh", "-c", script}, out, {}, out, largest_output, time});
    };
    CHECK_THROWS_WITH(runs("kill -9 $$", 5),
                      Catch::Matchers::StartsWith("/bin/sh was ended by the system"));
    const ConfinedRun endless = runs("while :; do :; done", 1);
    CHECK(limit_met(endless, 1) == ToolLimit::time);
    // only a submission that forges the message of a compiler
    const ConfinedRun forged = runs("echo Killed signal terminated program cc1plus; exit 1", 5);
    CHECK(forged.status == 1);
}

TEST_CASE("toolchain: a submission whose compiler is killed by the system is not blamed", "[build]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", "int a;\n");
    Toolchain tools = student_toolchain();
    tools.compile = {"/bin/sh", "-c", "kill -9 $$"};
    std::vector<std::string> steps;
    CHECK_THROWS_AS(CompiledFolder(folder.path(), tools).compile({"inertia"}, {}, steps),
                    std::runtime_error);
    std::filesystem::remove_all(CompiledFolder::place_of(folder.path()));
}

TEST_CASE("toolchain: a file that is taken over is whole at any time", "[build]")
{
    const TemporaryFolder folder;
    const std::string content(std::size_t{1} << 20, 'x');
    const std::filesystem::path place = folder.write("worker", content);
    std::atomic<bool> is_over = false;
    std::atomic<int> looks = 0, incomplete = 0;
    std::thread reader([&] {
        for (; !is_over; ++looks) {
            std::error_code error;
            const std::uintmax_t size = std::filesystem::file_size(place, error);
            incomplete += error || size != content.size() ? 1 : 0;
        }
    });
    for (int i = 0; i < 100; ++i)
        take_over(folder.write("out/worker", content), place);
    is_over = true;
    reader.join();
    CHECK(looks > 0);
    CHECK(incomplete == 0);
}

TEST_CASE("toolchain: names are hidden only if the whole list of them can be written", "[build]")
{
    const TemporaryFolder folder;
    const std::filesystem::path copy = folder.path() / "copy.o";
    std::filesystem::create_symlink("/dev/full", copy.string() + ".names");
    CHECK_THROWS_WITH(make_local(folder.write("object.o", ""), {"helper"}, copy),
                      copy.string() + ".names: cannot be written");
}

} // namespace rigor::testing::toolchain_test
