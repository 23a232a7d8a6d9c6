// SPDX-License-Identifier: MIT
#include "cli/options.hpp"

#include "report/terminal.hpp"

#include <CLI/CLI.hpp>

namespace rigor {

namespace {

constexpr std::size_t help_width = 80; // [characters]; CLI11 does not break lines itself

std::string broken(const std::string& meaning)
{
    return wrapped(meaning, help_width - Options::name_width, 0);
}

} // namespace

void Options::flag(const std::string& name, bool& value, const std::string& meaning)
{
    app_.add_flag(name, value, broken(meaning));
}

void Options::option(const std::string& name, const std::string& value_name, std::string& value,
                     const std::string& meaning)
{
    app_.add_option(name, value, broken(meaning))->type_name(value_name);
}

void Options::option(const std::string& name, const std::string& value_name, std::uint32_t& value,
                     const std::string& meaning)
{
    app_.add_option(name, value, broken(meaning))->type_name(value_name);
}

void Options::words(const std::string& value_name, std::vector<std::string>& values,
                    const std::string& meaning)
{
    app_.add_option(value_name, values, broken(meaning))->type_name("");
}

void Options::word(const std::string& value_name, std::string& value, const std::string& meaning)
{
    app_.add_option(value_name, value, broken(meaning))->type_name("")->required();
}

void Options::word_or_none(const std::string& value_name, std::string& value,
                           const std::string& meaning)
{
    app_.add_option(value_name, value, broken(meaning))->type_name("");
}

void Options::examples(const std::vector<std::string>& lines)
{
    std::string text = "Examples:";
    for (const std::string& line : lines)
        text += "\n  ./rigor " + line;
    app_.footer(text);
}

} // namespace rigor
