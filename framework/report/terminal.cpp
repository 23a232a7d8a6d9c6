// SPDX-License-Identifier: MIT
#include "report/terminal.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <unistd.h>

namespace rigor {

bool is_terminal(int descriptor)
{
    return isatty(descriptor) == 1;
}

bool wants_color(int descriptor)
{
    const char *no_color = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
    const bool refused = no_color && *no_color;
    return is_terminal(descriptor) && !refused && terminal && std::string_view(terminal) != "dumb";
}

std::string colored(std::string_view text, Color color, bool wanted)
{
    if (!wanted || color == Color::none) return std::string(text);
    constexpr const char* codes[] = {"0", "1", "2", "32", "33", "31"};
    return "\033[" + std::string(codes[static_cast<int>(color)]) + "m" + std::string(text) +
           "\033[0m";
}

std::size_t columns(std::string_view text)
{
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80; // not a UTF-8 continuation byte
    }));
}

std::string padded(std::string_view text, std::size_t width)
{
    const std::size_t used = columns(text);
    return std::string(text) + std::string(width > used ? width - used : 0, ' ');
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent)
{
    const std::string margin = "\n" + std::string(indent, ' ');
    std::string result;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        if (!result.empty()) result += margin;
        std::istringstream words(line);
        std::size_t used = 0;
        for (std::string word; words >> word;) {
            if (used > 0 && used + 1 + columns(word) > width) {
                result += margin;
                used = 0;
            }
            result += (used > 0 ? " " : "") + word;
            used += columns(word) + (used > 0 ? 1 : 0);
        }
    }
    return result;
}

} // namespace rigor
