// SPDX-License-Identifier: MIT
#include "book/markdown.hpp"

#include "support/catch.hpp"

namespace {

std::string shown(const std::string& markdown)
{
    return rigor::book::html(markdown, [](const std::string& path, const std::string&) {
        return "<img src=\"" + path + "\"/>";
    });
}

} // namespace

TEST_CASE("book: blocks of a text", "[book]")
{
    CHECK(shown("# A title\n\nSome\nwords.\n") == "<h1>A title</h1>\n<p>Some\nwords.</p>\n");
    CHECK(shown("- one\n  more\n- two\n") == "<ul>\n<li>one\nmore</li>\n<li>two</li>\n</ul>\n");
    CHECK(shown("1. one\n2. two\n") == "<ol>\n<li>one</li>\n<li>two</li>\n</ol>\n");
    CHECK(shown("It is never\n0. Or is it?\n") == "<p>It is never\n0. Or is it?</p>\n");
    CHECK(shown("Two:\n1. one\n2. two\n") ==
          "<p>Two:</p>\n<ol>\n<li>one</li>\n<li>two</li>\n</ol>\n");
    CHECK(shown("> - one\n> - two\n>\n> So.\n") ==
          "<blockquote>\n<ul>\n<li>one</li>\n<li>two</li>\n</ul>\n<p>So.</p>\n</blockquote>\n");
    CHECK(shown("> **Note.** A word.\n") ==
          "<blockquote>\n<p><strong>Note.</strong> A word.</p>\n</blockquote>\n");
    CHECK(shown("    a < b\n") == "<pre>a &lt; b\n</pre>\n");
    CHECK(shown("| a | b |\n|---|---|\n| 1 | 2 |\n") ==
          "<table>\n<tr><th> a </th><th> b </th></tr>\n<tr><td> 1 </td><td> 2 </td></tr>\n"
          "</table>\n");
}

TEST_CASE("book: a fold stays a fold, and its text is read", "[book]")
{
    CHECK(shown("<details>\n<summary>Is 1 < 2\nso?</summary>\n\nIt *is*.\n</details>\n") ==
          "<details>\n<summary>Is 1 &lt; 2\nso?</summary>\n<p>It <em>is</em>.</p>\n</details>\n");
}

TEST_CASE("book: code and formulas are not read as words", "[book]")
{
    CHECK(shown("`a*b*c` and *so*") == "<p><code>a*b*c</code> and <em>so</em></p>\n");
    CHECK(shown("$a_b$ is **it**") ==
          "<p><math><mrow><msub><mi>a</mi><mi>b</mi></msub></mrow></math> is "
          "<strong>it</strong></p>\n");
    CHECK(shown("```math\nx\n```\n") == "<math display=\"block\"><mrow><mi>x</mi></mrow></math>\n");
    CHECK(shown("```\n$x$\n```\n") == "<pre>$x$\n</pre>\n");
}

TEST_CASE("book: a picture has its description below it", "[book]")
{
    CHECK(shown("![A box (wide)](figures/box.svg)\n") ==
          "<figure><img src=\"figures/box.svg\"/><figcaption>A box (wide)</figcaption></figure>\n");
}
