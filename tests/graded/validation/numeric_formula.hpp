// SPDX-License-Identifier: MIT
// Formulas as functions from numbers to numbers, which is all that a judge needs to know of them.
#pragma once

#include "candidates.hpp"

#include <string>
#include <tuple>
#include <vector>

namespace rigor::testing {

/// A formula as a function from numbers to numbers.
using NumericFormula = Function<UnknownFormula>;

template <class Result, class... Argument>
NumericFormula numeric(const std::function<Result(Argument...)>& formula)
{
    return [formula](const std::vector<double>& from) {
        std::tuple<Argument...> arguments;
        std::size_t at = 0;
        std::apply([&](auto&... argument) { (numbers::take(argument, from, at), ...); }, arguments);
        std::vector<double> result;
        numbers::append(result, std::apply(formula, arguments));
        return result;
    };
}

struct WrongNumeric {
    std::string clue; // empty if nothing is to be said
    NumericFormula formula;
};

template <class Formula>
std::vector<WrongNumeric> numeric(const std::vector<WrongFormula<Formula>>& formulas)
{
    std::vector<WrongNumeric> all;
    for (const WrongFormula<Formula>& wrong : formulas)
        all.push_back({wrong.clue, numeric(wrong.formula)});
    return all;
}

template <class Formula>
std::vector<NumericFormula> numeric(const std::vector<std::function<Formula>>& formulas)
{
    std::vector<NumericFormula> all;
    for (const auto& formula : formulas)
        all.push_back(numeric(formula));
    return all;
}

} // namespace rigor::testing
