// SPDX-License-Identifier: MIT
#include "scene/language/keys.hpp"

#include "errors/nearest.hpp"
#include "errors/quotes.hpp"

#include <fmt/format.h>

namespace rigor {

std::string list_of(std::span<const std::string_view> names)
{
    std::string text;
    for (const std::string_view name : names)
        text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", name);
    return text;
}

void unknown_key(const Value& value, std::span<const std::string_view> names)
{
    constexpr std::size_t most_listed = 12; // a longer list would make the message unreadable
    std::string all = "expected no key here";
    if (names.size() > most_listed)
        all = "assignments/scenes.md lists the keys that are known here";
    else if (!names.empty())
        all = fmt::format("expected one of {}", list_of(names));
    throw Mistake{value.line, fmt::format("unknown key {}{}", in_quotes(value.key),
                                          suggestion(value.key, names, all))};
}

const Value* find(const Value& object, std::string_view key)
{
    for (const Value& item : object.items)
        if (item.key == key) return &item;
    return nullptr;
}

} // namespace rigor
