// SPDX-License-Identifier: MIT
// The mutants that a build has.
#pragma once

#include "formulas/table.hpp"

#include <filesystem>
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

} // namespace rigor::mutants
