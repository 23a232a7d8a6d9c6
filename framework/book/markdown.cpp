// SPDX-License-Identifier: MIT
// Reads a text block by block: a block begins with a mark such as #, |, > or -, or is a paragraph.
// Within a block, a mark such as `, $, **, * or [ begins code, a formula, bold or italic words, or
// a link.
#include "book/markdown.hpp"

#include "book/mathml.hpp"
#include "errors/markup.hpp"

#include <cctype>
#include <fmt/format.h>
#include <sstream>
#include <vector>

namespace rigor::book {

namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text)
{
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

// If `mark` stands at `at`, finds the text between it and the next `mark`, and moves `at` behind
// the second mark. @return whether there is such a text
bool between(const std::string& text, std::size_t& at, const std::string& mark, std::string& found)
{
    if (text.compare(at, mark.size(), mark) != 0) return false;
    const std::size_t end = text.find(mark, at + mark.size());
    if (end == std::string::npos || end == at + mark.size()) return false;
    found = text.substr(at + mark.size(), end - at - mark.size());
    at = end + mark.size();
    return true;
}

bool link(const std::string& text, std::size_t& at, std::string& shown, std::string& target)
{
    if (text[at] != '[') return false;
    const std::size_t middle = text.find("](", at), end = text.find(')', middle);
    if (middle == std::string::npos || end == std::string::npos) return false;
    shown = text.substr(at + 1, middle - at - 1);
    target = text.substr(middle + 2, end - middle - 2);
    at = end + 1;
    return true;
}

std::string words(const std::string& text)
{
    std::string result, inner, target;
    for (std::size_t at = 0; at < text.size();) {
        if (between(text, at, "`", inner))
            result += "<code>" + escaped_markup(inner) + "</code>";
        else if (between(text, at, "$", inner))
            result += mathml(inner, false);
        else if (between(text, at, "**", inner))
            result += "<strong>" + words(inner) + "</strong>";
        else if (between(text, at, "*", inner))
            result += "<em>" + words(inner) + "</em>";
        else if (link(text, at, inner, target))
            result += words(inner); // only the text: a link's target is not in the book
        else
            result += escaped_markup(std::string(1, text[at++]));
    }
    return result;
}

bool is_numbered(const std::string& line)
{
    return line.size() > 3 && std::isdigit(static_cast<unsigned char>(line[0])) != 0 &&
           line.compare(1, 2, ". ") == 0;
}

bool is_item(const std::string& line)
{
    return line.starts_with("- ") || is_numbered(line);
}

// Whether a line begins a list, which ends the paragraph before it. A numbered list must begin with
// "1. ". Other numbers do not count: a sentence may end with a number, such as "3. ", and this
// number may begin the next line.
bool begins_list(const std::string& line)
{
    return line.starts_with("- ") || line.starts_with("1. ");
}

bool is_fold(const std::string& line)
{
    return line.starts_with("<details>") || line.starts_with("</details>") ||
           line.starts_with("<summary>");
}

class Page {
public:
    Page(const std::string& markdown, const Picture& picture)
        : lines_(lines_of(markdown)), picture_(picture)
    {
    }

    std::string html()
    {
        std::string result;
        while (at_ < lines_.size())
            result += block();
        return result;
    }

private:
    std::string block()
    {
        const std::string& line = lines_[at_];
        if (line.empty()) {
            ++at_;
            return "";
        }
        if (line.starts_with("```")) return fenced();
        if (line.starts_with("    ")) return indented();
        if (line.front() == '#') return heading();
        if (line.front() == '|') return table();
        if (line.front() == '>') return quote();
        if (line.starts_with("![")) return figure();
        if (is_item(line)) return list();
        if (is_fold(line)) return fold();
        return paragraph();
    }

    // A folded part (<details>) and its <summary> are HTML already in the Markdown text.
    std::string fold()
    {
        constexpr std::string_view open = "<summary>", close = "</summary>";
        std::string content = lines_[at_++];
        if (!content.starts_with(open)) return content + "\n";
        while (at_ < lines_.size() && !lines_[at_].empty() && !content.ends_with(close))
            content += "\n" + lines_[at_++];
        if (content.ends_with(close)) content.resize(content.size() - close.size());
        return fmt::format("{}{}{}\n", open, words(content.substr(open.size())), close);
    }

    std::string fenced()
    {
        const bool is_math = lines_[at_++] == "```math";
        std::string content;
        while (at_ < lines_.size() && !lines_[at_].starts_with("```"))
            content += lines_[at_++] + "\n";
        ++at_;
        return is_math ? mathml(content, true) + "\n"
                       : "<pre>" + escaped_markup(content) + "</pre>\n";
    }

    std::string indented()
    {
        std::string content;
        while (at_ < lines_.size() && lines_[at_].starts_with("    "))
            content += lines_[at_++].substr(4) + "\n";
        return "<pre>" + escaped_markup(content) + "</pre>\n";
    }

    std::string heading()
    {
        const std::string& line = lines_[at_++];
        const std::size_t level = line.find_first_not_of('#');
        return fmt::format("<h{0}>{1}</h{0}>\n", level, words(line.substr(level + 1)));
    }

    std::string table()
    {
        std::string rows;
        std::string_view cell_name = "th";
        for (; at_ < lines_.size() && lines_[at_].starts_with("|"); ++at_) {
            if (lines_[at_].find_first_not_of("|-: ") == std::string::npos) {
                cell_name = "td";
                continue;
            }
            std::string cells;
            std::istringstream row(lines_[at_].substr(1));
            for (std::string cell; std::getline(row, cell, '|');)
                cells += fmt::format("<{0}>{1}</{0}>", cell_name, words(cell));
            rows += "<tr>" + cells + "</tr>\n";
        }
        return "<table>\n" + rows + "</table>\n";
    }

    std::string quote()
    {
        std::string content;
        for (; at_ < lines_.size() && lines_[at_].starts_with(">"); ++at_)
            content += lines_[at_].substr(lines_[at_].starts_with("> ") ? 2 : 1) + "\n";
        return "<blockquote>\n" + Page(content, picture_).html() + "</blockquote>\n";
    }

    std::string figure()
    {
        std::size_t start = 1;
        std::string text, path;
        const std::string line = lines_[at_++];
        if (!link(line, start, text, path)) return "<p>" + words(line) + "</p>\n";
        return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture_(path, text),
                           words(text));
    }

    std::string list()
    {
        const std::string_view name = is_numbered(lines_[at_]) ? "ol" : "ul";
        std::string items;
        while (at_ < lines_.size() && is_item(lines_[at_])) {
            const std::size_t indent = lines_[at_].find(' ') + 1;
            std::string item = lines_[at_++].substr(indent);
            while (at_ < lines_.size() && lines_[at_].starts_with(std::string(indent, ' ')))
                item += "\n" + lines_[at_++].substr(indent);
            items += "<li>" + words(item) + "</li>\n";
        }
        return fmt::format("<{0}>\n{1}</{0}>\n", name, items);
    }

    std::string paragraph()
    {
        std::string content = lines_[at_++];
        while (at_ < lines_.size() && !lines_[at_].empty() && !lines_[at_].starts_with("```") &&
               !begins_list(lines_[at_]) && !is_fold(lines_[at_]) && lines_[at_].front() != '|')
            content += "\n" + lines_[at_++];
        return "<p>" + words(content) + "</p>\n";
    }

    const Lines lines_;
    const Picture& picture_;
    std::size_t at_ = 0;
};

} // namespace

std::string html(const std::string& markdown, const Picture& picture)
{
    return Page(markdown, picture).html();
}

} // namespace rigor::book
