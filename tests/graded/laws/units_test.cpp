// SPDX-License-Identifier: MIT
// The law of the units, for every formula: if mass, length and time are measured in other units,
// the result changes as its dimension says. The factors are powers of four, up to 2^±60, so the
// change itself is exact.
#include "add_law.hpp"
#include "change.hpp"
#include "inputs.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

#include <fmt/format.h>

#include <functional>

namespace rigor::testing {

namespace {

// Factors up to 2^±50 for masses (from far less than a grain of sand to a mountain), up to 2^±44
// for lengths (from less than an atom to the solar system) and up to 2^±32 for times (from less
// than a nanosecond to a century); half of the factors are these extremes. The sixth power of a
// pressure, which an eigenvalue solver may need, still fits in a double. In a quarter of the cases
// one unit alone changes, by 2^±60, so that no product hides an absolute threshold.
Dimension random_units(unsigned seed, Random& random)
{
    if (seed % 4 == 0) {
        const int exponent = seed / 12 % 2 == 0 ? 60 : -60;
        const unsigned which = seed / 4 % 3;
        return {which == 0 ? exponent : 0, which == 1 ? exponent : 0, which == 2 ? exponent : 0};
    }
    const auto exponent = [&](int largest) {
        if (random.bits() % 2 == 0) return random.bits() % 2 == 0 ? largest : -largest;
        return 2 * (random_index(random, static_cast<std::size_t>(largest) + 1) - largest / 2);
    };
    const int mass = exponent(50), length = exponent(44);
    return {mass, length, exponent(32)};
}

// What happens to a number that is multiplied by `ratio`, in words; powers of two as whole numbers.
std::string growth(double ratio)
{
    const double power = std::log2(std::abs(ratio));
    if (std::abs(power - std::round(power)) < 1e-6 && std::abs(power) < 30)
        return power < 0 ? fmt::format("shrink to 1/{:.0f}", std::exp2(-std::round(power)))
               : std::round(power) == 0
                   ? "stay"
                   : fmt::format("grow {:.0f}-fold", std::exp2(std::round(power)));
    return fmt::format("be {:.6g} times as large", ratio);
}

// A unit, in words, and the change that makes it four times as small, so that numbers grow.
struct Unit {
    const char *all, *one; // "masses", "a mass"
    Dimension change;
};
constexpr Unit units[] = {{"masses", "a mass", {2, 0, 0}},
                          {"lengths", "a length", {0, 2, 0}},
                          {"times", "a time", {0, 0, 2}}};

using NameOfNumber = std::function<std::string(std::size_t)>;

/// What is wrong with the first number of the result that grows wrongly with a unit, in words.
/// @param before         the result before the change
/// @param wanted, found  as it should be and as it is after the change
std::string growth_in_words(const Unit& unit, const std::vector<double>& before,
                            const std::vector<double>& wanted, const std::vector<double>& found,
                            const NameOfNumber& name)
{
    if (found.size() != before.size())
        return fmt::format("when all {} grow 4-fold, the number of values changes; ", unit.all);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double old = before[i], should = wanted[i] / old, is = found[i] / old;
        if (!(std::abs(old) > 1e-9) || std::abs(is - should) <= 1e-6 * std::abs(should)) continue;
        const double missing = std::log2(should / is) / 2;
        const bool is_power = std::abs(missing - std::round(missing)) < 1e-6;
        const std::string place = name(i);
        return fmt::format("when all {} grow 4-fold, {} must {}; yours would {}: ", unit.all,
                           place.empty() ? "the result" : place, growth(should), growth(is)) +
               (is_power ? fmt::format("{} to the power {:.0f} is missing; ", unit.one, missing)
                         : "a number in the formula has a unit, such as an absolute threshold; ");
    }
    return "";
}

/// What happens to a wrong number of the result if only one unit changes, in words.
template <FormulaIndex f, auto& formula>
std::string units_in_words(const Arguments<formula>& arguments)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    const auto result = std::apply(formula, arguments);
    const auto& plain = comparable(result);
    std::string text;
    for (const Unit& unit : units) {
        const Change c = {unit.change};
        Arguments<formula> larger = arguments;
        change_arguments(larger, of, c);
        text += growth_in_words(unit, components(plain).numbers,
                                components(comparable(changed(result, of.result, c))).numbers,
                                components(comparable(std::apply(formula, larger))).numbers,
                                [&](std::size_t i) { return component_name(plain, i); });
    }
    return text.empty() ? "the result depends on the units: a number in the formula has a unit, "
                          "such as an absolute threshold"
                        : text.substr(0, text.size() - 2);
}

template <FormulaIndex f, auto& formula> void check_units()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    for (unsigned seed : seeds(sampled(40))) {
        Random random(seed + 5000);
        const Change c = {random_units(seed, random)};
        const Arguments<formula> arguments = random_arguments<f, formula>(seed);
        Arguments<formula> others = arguments;
        change_arguments(others, of, c);

        const auto expected = std::apply(formula, arguments);
        auto found = changed(std::apply(formula, others), of.result, c.undone());
        choose_as(found, expected, of.result);

        const auto& should = comparable(expected);
        const auto& is = comparable(found);
        const Tolerance tolerance = universal(should);
        if (are_close(components(is), components(should), tolerance)) continue;
        require_close(
            is, should, tolerance,
            fmt::format("{}; here masses are 2^{} times as large, lengths 2^{}, times 2^{}",
                        units_in_words<f, formula>(arguments), c.units.mass, c.units.length,
                        c.units.time));
    }
}

struct Units {
    static constexpr const char* words = "is the same in all units";
    static constexpr bool holds_for(FormulaIndex f) { return has_units(f); }
    template <FormulaIndex f, auto& formula> static void check() { check_units<f, formula>(); }
};

[[maybe_unused]] const bool added_units = add_law<Units>();

} // namespace

} // namespace rigor::testing
