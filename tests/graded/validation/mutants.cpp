// SPDX-License-Identifier: MIT
#include "mutants.hpp"

#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rigor::testing {

namespace {

double largest(const std::vector<double>& numbers)
{
    double result = 0;
    for (const double number : numbers)
        result = std::max(result, std::abs(number));
    return result;
}

bool differs(const std::vector<double>& a, const std::vector<double>& b)
{
    constexpr double clearly = 1e-3; // relative to the largest number
    const double scale = std::max(largest(a), largest(b));
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(std::abs(a[i] - b[i]) <= clearly * scale)) return true;
    return false;
}

std::size_t index_below(std::size_t n, Random& random)
{
    return static_cast<std::size_t>(random.bits() % n);
}

NumericFormula wrong_result(const NumericFormula& formula, std::size_t i, int kind, Random& random)
{
    const double factor = 1 + random.uniform(0.01, 0.5), threshold = random.uniform(-1, 1);
    return [=, before = std::optional<double>()](const std::vector<double>& from) mutable {
        std::vector<double> result = formula(from);
        double& number = result[i];
        const double right = number;
        if (kind == 0) number *= factor;
        if (kind == 1) number = -number;
        if (kind == 2) number = before.value_or(number);
        if (kind == 3 && number > threshold) number *= factor;
        before = right;
        return result;
    };
}

NumericFormula wrong_arguments(const NumericFormula& formula, std::size_t i, std::size_t k,
                               bool exchanges)
{
    return [=](std::vector<double> from) {
        if (exchanges)
            std::swap(from[i], from[k]);
        else
            from[i] = 1;
        return formula(from);
    };
}

NumericFormula mutant(const NumericFormula& formula, const std::vector<double>& arguments,
                      Random& random)
{
    const std::size_t results = formula(arguments).size();
    const int kind = static_cast<int>(random.bits() % 6);
    if (kind < 4) return wrong_result(formula, index_below(results, random), kind, random);
    const std::size_t i = index_below(arguments.size(), random);
    return wrong_arguments(formula, i, index_below(arguments.size(), random), kind == 4);
}

} // namespace

std::vector<WrongNumeric> mutants(const NumericFormula& formula,
                                  const std::function<std::vector<double>(unsigned seed)>& draw,
                                  std::size_t count)
{
    constexpr unsigned cases = 40;
    Random random(first_seed() + 4000);
    std::vector<WrongNumeric> all;
    while (all.size() < count) {
        const NumericFormula wrong = mutant(formula, draw(0), random);
        NumericFormula tried = wrong; // a copy, which remembers its own calls
        unsigned different = 0;
        for (unsigned seed = 0; seed < cases; ++seed)
            different += differs(formula(draw(seed)), tried(draw(seed))) ? 1 : 0;
        if (4 * different >= cases) all.push_back({"", wrong});
    }
    return all;
}

} // namespace rigor::testing
