// SPDX-License-Identifier: MIT
// The law of continuity: most formulas have no special values, so the result at a special input is
// the limit of the results nearby. A formula that is wrong at special inputs alone would otherwise
// keep its points.
#include "add_law.hpp"
#include "own_answers.hpp"
#include "special_arguments.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

namespace rigor::testing {

namespace {

// The formulas that are continuous at all special inputs that special_arguments.hpp draws. The
// others jump or become infinite by their definition: where sliding begins, between cells, where
// eigenvalues change their order, where ω is 0.
constexpr std::string_view continuous =
    "kinetic_energy cross_matrix world_point object_point angular_velocity point_velocity "
    "velocity_modes generalized_mass net_wrench equations_of_motion velocity_mode_rates "
    "inertial_wrench particle_mass_properties world_inertia world_inverse_inertia invert_moments "
    "solid_sphere solid_box solid_cylinder solid_ellipsoid thin_rod grid_mass_properties "
    "sampled_mass_properties combine bounding_box_mass_properties advance_matrix gram_schmidt "
    "euler_to_matrix euler_rates multiply conjugate normalize rotate to_matrix quaternion_rate "
    "advance_exact advance_linear gravity_wrench step_symplectic_euler step_buss sample_level_set "
    "relative_velocity impulse_matrix frictionless_impulse static_friction_impulse apply_impulse "
    "deviator von_mises_principal von_mises_frobenius von_mises isotropic_stress "
    "von_mises_from_strain yield_strain plastic_flow smooth_stress";

// Compares the result at special arguments with that at arguments beside them.
// @param changes  how far these are away, one after the other
template <FormulaIndex f, auto& formula>
void check_limits(std::initializer_list<double> changes, Random& random)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    const Arguments<formula> arguments = special_arguments<f, formula>(random);
    const auto found = std::apply(formula, arguments);
    for (const double t : changes) {
        Arguments<formula> nearby = arguments;
        std::size_t k = 0;
        std::apply([&](auto&... one) { (nudge_argument(one, of.arguments[k++], t, random), ...); },
                   nearby);
        const auto limit = std::apply(formula, nearby);

        require_predicted<formula>(
            found, limit, Order(2048 * t + rounding),
            [&] {
                return std::vector{arguments, nearby};
            },
            [&] {
                return fmt::format("{} has no special values: if each argument changes by about "
                                   "{:.1g}, the result may change by no more than some multiple "
                                   "of that",
                                   name_of(f), t);
            });
    }
}

// How many numbers the arguments of a formula have.
template <FormulaIndex f, auto& formula> int count_of_numbers()
{
    Random random(first_seed());
    std::size_t count = 0;
    std::apply([&](const auto&... one) { ((count += components(one).numbers.size()), ...); },
               special_arguments<f, formula>(random));
    return static_cast<int>(count);
}

template <FormulaIndex f, auto& formula> void check_continuity()
{
    // The two smallest change only what is 0: to a number whose square is no double, and to one
    // that has few digits itself.
    for (Random random : seeds(sampled(150)))
        check_limits<f, formula>({0x1p-1060, 0x1p-530, 0x1p-32, 0x1p-22, 0x1p-14}, random);
    // Where two or three things are special at the same time, any change shows it. The more numbers
    // there are, the more of them may be special together.
    const int many = std::min(2000, 150 * count_of_numbers<f, formula>());
    for (unsigned seed : seeds(sampled(many))) {
        Random random(seed + 150);
        check_limits<f, formula>({0x1p-32}, random);
    }
}

struct Continuity {
    static constexpr const char* words = "has no special values";
    static constexpr bool holds_for(FormulaIndex f) { return has_word(continuous, name_of(f)); }
    template <FormulaIndex f, auto& formula> static void check() { check_continuity<f, formula>(); }
};

[[maybe_unused]] const bool added_continuity = add_law<Continuity>();

} // namespace

} // namespace rigor::testing
