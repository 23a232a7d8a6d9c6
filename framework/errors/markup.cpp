// SPDX-License-Identifier: MIT
#include "errors/markup.hpp"

namespace rigor {

std::string escaped_markup(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
}

} // namespace rigor
