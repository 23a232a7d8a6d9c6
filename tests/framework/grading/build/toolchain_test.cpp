// SPDX-License-Identifier: MIT
#include "grading/build/toolchain.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <atomic>
#include <thread>
#include <unistd.h>

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

TEST_CASE("toolchain: all tools that run at a time find room in the machine's memory", "[build]")
{
    const double all = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<double>(sysconf(_SC_PAGESIZE)),
                 processors = static_cast<double>(sysconf(_SC_NPROCESSORS_ONLN));
    constexpr double least = 1 << 30; // what a compiler needs anyway [bytes]
    CHECK(static_cast<double>(memory_of_a_tool()) * 2 * processors <=
          std::max(all, least * 2 * processors));
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
