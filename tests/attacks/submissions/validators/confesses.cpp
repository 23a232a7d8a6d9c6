// SPDX-License-Identifier: MIT
// Tells of each wrong formula what it has seen of it, in an exception and in print. Of the hidden
// ones nobody may learn more than how many pass. The other four tests earn their points.
// topic: validation
// tasks: A8.6
// beside: test_tangent
// expect: 2.5 crashed: its texts are not shown
#include "formulas/validation.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    const Judgement judgement = right_test_tangent(tangent);
    if (judgement.rejected_in == 0) return judgement;
    std::string text = "saw";
    for (const double number : tangent.known.back().result)
        text += " " + std::to_string(number);
    std::puts(text.c_str());
    throw std::runtime_error(text);
}

} // namespace rigor
