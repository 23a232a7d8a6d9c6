// SPDX-License-Identifier: MIT
#include "grading/intake/plain_file.hpp"

#include "grading/intake/refused.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <sys/stat.h>

namespace rigor::testing::plain_file_test {

namespace {

PlainFile read_file(const std::filesystem::path& file, std::size_t most)
{
    return read_plain_file(file.parent_path(), file.filename(), most);
}

std::string refusal_of(const std::filesystem::path& folder, const std::filesystem::path& name)
{
    try {
        read_plain_file(folder, name, 100);
        return "";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

std::string refusal_of(const std::filesystem::path& file)
{
    return refusal_of(file.parent_path(), file.filename());
}

} // namespace

TEST_CASE("plain file: a text up to the limit is read", "[intake]")
{
    const TemporaryFolder folder;
    const auto file = folder.write("a.cpp", "int x;\n");
    REQUIRE(read_file(file, 7).text == "int x;\n");
    REQUIRE(read_file(file, 7).size == 7);
    REQUIRE(read_file(file, 6).text.empty());
    REQUIRE(read_file(file, 6).size == 7);
}

TEST_CASE("plain file: a large one is measured and not read", "[intake]")
{
    const TemporaryFolder folder;
    const auto file = folder.write("a.zip", "");
    std::filesystem::resize_file(file, std::uintmax_t{1} << 36); // takes no space on the disk
    const PlainFile read = read_file(file, 1000);
    REQUIRE(read.size == std::size_t{1} << 36);
    REQUIRE(read.text.empty());
}

TEST_CASE("plain file: a link or a pipe or a device or a folder is refused", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("a.cpp", "");
    std::filesystem::create_symlink("a.cpp", folder.path() / "link");
    std::filesystem::create_symlink("/dev/zero", folder.path() / "zero");
    REQUIRE(mkfifo((folder.path() / "pipe").c_str(), 0600) == 0);
    REQUIRE(refusal_of(folder.path() / "a.cpp").empty());
    REQUIRE(refusal_of(folder.path() / "link") == "expected a file, found a link");
    REQUIRE(refusal_of(folder.path() / "zero") == "expected a file, found a link");
    REQUIRE(refusal_of(folder.path() / "pipe") == "expected a file, found a pipe");
    REQUIRE(refusal_of("/dev/zero") == "expected a file, found a device");
    REQUIRE(refusal_of(folder.path()) == "expected a file, found a folder");
    REQUIRE(refusal_of(folder.path() / "b.cpp").starts_with("cannot be read: "));
}

TEST_CASE("plain file: no folder of the name may be a link", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("a/b/c.hpp", "");
    std::filesystem::create_directory_symlink("b", folder.path() / "a/link");
    std::filesystem::create_directory_symlink("a", folder.path() / "all");
    REQUIRE(refusal_of(folder.path(), "a/b/c.hpp").empty());
    REQUIRE(refusal_of(folder.path(), "a/link/c.hpp") == "cannot be read: Not a directory");
    REQUIRE(refusal_of(folder.path(), "all/b/c.hpp") == "cannot be read: Not a directory");
    REQUIRE(refusal_of(folder.path() / "all", "b/c.hpp").empty()); // the grader's own path
}

} // namespace rigor::testing::plain_file_test
