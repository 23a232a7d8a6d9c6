// SPDX-License-Identifier: MIT
// The law of smoothness: near a special input most formulas change as they do farther away. A
// formula that takes what is nearly special for special (nearly at rest, nearly a quarter turn,
// nearly along the axis) does not change at all there. With inputs at -t, t, -T and T along one
// path, f(t) - f(-t) is t/T times f(T) - f(-T), but for terms of the third order.
#include "add_law.hpp"
#include "own_answers.hpp"
#include "special_arguments.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

#include <fmt/format.h>

namespace rigor::testing {

namespace {

// The formulas that have derivatives at all special inputs.
constexpr std::string_view smooth =
    "kinetic_energy cross_matrix world_point object_point angular_velocity point_velocity "
    "velocity_modes generalized_mass net_wrench equations_of_motion velocity_mode_rates "
    "inertial_wrench particle_mass_properties world_inertia world_inverse_inertia invert_moments "
    "solid_sphere solid_box solid_cylinder solid_ellipsoid thin_rod grid_mass_properties "
    "sampled_mass_properties combine advance_matrix gram_schmidt "
    "euler_to_matrix euler_rates multiply conjugate normalize rotate to_matrix quaternion_rate "
    "advance_exact advance_linear gravity_wrench step_symplectic_euler step_buss "
    "relative_velocity impulse_matrix frictionless_impulse static_friction_impulse apply_impulse "
    "deviator isotropic_stress yield_strain smooth_stress";
// Those that have derivatives wherever their result is not near 0.
constexpr std::string_view norms =
    "von_mises_principal von_mises_frobenius von_mises von_mises_from_strain";
constexpr double least_norm = 0.25; // the arguments are about 1

// The arguments at the distance t from special ones, along a path that `random` draws.
template <class Arguments>
Arguments arguments_at(double t, Arguments arguments, const FormulaQuantities& of, Random random)
{
    std::size_t k = 0;
    std::apply([&](auto&... one) { (nudge_argument(one, of.arguments[k++], t, random), ...); },
               arguments);
    return arguments;
}

// A distance T, and the allowed error of the result as a share of the change t of the arguments.
// The error is of the order of T², so a smaller T allows a smaller share. The random matrix with
// the worst condition that a formula inverts needs an eighth of the share.
struct Far {
    double T, share;
};

template <FormulaIndex f, auto& formula> void check_smoothness()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    int checked = 0;
    for (Random random : seeds(sampled(100))) {
        const Arguments<formula> arguments = special_arguments<f, formula>(random);
        const Random path(static_cast<unsigned>(random.bits()));
        const auto place = [&](double t) { return arguments_at(t, arguments, of, path); };
        const auto at = [&](double t) { return std::apply(formula, place(t)); };
        const auto change_over = [&](double T) {
            auto change = at(T);
            each_pair(change, at(-T), of.result, false,
                      [](auto& a, const auto& b, const Quantity&) { a -= b; });
            return change;
        };
        if constexpr (std::is_same_v<decltype(at(0)), double>)
            if (has_word(norms, name_of(f)) && at(0) < least_norm) continue;
        ++checked;
        constexpr Far fars[] = {{0x1p-13, 0x1p-4}, {0x1p-10, 0.5}};
        const decltype(at(0)) changes[] = {change_over(fars[0].T), change_over(fars[1].T)};
        // the smallest is twice `rounding`
        for (const double t : {0x1p-14, 0x1p-20, 0x1p-26, 0x1p-32, 0x1p-38, 0x1p-40}) {
            const auto before = at(-t), found = at(t);
            for (int i = 0; i < 2; ++i) {
                const double T = fars[i].T, share = fars[i].share;
                const double part = t / T;
                auto expected = before;
                each_pair(
                    expected, changes[i], of.result, false,
                    [&](auto& a, const auto& change, const Quantity&) { a += part * change; });
                require_predicted<formula>(
                    found, expected, Order(share * t + rounding),
                    [&] {
                        return std::vector{place(-t), place(t), place(-T), place(T)};
                    },
                    [&] {
                        return fmt::format(
                            "{} changes evenly: if each argument changes by {:.1g}, the result "
                            "changes by {:.1g} of what it changes for arguments that change by "
                            "{:.1g}",
                            name_of(f), 2 * t, part, 2 * T);
                    });
            }
        }
    }
    check_that(checked > 0,
               fmt::format("some result is at least {}, with arguments of about 1", least_norm));
}

struct Smoothness {
    static constexpr const char* words = "changes evenly near special values";
    static constexpr bool holds_for(FormulaIndex f)
    {
        return has_word(smooth, name_of(f)) || has_word(norms, name_of(f));
    }
    template <FormulaIndex f, auto& formula> static void check() { check_smoothness<f, formula>(); }
};

[[maybe_unused]] const bool added_smoothness = add_law<Smoothness>();

} // namespace

} // namespace rigor::testing
