// SPDX-License-Identifier: MIT
// The law of superposition: many results are affine in some arguments together, f((1-t) a + t b) =
// (1-t) f(a) + t f(b), such as the energy in the mass and the inertia. The arguments a and b are
// drawn from all strata (the classes of special values in strata.hpp), and t = 2^-k may be tiny. So
// (1-t) a + t b is often nearly a special case: nearly a rod, nearly at rest, nearly at the center.
// A formula that takes it for the special case, or that ignores a small part beside a large one,
// breaks the law.
#include "add_law.hpp"
#include "own_answers.hpp"
#include "strata.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

#include <fmt/format.h>

namespace rigor::testing {

namespace {

// Turns "mass I_inverse" into a list for people, "mass and I_inverse".
std::string listed(std::string_view names)
{
    std::string text(names);
    for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 5))
        text.replace(at, 1, " and ");
    return text;
}

/// A formula, and those of its arguments in which it is affine together.
struct Affine {
    std::string_view formula, arguments;
};

// One row for each set of arguments, by their names in the table of formulas. In a struct only
// those fields vary that are not fixed (`is_fixed`), such as velocities, forces and masses of
// points.
constexpr Affine affine[] = {
    {"kinetic_energy", "mass inertia"},
    {"cross_matrix", "w"},
    {"world_point", "X p"},
    {"object_point", "X x"},
    {"angular_velocity", "R_dot"},
    {"point_velocity", "V omega"},
    {"point_velocity", "V X x"},
    {"velocity_modes", "X x"},
    {"generalized_mass", "particles"},
    {"net_wrench", "forces"},
    {"equations_of_motion", "state wrench"},
    {"equations_of_motion", "inverse_mass I_inverse"},
    {"velocity_mode_rates", "V v"},
    {"inertial_wrench", "particles"},
    {"world_inertia", "I_body"},
    {"world_inverse_inertia", "I_body_inverse"},
    {"solid_sphere", "density"},
    {"solid_box", "density"},
    {"solid_cylinder", "density"},
    {"solid_ellipsoid", "density"},
    {"thin_rod", "line_density"},
    {"advance_matrix", "omega"},
    {"advance_matrix", "time_step"},
    {"euler_rates", "omega"},
    {"multiply", "a"},
    {"multiply", "b"},
    {"conjugate", "q"},
    {"rotate", "p"},
    {"quaternion_rate", "omega"},
    {"gravity_wrench", "mass"},
    {"gravity_wrench", "gravity"},
    {"relative_velocity", "body1 body2"},
    {"impulse_matrix", "inverse_mass I_inverse"},
    {"frictionless_impulse", "v"},
    {"static_friction_impulse", "v"},
    {"apply_impulse", "body j"},
    {"deviator", "stress"},
    {"isotropic_stress", "strain"},
    {"isotropic_stress", "lame_lambda shear_modulus"},
    {"von_mises_from_strain", "shear_modulus"},
    {"yield_strain", "yield_stress"},
    {"plastic_flow", "plastic_strain"},
    {"smooth_stress", "stresses"},
};

// Whether every name above is that of a formula or of one of its arguments.
constexpr bool names_are_known()
{
    for (const Affine& row : affine) {
        const Formula* formula = nullptr;
        for (const Formula& each : formulas)
            if (each.name == row.formula) formula = &each;
        if (!formula) return false;
        for (std::size_t i = 0; !nth_word(row.arguments, i).empty(); ++i)
            if (!has_word(formula->arguments, nth_word(row.arguments, i))) return false;
    }
    return true;
}
static_assert(names_are_known());

// a ← (1-t) a + t b
template <class T> void blend(T& a, const T& b, const Quantity& q, bool without_fixed, double t)
{
    each_pair(a, b, q, without_fixed,
              [t](auto& x, const auto& y, const Quantity&) { x = (1 - t) * x + t * y; });
}

template <class Arguments, std::size_t... i>
void blend_chosen(Arguments& a, const Arguments& b, const FormulaQuantities& of,
                  std::string_view names, std::string_view chosen, double t,
                  std::index_sequence<i...>)
{
    const auto one = [&](auto& x, const auto& y, std::size_t k) {
        if (has_word(chosen, nth_word(names, k))) blend(x, y, of.arguments[k], true, t);
    };
    (one(std::get<i>(a), std::get<i>(b), i), ...);
}

// The rounding of some operations; where a formula divides by K, magnified by its condition, and
// near gimbal lock by the nearness.
Tolerance of_superposition(FormulaIndex f, double scale)
{
    const bool divides = f == FormulaIndex::frictionless_impulse ||
                         f == FormulaIndex::static_friction_impulse ||
                         f == FormulaIndex::euler_rates;
    return Rounding(divides ? 1 << 14 : 1 << 7, scale);
}

double largest_number(const Components& parts)
{
    double largest = 0;
    for (double number : parts.numbers)
        if (std::isfinite(number)) largest = std::max(largest, std::abs(number));
    return largest;
}

template <FormulaIndex f, auto& formula> void check_affine(const Affine& row)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    const std::string_view names = formulas[static_cast<unsigned>(f)].arguments;
    constexpr auto all = std::make_index_sequence<std::tuple_size_v<Arguments<formula>>>();
    for (unsigned seed : seeds(sampled(150))) {
        Random random(seed + 9000);
        Arguments<formula> a = random_arguments<f, formula>(seed);
        if (f != FormulaIndex::euler_rates && seed % 3 != 0) // its angles may be at gimbal lock
            redraw_chosen(a, of, names, row.arguments, true, random);
        Arguments<formula> b = a;
        redraw_chosen(a, of, names, row.arguments, false, random);
        redraw_chosen(b, of, names, row.arguments, false, random);
        const int k =
            random.bits() % 2 == 0 ? 1 + random_index(random, 16) : 24 + random_index(random, 17);
        const double t = std::ldexp(1, -k);
        Arguments<formula> between = a;
        blend_chosen(between, b, of, names, row.arguments, t, all);

        auto expected = std::apply(formula, a);
        const auto of_b = std::apply(formula, b);
        const double scale = 1 + largest_number(components(expected)) + // inputs are about 1
                             t * largest_number(components(of_b));
        blend(expected, of_b, of.result, false, t);
        const auto found = std::apply(formula, between);

        require_predicted<formula>(
            found, expected, of_superposition(f, scale),
            [&] {
                return std::vector{a, b, between};
            },
            [&] {
                return fmt::format(
                    "{} is affine in {}: the result for (1-t) a + t b is (1-t) times that for "
                    "a plus t times that for b, here with t = {:.3g}",
                    row.formula, listed(row.arguments), t);
            });
    }
}

template <FormulaIndex f, auto& formula> void check_all_affine()
{
    for (const Affine& row : affine)
        if (row.formula == name_of(f)) check_affine<f, formula>(row);
}

constexpr bool is_affine(FormulaIndex f)
{
    for (const Affine& row : affine)
        if (row.formula == name_of(f)) return true;
    return false;
}

struct Superposition {
    static constexpr const char* words = "adds up small and large parts";
    static constexpr bool holds_for(FormulaIndex f) { return is_affine(f); }
    template <FormulaIndex f, auto& formula> static void check() { check_all_affine<f, formula>(); }
};

[[maybe_unused]] const bool added_superposition = add_law<Superposition>();

} // namespace

} // namespace rigor::testing
