// SPDX-License-Identifier: MIT
#include "report/exports/listed_name.hpp"

#include "errors/quotes.hpp"
#include "errors/utf8.hpp"

#include <string_view>

namespace rigor {

namespace {

// Whether all blanks are single spaces between words.
bool has_plain_blanks(std::string_view name)
{
    bool is_after_blank = true; // so that a blank at the start counts as one too many
    while (!name.empty()) {
        const std::size_t blank = blank_size(name);
        if (blank > 0 && (is_after_blank || name[0] != ' ')) return false;
        is_after_blank = blank > 0;
        name.remove_prefix(1);
    }
    return !is_after_blank;
}

} // namespace

std::string listed_name(const std::string& name)
{
    const bool is_plain =
        has_plain_blanks(name) && name.find_first_of(",;:()[]\"") == std::string::npos;
    return is_plain ? name : in_quotes(name, name.size());
}

} // namespace rigor
