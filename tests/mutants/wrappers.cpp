// SPDX-License-Identifier: MIT
// Chooses for each argument and for the result what can be changed in its type.
#include "mutants/wrappers.hpp"

#include "formulas/quantities.hpp"

#include <algorithm>
#include <iterator>

namespace rigor::mutants {

namespace {

struct Changed {
    std::string change, bound;
};

using Changes = std::vector<Changed>;

bool contains(const std::string& type, const std::string& word)
{
    return type.find(word) != std::string::npos;
}

bool is_list(const std::string& type)
{
    return contains(type, "std::vector<");
}

// Whether a value of this type has numbers that are not indices.
bool has_numbers(const std::string& type)
{
    return !contains(type, "int") && !contains(type, "bool") && !contains(type, "MeshFace") &&
           type.find("Edges") == std::string::npos;
}

// Whether the largest number of each value of this set is about 1.
bool is_unit(Kind kind)
{
    return kind == Kind::unit || kind == Kind::direction || kind == Kind::rotation ||
           kind == Kind::orientation;
}

// Whether a change leaves every value of this set as it is.
bool is_nothing(const Changed& change, Kind kind)
{
    const std::string& name = change.change;
    if (name == "absolute" || name == "not_negative") return kind == Kind::number;
    if (name == "transposed" || name == "symmetric")
        return kind == Kind::symmetric || kind == Kind::definite;
    return name == "clamped" && is_unit(kind);
}

Changes changes_of(const std::string& type, Kind kind)
{
    Changes result;
    if (type == "bool") return {{"negated", "0"}};
    if (type == "int") return {{"at_most", "2"}, {"at_most", "8"}, {"next", "1"}, {"next", "-1"}};
    if (has_numbers(type)) {
        result = {{"in_float", "0"}, {"shifted", "1e-6"}, {"absolute", "0"},
                  {"negated", "0"},  {"clamped", "1"},    {"clamped", "100"},
                  {"cut", "1e-9"},   {"cut", "1e-6"},     {"cut", "1e-3"}};
        if (type == "double") result.push_back({"not_negative", "0"});
    }
    if (contains(type, "Matrix3d"))
        for (const char* change : {"transposed", "diagonal", "symmetric"})
            result.push_back({change, "0"});
    if (is_list(type)) {
        result.push_back({"without_last", "0"});
        result.push_back({"without_first", "0"});
    }
    std::erase_if(result, [&](const Changed& change) { return is_nothing(change, kind); });
    return result;
}

std::string text_of(const Changed& change)
{
    return "Change::" + change.change + ", " + change.bound;
}

std::string name_of(const Changed& change)
{
    return change.change + (change.bound == "0" ? "" : " " + change.bound);
}

} // namespace

std::vector<Wrapper> wrappers(const Source& source, const Function& function,
                              const std::string& original)
{
    std::vector<Wrapper> result;
    std::string all;
    for (const std::string& argument : function.arguments)
        all += ", " + argument;
    const auto add = [&](const std::string& name, const std::string& wrapper,
                         const std::string& options) {
        result.push_back({name, "mutants::" + wrapper + "(" + original + options + all + ")"});
    };
    const FormulaQuantities& of =
        *std::find_if(std::begin(formula_quantities), std::end(formula_quantities),
                      [&](const FormulaQuantities& row) { return row.name == function.name; });
    for (const Changed& change :
         changes_of(source.between(function.declaration, function.name_token - 1), of.result.kind))
        add("result: " + name_of(change), "with_result", ", mutants::" + text_of(change));
    for (std::size_t i = 0; i < function.arguments.size(); ++i) {
        const std::string &type = function.types[i], at = "<" + std::to_string(i) + ">";
        const std::string name = "argument " + function.arguments[i] + ": ";
        for (const Changed& change : changes_of(type, of.arguments[i].kind))
            add(name + name_of(change), "with_argument" + at, ", mutants::" + text_of(change));
        add(name + "change not seen", "remembered" + at, "");
        if (has_numbers(type) && !is_unit(of.arguments[i].kind)) {
            for (const char* bound : {"1e-9", "1e-6", "1e-3"})
                add(name + "zero below " + bound, "guarded" + at, std::string(", false, ") + bound);
            for (const char* bound : {"1e3", "1e6"})
                add(name + "zero above " + bound, "guarded" + at, std::string(", true, ") + bound);
        }
        if (is_list(type))
            for (const char* bound : {"8", "100"})
                add(name + "zero for more than " + bound, "limited" + at,
                    std::string(", ") + bound);
    }
    return result;
}

} // namespace rigor::mutants
