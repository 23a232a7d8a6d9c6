// SPDX-License-Identifier: MIT
// One source that contains all mutants of a source.
#pragma once

#include "mutants/source.hpp"

#include <set>
#include <string>
#include <vector>

namespace rigor::mutants {

/// One wrong solution.
struct Mutant {
    int number;              // from 1
    std::string function;    // the function that is wrong
    std::string name;        // what is wrong: "old line => new line", in one line of text
    std::size_t first, last; // its lines in the generated text, from 1
};

struct Generated {
    std::string text;
    std::vector<Mutant> mutants;
};

/// The source with all its mutants, except those whose numbers are in `without`. At run time,
/// RIGOR_MUTANT="STEM NUMBER" selects one of them; otherwise all functions are the unchanged ones.
/// @param stem  the name of the source without `.cpp`, such as `fracture_vertices`; the part before
///              its first underscore is the topic
Generated generate(const Source& source, const std::string& stem, const std::set<int>& without);

} // namespace rigor::mutants
