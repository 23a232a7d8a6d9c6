// SPDX-License-Identifier: MIT
#include "errors/printable.hpp"

namespace rigor {

std::string printable(std::string text)
{
    for (char& c : text) {
        const bool is_plain = (c >= ' ' && c <= '~') || c == '\n' || c == '\t';
        if (!is_plain) c = '?';
    }
    return text;
}

} // namespace rigor
