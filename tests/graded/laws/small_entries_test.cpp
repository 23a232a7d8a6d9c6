// SPDX-License-Identifier: MIT
// The law of small entries: where an entry of the result is proportional to a number of the
// arguments, it stays so however small the number is beside all others. A formula that compares its
// arguments and takes small ones for 0 breaks the law. Whether an entry is proportional shows at
// factors that rounding would still tell from others.
#include "add_law.hpp"
#include "own_answers.hpp"
#include "strata.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

#include <fmt/format.h>

namespace rigor::testing {

namespace {

// The formulas of sums and products, in which no number is compared with another one.
constexpr std::string_view without_comparisons =
    "kinetic_energy cross_matrix world_point object_point angular_velocity point_velocity "
    "velocity_modes generalized_mass net_wrench equations_of_motion velocity_mode_rates "
    "inertial_wrench multiply conjugate rotate quaternion_rate advance_matrix gravity_wrench "
    "impulse_matrix apply_impulse isotropic_stress";

constexpr int proportional[] = {4, 40, 60}, small[] = {107, 160, 300}; // powers of 1/2

/// The numbers of the arguments that may be small.
template <class Arguments>
std::vector<double*> numbers_of(Arguments& arguments, const FormulaQuantities& of)
{
    std::vector<double*> numbers;
    const auto collect = [&](auto& argument, std::size_t k) {
        const auto unchanged = argument;
        each_pair(argument, unchanged, of.arguments[k], false,
                  [&](auto& leaf, const auto&, const Quantity& q) {
                      using Leaf = std::remove_cvref_t<decltype(leaf)>;
                      if (q.kind == Kind::unit || q.kind == Kind::rotation ||
                          q.kind == Kind::index || q.kind == Kind::orientation ||
                          q.kind == Kind::along_axes)
                          return;
                      if constexpr (std::is_same_v<Leaf, double>)
                          numbers.push_back(&leaf);
                      else if constexpr (std::is_same_v<Leaf, Vector3d>)
                          for (double& x : leaf)
                              numbers.push_back(&x);
                      else if constexpr (std::is_same_v<Leaf, Matrix3d>)
                          for (double& x : leaf.reshaped())
                              if (q.kind == Kind::matrix) numbers.push_back(&x);
                  });
    };
    std::size_t k = 0;
    std::apply([&](auto&... argument) { (collect(argument, k++), ...); }, arguments);
    return numbers;
}

template <FormulaIndex f, auto& formula> void check_small_entries()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    const std::string_view names = formulas[static_cast<unsigned>(f)].arguments;
    for (unsigned seed : seeds(sampled(150))) {
        Random random(seed + 7000);
        Arguments<formula> arguments = random_arguments<f, formula>(seed);
        redraw_chosen(arguments, of, names, "", true, random);
        const std::vector<double*> numbers = numbers_of(arguments, of);
        if (numbers.empty()) continue;
        double& number = *numbers[static_cast<std::size_t>(random_index(random, numbers.size()))];
        if (number == 0) number = random.uniform(0.1, 1);
        const double full = number;
        const auto result_at = [&](int power) {
            number = std::ldexp(full, -power);
            return components(std::apply(formula, arguments));
        };
        const Components whole = result_at(0);
        std::vector<bool> is_proportional(whole.numbers.size(), true);
        const auto grows = [&](const Components& result, std::size_t i, int power) {
            return result.numbers[i] == std::ldexp(whole.numbers[i], -power);
        };
        for (const int power : proportional) {
            const Components result = result_at(power);
            for (std::size_t i = 0; i < whole.numbers.size(); ++i)
                if (whole.numbers[i] == 0 || !grows(result, i, power)) is_proportional[i] = false;
        }
        for (const int power : small) {
            const Components result = result_at(power);
            check_count(result.numbers.size(), whole.numbers.size(), "numbers, as for other calls");
            for (std::size_t i = 0; i < whole.numbers.size(); ++i)
                check_that(!is_proportional[i] || result.numbers[i] != 0,
                           fmt::format("{} has no smallest number: a number of the result that is "
                                       "proportional to one of the arguments is not 0 where this "
                                       "is 2^-{} times as large",
                                       name_of(f), power));
        }
    }
}

struct SmallEntries {
    static constexpr const char* words = "counts each number however small";
    static constexpr bool holds_for(FormulaIndex f)
    {
        return has_word(without_comparisons, name_of(f));
    }
    template <FormulaIndex f, auto& formula> static void check()
    {
        check_small_entries<f, formula>();
    }
};

[[maybe_unused]] const bool added_small_entries = add_law<SmallEntries>();

} // namespace

} // namespace rigor::testing
