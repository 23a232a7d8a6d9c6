// SPDX-License-Identifier: MIT
// Puts the pages one after the other: the handouts in the order of their names, then notation.md,
// coverage.md and scenes.md. Drawings and other pictures are copied into the page in base 64.
#include "book/book.hpp"

#include "book/markdown.hpp"
#include "book/mathml.hpp"
#include "errors/input_error.hpp"
#include "errors/markup.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <vector>

namespace rigor::book {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view style = R"(
@page { size: A4; margin: 18mm 16mm; @bottom-center { content: counter(page) } }
body { font: 17px/1.5 serif; max-width: 46em; margin: 2em auto; padding: 0 1em }
h1 { margin-top: 3em; page-break-before: always } h1, h2, h3 { line-height: 1.2 }
figure { margin: 1.5em 0; text-align: center } figure svg, img { max-width: 100%; height: auto }
math { font-family: "STIX Two Math", "STIX Math", "Latin Modern Math", "Cambria Math",
       "DejaVu Math TeX Gyre", math }
figcaption { font-size: 85%; opacity: 0.8 } table { border-collapse: collapse; font-size: 90% }
td, th { border: 1px solid #8c959f; padding: 0.2em 0.6em; text-align: left }
pre { background: #8881; padding: 0.6em; overflow-x: auto; font-size: 85% }
blockquote { border-left: 4px solid #8c959f; margin: 1.5em 0; padding: 0.1em 1em }
summary { cursor: pointer } details { margin: 1em 0; padding-left: 1em }
nav ol { line-height: 1.4 } nav span { font-size: 85%; opacity: 0.8 }
@media (prefers-color-scheme: dark) { body { background: #0d1117; color: #e6edf3 } }
)";

std::string content(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw InputError("expected a file of the handouts, found none: " + file.string());
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string base64(const std::string& bytes)
{
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three =
                three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            result += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63U];
    }
    return result;
}

// A picture as an <img> that contains the bytes of its file. Thus the style sheet of one SVG file
// has no effect on other pictures.
std::string picture(const fs::path& file, const std::string& text)
{
    const std::string kind = file.extension() == ".svg" ? "svg+xml" : "png";
    std::string description;
    for (const char c : escaped_markup(text))
        description += c == '"' ? std::string("&quot;") : std::string(1, c);
    return fmt::format("<img alt=\"{}\" src=\"data:image/{};base64,{}\"/>", description, kind,
                       base64(content(file)));
}

std::vector<fs::path> pages(const fs::path& assignments)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(assignments))
        if (fs::exists(entry.path() / "README.md")) files.push_back(entry.path() / "README.md");
    if (files.empty()) throw InputError("expected handouts, found none in " + assignments.string());
    std::sort(files.begin(), files.end());
    for (const char* name : {"notation.md", "coverage.md", "scenes.md"})
        files.push_back(assignments / name);
    return files;
}

// The headings of a Markdown text whose lines begin with a mark such as "# ", without this mark.
std::vector<std::string> headings(const std::string& text, const std::string& mark)
{
    std::vector<std::string> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(mark)) found.push_back(line.substr(mark.size()));
    return found;
}

std::string chapter_name(std::size_t number)
{
    return fmt::format("chapter-{}", number);
}

// The title, and a list of all chapters and their sections.
std::string title_page(const std::vector<std::string>& chapters)
{
    std::string items;
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        const std::vector<std::string> title = headings(chapters[i], "# ");
        std::string sections;
        for (const std::string& section : headings(chapters[i], "## "))
            sections += (sections.empty() ? "" : " · ") + escaped_markup(section);
        items +=
            fmt::format("<li><a href=\"#{}\">{}</a><br/><span>{}</span></li>\n", chapter_name(i),
                        title.empty() ? "" : escaped_markup(title.front()), sections);
    }
    return fmt::format("<header><h1>Rigor</h1>\n<p>Rigid bodies, plasticity and fracture: the "
                       "handouts of all assignments</p></header>\n<nav><h2>Contents</h2>\n"
                       "<ol>\n{}</ol></nav>\n",
                       items);
}

} // namespace

std::string book(const fs::path& assignments)
{
    std::vector<std::string> chapters;
    std::string body;
    for (const fs::path& file : pages(assignments)) {
        const std::string chapter =
            html(content(file), [&](const std::string& path, const std::string& text) {
                return picture(file.parent_path() / path, text);
            });
        body += fmt::format("<section id=\"{}\">\n{}</section>\n", chapter_name(chapters.size()),
                            chapter);
        chapters.push_back(content(file));
    }
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                       "<title>Rigor</title>\n<style>{}</style>\n</head>\n"
                       "<body>\n{}{}</body>\n</html>\n",
                       style, title_page(chapters), body);
}

std::string unfolded(const std::string& page)
{
    constexpr std::string_view closed = "<details>", open = "<details open>";
    std::string text = page;
    for (std::size_t at = 0; (at = text.find(closed, at)) != std::string::npos; at += open.size())
        text.replace(at, closed.size(), open);
    return text;
}

} // namespace rigor::book
