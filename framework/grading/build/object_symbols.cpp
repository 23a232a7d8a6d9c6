// SPDX-License-Identifier: MIT
#include "grading/build/object_symbols.hpp"

#include "formulas/table.hpp"

#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <sstream>
#include <string_view>

namespace rigor {

namespace {

// "rigor::combine(rigor::MassProperties const&, …)" for its linker name; empty if it has no other.
std::string demangled(const std::string& name)
{
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
    return status == 0 ? text.get() : "";
}

// The formula of this name, whatever its signature; nullptr if it is none.
const Formula* formula_of(const std::string& symbol)
{
    const std::string text = demangled(symbol);
    constexpr std::string_view scope = "rigor::";
    const std::size_t end = text.find('(');
    if (!text.starts_with(scope) || end == std::string::npos) return nullptr;
    const std::string name = text.substr(scope.size(), end - scope.size());
    for (const Formula& row : formulas)
        if (row.name == name) return &row;
    return nullptr;
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
        if (kind == 'U')
            symbols.undefined.insert(name);
        else if (std::string_view("TDBRCGS").find(kind) != std::string_view::npos)
            symbols.defined.insert(name);
    }
    return symbols;
}

std::map<std::string, std::vector<std::string>>
names_to_hide(const std::map<std::string, ObjectSymbols>& objects)
{
    // The object whose definition counts, for each name that another object uses or the worker.
    std::map<std::string, std::string> keeper;
    for (const auto& [topic, symbols] : objects)
        for (const std::string& name : symbols.defined) {
            const Formula* formula = formula_of(name);
            bool is_used = formula != nullptr;
            for (const auto& [other, others] : objects)
                is_used = is_used || (other != topic && others.undefined.count(name) > 0);
            if (!is_used) continue;
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
