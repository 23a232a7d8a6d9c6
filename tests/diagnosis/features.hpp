// SPDX-License-Identifier: MIT
// Numbers that arguments have: by one of them a wrong answer may differ from the right one, and
// one of them may decide whether it does.
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
