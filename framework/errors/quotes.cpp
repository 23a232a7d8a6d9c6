// SPDX-License-Identifier: MIT
#include "errors/quotes.hpp"

#include "errors/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

std::string in_quotes(std::string_view text, std::size_t longest)
{
    std::string shown = "\"";
    for (std::size_t i = 0; i < text.size();) {
        if (i >= longest) return shown + "…\"";
        const std::size_t size = character_size(text.substr(i));
        if (text[i] == '\n')
            shown += "\\n";
        else if (text[i] == '"')
            shown += "\\\"";
        else if (size == 0)
            shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
        else
            shown += text.substr(i, size);
        i += std::max<std::size_t>(size, 1);
    }
    return shown + "\"";
}

std::string behind_bars(std::string_view text)
{
    std::string shown = "| ";
    for (const char c : text.substr(0, text.find_last_not_of('\n') + 1))
        shown += c == '\n' ? std::string("\n| ") : std::string(1, c);
    return shown;
}

} // namespace rigor
