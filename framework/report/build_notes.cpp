// SPDX-License-Identifier: MIT
#include "report/build_notes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace rigor {

namespace {

std::string left_out_of(const Implementation& implementation)
{
    constexpr std::size_t most_names = 5;
    const std::vector<std::string>& names = implementation.left_out;
    const std::size_t shown = std::min(names.size(), most_names);
    std::string text;
    for (std::size_t i = 0; i < shown; ++i)
        text += fmt::format("left out: {}/{}\n", implementation.name, names[i]);
    if (names.size() > shown)
        text += fmt::format("left out: {} more files\n", names.size() - shown);
    return text;
}

} // namespace

std::string build_notes(const Implementation& implementation)
{
    std::string text;
    for (const auto& [topic, errors] : implementation.broken)
        text += fmt::format("{}/{}.cpp does not compile: its formulas are missing\n",
                            implementation.name, topic);
    if (!implementation.borrowed.empty())
        text += fmt::format("{} has no {}.cpp: what student/ has takes their place\n",
                            implementation.name, fmt::join(implementation.borrowed, ".cpp, "));
    text += left_out_of(implementation);
    if (!implementation.build_steps.empty())
        text += fmt::format("built in {:.1f} s ({} {})\n", implementation.build_seconds,
                            implementation.build_steps.size(),
                            implementation.build_steps.size() == 1 ? "step" : "steps");
    return text;
}

} // namespace rigor
