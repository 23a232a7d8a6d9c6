// SPDX-License-Identifier: MIT
#include "grading/build/object_symbols.hpp"

#include "errors/utf8.hpp"
#include "formulas/table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <sstream>
#include <string_view>

namespace rigor {

namespace {

// The formula that a linker name stands for, whatever its signature; nullptr if it is no formula.
// The ABI of C++ (Itanium) writes `rigor::torque(...)` as `_ZN5rigor6torqueE...`. Nothing demangles
// the rest, because a short name can stand for a signature of 10¹² letters.
const Formula* formula_of(std::string_view symbol)
{
    constexpr std::string_view scope = "_ZN5rigor";
    if (!symbol.starts_with(scope)) return nullptr;
    symbol.remove_prefix(scope.size());
    for (const Formula& row : formulas) {
        const std::string function = fmt::format("{}{}E", row.name.size(), row.name);
        if (symbol.starts_with(function) && symbol.size() > function.size()) return &row;
    }
    return nullptr;
}

// Whether a weak name, which several objects may define, is meant to be shared by them: the name of
// a template or an inline function of C++, or a name that the compiler makes for itself, such as
// the pointer `DW.ref.__gxx_personality_v0` to the function that finds exception handlers. A weak
// name of C, or a weak `operator new` or `delete`, is not meant to be shared: it would replace the
// function of the C library or of the worker.
bool is_shared(const std::string& name)
{
    constexpr std::string_view replaceable[] = {"_Znw", "_Zna", "_Zdl", "_Zda"};
    if (name.starts_with("__") || name.find('.') != std::string::npos) return true;
    return name.starts_with("_Z") &&
           std::none_of(std::begin(replaceable), std::end(replaceable),
                        [&](std::string_view operation) { return name.starts_with(operation); });
}

// Whether a line of `nm -P` has just a name, one character and up to two hexadecimal numbers. A
// name may be megabytes long, too long for std::regex.
bool is_name_kind_and_numbers(const std::string& line)
{
    std::istringstream words(line);
    std::string name, kind, value, size, more;
    words >> name >> kind >> value >> size >> more;
    const auto is_number = [](const std::string& word) {
        return word.find_first_not_of("0123456789abcdef") == std::string::npos;
    };
    return line.starts_with(name) && kind.size() == 1 && is_number(value) && is_number(size) &&
           more.empty();
}

} // namespace

ObjectSymbols parse_symbols(const std::string& listing)
{
    ObjectSymbols symbols;
    std::istringstream lines(listing);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        char kind = 0;
        if (!(words >> name >> kind)) continue;
        const auto is_one_of = [kind](std::string_view kinds) {
            return kinds.find(kind) != std::string_view::npos;
        };
        if (kind == 'U')
            symbols.undefined.insert(name);
        else if (is_one_of("WVu") && is_shared(name) && formula_of(name) == nullptr)
            symbols.shared.push_back(name);
        else if (is_one_of("TDBRCGSAiWVu"))
            symbols.defined.insert(name);
    }
    return symbols;
}

std::string line_with_unreadable_name(const std::string& listing)
{
    // Messages of nm itself, such as "/usr/bin/nm: …: no symbols", begin like this.
    constexpr std::string_view own_words = "/usr/bin/nm: ";
    std::istringstream lines(listing);
    for (std::string line; std::getline(lines, line);)
        if (!is_plain_utf8(line) ||
            (!line.starts_with(own_words) && !is_name_kind_and_numbers(line)))
            return line;
    return "";
}

std::map<std::string, std::vector<std::string>>
names_to_hide(const std::map<std::string, ObjectSymbols>& objects,
              const std::set<std::string>& reserved)
{
    // For each name that another object or the worker uses, the object whose definition counts.
    std::map<std::string, std::string> keeper;
    for (const auto& [topic, symbols] : objects)
        for (const std::string& name : symbols.defined) {
            const Formula* formula = formula_of(name);
            bool is_used = formula != nullptr;
            for (const auto& [other, others] : objects)
                is_used = is_used || (other != topic && others.undefined.count(name) > 0);
            if (!is_used || (formula == nullptr && reserved.count(name) > 0)) continue;
            if (formula != nullptr && formula->topic == topic)
                keeper[name] = topic;
            else
                keeper.emplace(name, topic);
        }
    std::map<std::string, std::vector<std::string>> hidden;
    for (const auto& [topic, symbols] : objects)
        for (const std::string& name : symbols.defined) {
            const auto kept = keeper.find(name);
            if (name == "main" || kept == keeper.end() || kept->second != topic)
                hidden[topic].push_back(name);
        }
    return hidden;
}

} // namespace rigor
