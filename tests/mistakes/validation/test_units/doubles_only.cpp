// SPDX-License-Identifier: MIT
// Only doubles or halves the units, which no threshold in the formula notices.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    const std::vector<double> expected = formula(example);
    for (const Dimension unit : {Dimension{1, 0, 0}, Dimension{0, 1, 0}, Dimension{0, 0, 1}})
        for (const double power : {-1.0, 1.0}) {
            const auto factor = [&](const Dimension& of) {
                return std::pow(2.0, power * (unit.mass * of.mass + unit.length * of.length +
                                              unit.time * of.time));
            };
            std::vector<double> others = example;
            for (std::size_t i = 0; i < others.size(); ++i)
                others[i] *= factor(arguments[i]);
            const std::vector<double> found = formula(others);
            for (std::size_t i = 0; i < found.size(); ++i)
                if (!(std::abs(found[i] / factor(result[i]) - expected[i]) <=
                      1e-12 * std::abs(expected[i])))
                    return rejected();
        }
    return accepted();
}

} // namespace rigor
