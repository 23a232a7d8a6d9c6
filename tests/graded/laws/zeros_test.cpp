// SPDX-License-Identifier: MIT
// The law of zeros: a zero has no sign. A formula that asks for the sign bit, or divides by a zero,
// finds another result for -0 than for 0, although these numbers are equal.
#include "add_law.hpp"
#include "change.hpp"
#include "special_arguments.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

namespace rigor::testing {

namespace {

// Where several results are right, such as the completion of a basis, the sign of a zero may decide
// between them.
constexpr std::string_view open_choices =
    "gram_schmidt principal_axes principal_stress crack_plane max_time_step yield_strain";

// Gives each zero of a value the sign that `sign` returns.
template <class T, class Sign> void sign_zeros(T& value, const Sign& sign)
{
    if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view, auto& field) { sign_zeros(field, sign); });
    } else if constexpr (IsOptional<T>::value) {
        if (value) sign_zeros(*value, sign);
    } else if constexpr (std::is_same_v<T, double>) {
        if (value == 0) value = std::copysign(0.0, sign());
    } else if constexpr (requires { value.coeffRef(0, 0); }) {
        for (double& entry : value.reshaped())
            sign_zeros(entry, sign);
    } else if constexpr (requires { value.begin(); } && !std::is_same_v<T, std::vector<bool>>) {
        for (auto& element : value)
            sign_zeros(element, sign);
    }
}

// Whether the arguments are a mesh or a pile, whose parts must fit together.
constexpr bool fits_together(const Formula& of)
{
    return of.topic == "contact" || (of.topic == "fracture" && of.name != "smooth_stress") ||
           of.name == "mesh_mass_properties";
}

// Arguments that have zeros. Where they must fit together, the random case is taken, in which
// bodies that cannot move have zeros.
template <FormulaIndex f, auto& formula> Arguments<formula> arguments_with_zeros(Random& random)
{
    if constexpr (fits_together(formulas[static_cast<unsigned>(f)]))
        return random_arguments<f, formula>(static_cast<unsigned>(random.bits()));
    else
        return special_arguments<f, formula>(random);
}

template <FormulaIndex f, auto& formula> void check_zeros()
{
    const Quantity& result = formula_quantities[static_cast<unsigned>(f)].result;
    for (Random random : seeds(sampled(60))) {
        Arguments<formula> arguments = arguments_with_zeros<f, formula>(random);
        const auto with_zeros = [&](const auto& sign) {
            std::apply([&](auto&... argument) { (sign_zeros(argument, sign), ...); }, arguments);
            return std::apply(formula, arguments);
        };
        const auto expected = with_zeros([] { return 1.0; });
        auto negative = with_zeros([] { return -1.0; });
        choose_as(negative, expected, result);

        const auto& should = comparable(expected);
        const Tolerance tolerance = universal(should);
        require_close(comparable(negative), should, tolerance,
                      "all zeros of the arguments are negative, -0; the expected value is the "
                      "formula's own answer where they are positive");
        // A sum of products is -0 only if each of them is, so several choices of signs are tried.
        const int choices = fits_together(formulas[static_cast<unsigned>(f)]) ? 1 : 6;
        for (int choice = 0; choice < choices; ++choice) {
            auto mixed = with_zeros([&] { return random.uniform(-1, 1); });
            choose_as(mixed, expected, result);
            require_close(comparable(mixed), should, tolerance,
                          "some zeros of the arguments are negative, -0; the expected value is "
                          "the formula's own answer where all are positive");
        }
    }
}

struct Zeros {
    static constexpr const char* words = "does not ask for the sign of a zero";
    static constexpr bool holds_for(FormulaIndex f)
    {
        return !has_word(open_choices, name_of(f)) &&
               formulas[static_cast<unsigned>(f)].topic != "validation";
    }
    template <FormulaIndex f, auto& formula> static void check() { check_zeros<f, formula>(); }
};

[[maybe_unused]] const bool added_zeros = add_law<Zeros>();

} // namespace

} // namespace rigor::testing
