// SPDX-License-Identifier: MIT
#include "book/book.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>

using namespace rigor;

TEST_CASE("book: the handouts make a page that needs no other file", "[book]")
{
    const std::string page = book::book(std::filesystem::path(RIGOR_SOURCE_DIR) / "assignments");
    CHECK(page.find("src=\"data:image/svg+xml;base64,") != std::string::npos);
    CHECK(page.find("src=\"data:image/png;base64,") != std::string::npos);
    CHECK(page.find("http://") == std::string::npos);
    CHECK(page.find("https://") == std::string::npos);
    for (const char* left : {"<p>![", "```", "$$", "<script"}) {
        CAPTURE(left);
        CHECK(page.find(left) == std::string::npos);
    }
}

TEST_CASE("book: each entry of the contents leads to a chapter", "[book]")
{
    const std::string page = book::book(std::filesystem::path(RIGOR_SOURCE_DIR) / "assignments");
    int chapters = 0;
    for (;; ++chapters) {
        const std::string name = "chapter-" + std::to_string(chapters);
        if (page.find("<section id=\"" + name + "\">") == std::string::npos) break;
        CHECK(page.find("<a href=\"#" + name + "\">") != std::string::npos);
    }
    CHECK(chapters == 12); // A0 to A8, symbols, coverage, scenes
    CHECK(page.find("<a href=\"#chapter-" + std::to_string(chapters)) == std::string::npos);
    CHECK(page.find("Find the bug") < page.find("<section")); // the contents list sections too
}

TEST_CASE("book: on paper each answer can be read", "[book]")
{
    const std::string page = book::book(std::filesystem::path(RIGOR_SOURCE_DIR) / "assignments");
    CHECK(page.find("<details>") != std::string::npos);
    const std::string paper = book::unfolded(page);
    CHECK(paper.find("<details>") == std::string::npos);
    CHECK(paper.find("<details open>") != std::string::npos);
}

TEST_CASE("book: a folder without handouts is an error", "[book]")
{
    const testing::TemporaryFolder folder;
    REQUIRE_THROWS_AS(book::book(folder.path()), InputError);
}
