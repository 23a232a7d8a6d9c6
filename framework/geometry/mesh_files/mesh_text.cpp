// SPDX-License-Identifier: MIT
#include "geometry/mesh_files/mesh_text.hpp"

#include <array>

namespace rigor {

std::string quoted(std::string_view token, const char* end)
{
    constexpr std::size_t most_shown = 24; // characters
    if (token.empty()) return end;
    std::string shown;
    for (const char c : token.substr(0, most_shown))
        shown += c >= ' ' && c <= '~' ? c : '?';
    return "\"" + shown + (token.size() > most_shown ? "...\"" : "\"");
}

void append(std::string& text, double number)
{
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    text.append(digits.data(), end);
}

} // namespace rigor
