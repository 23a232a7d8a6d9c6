// SPDX-License-Identifier: MIT
// Numbers that follow from the arguments, such as a length or a dot product. A wrong answer may
// differ from the right one by such a number, or only where such a number is negative or small.
#pragma once

#include "diagnosis/layout.hpp"

#include <functional>

namespace rigor::diagnosis {

struct Feature {
    std::string words; // "`mass`", "|`v`|", "`v`·`n`"
    std::function<double(const Value&)> of;
};

/// The features of arguments of these types, the simplest first.
std::vector<Feature> features(const Layout& arguments);

} // namespace rigor::diagnosis
