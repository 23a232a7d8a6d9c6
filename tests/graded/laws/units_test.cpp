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

/// What happens to a wrong number of the result if only one unit changes, in words.
template <FormulaIndex f, auto& formula>
std::string units_in_words(const Arguments<formula>& arguments)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    const auto result = std::apply(formula, arguments);
    const auto& plain = comparable(result);
    const Components before = components(plain);
    const std::tuple<std::string, std::string, Dimension> units[] = {
        {"masses", "a mass", {2, 0, 0}},
        {"lengths", "a length", {0, 2, 0}},
        {"times", "a time", {0, 0, 2}}};
    std::string text;
    for (const auto& [all, one, unit] : units) {
        const Change c = {unit};
        Arguments<formula> larger = arguments;
        change_arguments(larger, of, c);
        const Components wanted = components(comparable(changed(result, of.result, c))),
                         found = components(comparable(std::apply(formula, larger)));
        if (found.numbers.size() != before.numbers.size()) {
            text += fmt::format("when all {} grow 4-fold, the number of values changes; ", all);
            continue;
        }
        for (std::size_t i = 0; i < before.numbers.size(); ++i) {
            const double old = before.numbers[i], should = wanted.numbers[i] / old,
                         is = found.numbers[i] / old;
            if (!(std::abs(old) > 1e-9) || std::abs(is - should) <= 1e-6 * std::abs(should))
                continue;
            const double missing = std::log2(should / is) / 2;
            const bool is_power = std::abs(missing - std::round(missing)) < 1e-6;
            const std::string place = component_name(plain, i);
            text += fmt::format("when all {} grow 4-fold, {} must {}; yours would {}: ", all,
                                place.empty() ? "the result" : place, growth(should), growth(is));
            text += is_power ? fmt::format("{} to the power {:.0f} is missing; ", one, missing)
                             : "a number in the formula has a unit, such as an absolute "
                               "threshold; ";
            break;
        }
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
        const bool is_wrong = compare(is, should, tolerance).kind != Difference::none;
        const std::string words = is_wrong ? units_in_words<f, formula>(arguments) : "";
        INFO(words);
        INFO(fmt::format("masses are 2^{} times as large, lengths 2^{}, times 2^{}", c.units.mass,
                         c.units.length, c.units.time));
        REQUIRE_THAT(is, IsClose(should, tolerance));
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
