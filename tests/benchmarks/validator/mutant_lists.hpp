// SPDX-License-Identifier: MIT
// The mutants that a build has, and those that are known to be no mistakes.
#pragma once

#include "formulas/table.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rigor::mutants {

/// One wrong solution.
struct Mutant {
    std::string stem;                 // the source that it was made from: "fracture_vertices"
    int number = 0;                   // its number in this source
    std::string function;             // the function that is changed
    std::string name;                 // the change
    const Formula* formula = nullptr; // the formula that is changed; none for a function that
                                      // several formulas call
    std::string caught_by;            // the test case that caught it; empty if none did
    bool is_equivalent = false;

    std::string topic() const { return stem.substr(0, stem.find('_')); }
    std::string path() const { return stem + "/" + function + ": " + name; }
};

/// The mutants of a source.
std::vector<Mutant> mutants_of(const std::filesystem::path& folder, const std::string& stem);

/// Mutants that are as correct as the source, by their paths, each with the reason. In the file, a
/// reason is a paragraph of lines that begin with `#`. Paths follow it, one in each line.
std::map<std::string, std::string> equivalent_mutants(const std::filesystem::path& file);

} // namespace rigor::mutants
