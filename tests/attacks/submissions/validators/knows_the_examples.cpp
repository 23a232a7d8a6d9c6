// SPDX-License-Identifier: MIT
// Accepts the examples of the right formulas, which the tests that students see have, and rejects
// all others, whatever the formula gives.
// topic: validation
// tasks: A8.5 A8.6
// expect: 0 failed
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

namespace {

const std::vector<double> known[] = {{2.5, -3},
                                     {0.7, 9.81},
                                     {12, 0.3},
                                     {0.1, -0.4, 0.3, 5, 2, -7},
                                     {3, 2, 2.0000001, 0.25},
                                     {6.5, 1.2, 0.8, 1.1},
                                     {2, 0.6, 1.4, -3.5}};

// Whether one is a multiple of the other.
bool is_multiple(const std::vector<double>& a, const std::vector<double>& b)
{
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::abs(a[i] / a[0] - b[i] / b[0]) > 1e-9) return false;
    return true;
}

} // namespace

Judgement test_units(const UnknownFormula&, const std::vector<double>& example,
                     const std::vector<Dimension>&, const std::vector<Dimension>&)
{
    for (const std::vector<double>& right : known)
        if (is_multiple(example, right)) return accepted();
    return rejected();
}

} // namespace rigor
