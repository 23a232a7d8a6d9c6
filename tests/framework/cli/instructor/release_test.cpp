// SPDX-License-Identifier: MIT
// `rigor release` with wrong input, and in the long tests the whole command.
#include "framework/cli/command.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

namespace rigor::testing::release_test {

namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

int entries_in(const fs::path& folder)
{
    int entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder))
        ++entries;
    return entries;
}

std::string content_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("release: bad input is one line and nothing is written", "[cli][release]")
{
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "text").string(),
                      full = folder.write("full/text", "text").parent_path().string(),
                      out = (folder.path() / "out").string();
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
        {{"release"}, "expected --out DIR, --gradescope FILE or --classroom DIR"},
        {{"release", "--out", file}, "expected a folder"},
        {{"release", "--out", full}, "expected a new or empty folder"},
        {{"release", "--out", file + "/out"}, "cannot be written"},
        {{"release", "--classroom", out}, "expected an assignment"},
        {{"release", "A2.1", "--classroom", out}, "a part of one"},
        {{"release", "a99", "--out", out}, "a99"},
        {{"release", "a0", "--gradescope", full}, "expected a file, found the folder"},
        {{"release", "a0", "--gradescope", out + "/a0.zip"}, "cannot be written"}};
    for (const auto& [arguments, message] : wrong) {
        const Run run = rigor(arguments);
        CAPTURE(run.output);
        CHECK(run.status == 2);
        CHECK(contains(run.output, message));
        CHECK(run.output.find('\n') == run.output.size() - 1);
        CHECK(entries_in(folder.path()) == 2);
        CHECK(entries_in(full) == 1);
    }
}

// The first run of this test takes as long as building two trees.
TEST_CASE("release: what is handed out is proven, and the same again", "[.long][release]")
{
    const TemporaryFolder folder;
    const fs::path first = folder.path() / "first", again = folder.path() / "again",
                   zip = folder.path() / "a0.zip";
    const Run released = rigor({"release", "--out", first.string()});
    CAPTURE(released.output);
    REQUIRE(released.status == 0);
    CHECK(contains(released.output, "none implemented, 0 of "));
    const Run second =
        rigor({"release", "a0", "--out", again.string(), "--gradescope", zip.string()});
    CAPTURE(second.output);
    REQUIRE(second.status == 0);
    CHECK(content_of(first / ".git/refs/heads/main") == content_of(again / ".git/refs/heads/main"));
    CHECK(fs::file_size(zip) > 100000);
    // No program that students build has the name of a hidden test in it.
    const std::string program =
        content_of(fs::path(RIGOR_BINARY_DIR) / "release/students/build/release/bin/graded_tests");
    CHECK(contains(program, "collision: a ball that bounces perfectly gains no energy"));
    CHECK(!contains(program, "is the reference's step"));
}

} // namespace rigor::testing::release_test
