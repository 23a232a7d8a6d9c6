// SPDX-License-Identifier: MIT
// The mutants that are wrapped around a formula, as calls of the templates in wrapped.hpp.
#pragma once

#include "mutants/source.hpp"

#include <string>
#include <vector>

namespace rigor::mutants {

struct Wrapper {
    std::string name; // "argument mass: in_float"
    std::string call; // what a mutant returns
};

/// All wrappers of a formula. `original` is the name of the function that has its body.
std::vector<Wrapper> wrappers(const Source& source, const Function& function,
                              const std::string& original);

} // namespace rigor::mutants
