// SPDX-License-Identifier: MIT
// Finds the comments of C++ files. A scanner goes through each line and skips strings and character
// literals. It remembers a raw string that goes on in the next line.
#include "layout/comments.hpp"

#include <algorithm>
#include <cctype>

namespace rigor::layout {

namespace {

constexpr auto npos = std::string::npos;

bool is_word(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Reads lines one after the other, since a raw string may continue in the next line.
class Reader {
public:
    /// The place where the comment of the next line begins, or npos.
    std::size_t comment_start(const std::string& line)
    {
        std::size_t i = 0;
        while (i < line.size()) {
            if (!raw_end_.empty()) {
                const std::size_t end = line.find(raw_end_, i);
                if (end == npos) return npos;
                i = end + raw_end_.size();
                raw_end_.clear();
            } else if (line.compare(i, 2, "//") == 0) {
                return i;
            } else {
                i = after_token(line, i);
            }
        }
        return npos;
    }

private:
    // The place after a string, a character literal, or any single letter of code.
    std::size_t after_token(const std::string& line, std::size_t i)
    {
        const bool follows_word = i > 0 && is_word(line[i - 1]);
        if (line.compare(i, 2, "R\"") == 0 && !follows_word) {
            const std::size_t open = line.find('(', i);
            if (open == npos) return line.size();
            raw_end_ = ")" + line.substr(i + 2, open - i - 2) + "\"";
            return open + 1;
        }
        if (line[i] == '"') return after_quote(line, i);
        // A quote inside a number, such as 1'000, begins no character literal.
        if (line[i] == '\'' && !follows_word) return after_quote(line, i);
        return i + 1;
    }

    static std::size_t after_quote(const std::string& line, std::size_t start)
    {
        for (std::size_t i = start + 1; i < line.size(); ++i) {
            if (line[i] == '\\')
                ++i;
            else if (line[i] == line[start])
                return i + 1;
        }
        return line.size();
    }

    std::string raw_end_; // the end of the open raw string, or empty
};

} // namespace

std::vector<Comment> comments(const std::vector<std::string>& lines)
{
    std::vector<Comment> result;
    Reader reader;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        const std::size_t start = reader.comment_start(line);
        if (start == npos) continue;
        const bool is_trailing = line.find_first_not_of(" \t") < start;
        const std::size_t text = line.find_first_not_of("/!< \t", start);
        result.push_back({i + 1, is_trailing, text == npos ? "" : line.substr(text)});
    }
    return result;
}

std::size_t width(std::string_view line)
{
    const auto is_first_byte = [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    };
    return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), is_first_byte));
}

} // namespace rigor::layout
