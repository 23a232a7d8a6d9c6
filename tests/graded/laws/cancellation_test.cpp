// SPDX-License-Identifier: MIT
// The law of what is left: where the terms of a result cancel, what is left of them is as true as
// they are themselves. A formula that takes what is nearly 0 for 0, by comparing it with its terms,
// does not change at all there. The arguments move along a line through a place where a part of the
// result is 0; f(t) - f(-t) is t/T times f(T) - f(-T), but for terms of the third order.
#include "add_law.hpp"
#include "cancellation.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "own_answers.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"
#include "support/sweep.hpp"

#include <fmt/format.h>

namespace rigor::testing {

namespace {

// The formulas whose results can cancel, and have derivatives where they do.
constexpr std::string_view with_terms =
    "world_point object_point angular_velocity point_velocity velocity_modes generalized_mass "
    "net_wrench equations_of_motion velocity_mode_rates inertial_wrench particle_mass_properties "
    "world_inertia world_inverse_inertia grid_mass_properties sampled_mass_properties "
    "mesh_mass_properties combine advance_matrix gram_schmidt "
    "euler_rates multiply rotate quaternion_rate advance_exact advance_linear "
    "step_symplectic_euler step_buss relative_velocity impulse_matrix static_friction_impulse "
    "apply_impulse deviator isotropic_stress plastic_flow smooth_stress sample_level_set";

// Half the distance over which the slope is measured. Its square bounds what is not linear.
constexpr double far = 0x1p-16;

// The smallest slope of the part that is 0, with arguments and terms of about 1, that tells a
// result from one that does not change.
constexpr double least_slope = 0x1p-7;

// How many lines of arguments are checked, and how many are tried. A line takes a hundred calls.
constexpr int enough = 30, tries = 150;

/// A line of arguments through a place where a part of the result is 0.
template <FormulaIndex f, auto& formula> class Line {
public:
    using Result = decltype(std::apply(formula, std::declval<Arguments<formula>>()));

    explicit Line(Random& random)
    {
        const auto seed = static_cast<unsigned>(random.bits());
        const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
        if (one_in(2, random)) {
            arguments_ = special_arguments<f, formula>(random);
        } else {
            arguments_ = random_arguments<f, formula>(seed);
            if (f != FormulaIndex::euler_rates && f != FormulaIndex::static_friction_impulse)
                redraw_chosen(arguments_, of, {}, {}, true, random);
        }
        const Arguments<formula> unmoved = arguments_;
        const Result result = std::apply(formula, unmoved);
        scale_ = 1 + largest_of(components(result).numbers);
        target_ = draw_target(result, random);
        is_relative_ = one_in(4, random);
        for (int attempt = 0; attempt < 6 && !is_usable_ && !target_.empty(); ++attempt) {
            arguments_ = unmoved;
            movables_ = draw_movables(arguments_, of, random);
            if (!move_to_zero(movables_, target_, [&] { return aimed_at(); })) continue;
            middle_.clear();
            direction_.clear();
            for (const Movable& movable : movables_) {
                middle_.push_back(*movable.number);
                direction_.push_back(random.uniform(-1, 1));
            }
            is_usable_ = is_allowed(-far) && is_allowed(far) && is_smooth();
        }
    }

    bool is_usable() const { return is_usable_; }
    double scale() const { return scale_; }

    /// The arguments at the distance t from the middle.
    const Arguments<formula>& arguments_at(double t)
    {
        move(t);
        return arguments_;
    }
    Result at(double t) { return std::apply(formula, arguments_at(t)); }

    /// f(T) - f(-T).
    Result change_over(double T)
    {
        Result change = at(T);
        each_pair(change, at(-T), formula_quantities[static_cast<unsigned>(f)].result, false,
                  [](auto& a, const auto& b, const Quantity&) { a -= b; });
        return change;
    }

private:
    static double largest_of(const Numbers& numbers)
    {
        double largest = 0;
        for (double number : numbers)
            largest = std::max(largest, std::abs(number));
        return largest;
    }

    // The numbers of which some shall become 0: those of the result, or of its difference from the
    // first argument, such as the state before a step. None if the arguments are not allowed.
    Numbers aimed_at() const
    {
        if (!are_allowed()) return {};
        Numbers numbers = components(std::apply(formula, arguments_)).numbers;
        if constexpr (std::is_same_v<std::tuple_element_t<0, Arguments<formula>>, Result>)
            if (is_relative_) {
                const Numbers before = components(std::get<0>(arguments_)).numbers;
                for (std::size_t i = 0; i < std::min(numbers.size(), before.size()); ++i)
                    numbers[i] -= before[i];
            }
        return numbers;
    }

    void move(double t)
    {
        for (std::size_t i = 0; i < movables_.size(); ++i)
            movables_[i].set(middle_[i] + t * direction_[i]);
    }

    bool is_allowed(double t)
    {
        move(t);
        return are_allowed();
    }

    bool are_allowed() const
    {
        if (!broken_preconditions<f>(arguments_).empty()) return false;
        if constexpr (f == FormulaIndex::static_friction_impulse) // bodies that approach
            return std::get<1>(arguments_).dot(std::get<2>(arguments_)) < -0x1p-6;
        if constexpr (f == FormulaIndex::mesh_mass_properties) // whose center is divided by V
            return std::abs(signed_volume(std::get<0>(arguments_))) > 0x1p-6;
        return true;
    }

    // Whether the part that is 0 in the middle changes along the line, and all results do so as
    // a smooth function does: on both sides alike, and half as far, half as much.
    bool is_smooth()
    {
        const Numbers middle = components(at(0)).numbers, end = components(at(far)).numbers,
                      whole = components(change_over(far)).numbers,
                      half = components(change_over(far / 2)).numbers;
        if (end.size() != middle.size() || whole.size() != middle.size() ||
            half.size() != middle.size())
            return false;
        scale_ = std::max(scale_, 1 + largest_of(middle));
        scale_ += largest_of(whole) / (2 * far) * largest_of(middle_); // terms of the moved numbers
        for (std::size_t i = 0; i < middle.size(); ++i) {
            const double bend = 2 * (end[i] - middle[i]) - whole[i], jerk = whole[i] - 2 * half[i];
            if (!(std::abs(bend) <= 0x1p-8 * far * scale_)) return false;
            if (!(std::abs(jerk) <= 0x1p-17 * far * scale_)) return false;
        }
        return chosen(whole, target_).template lpNorm<Eigen::Infinity>() >=
               2 * far * least_slope * scale_;
    }

    Arguments<formula> arguments_;
    Movables movables_;
    std::vector<std::size_t> target_;
    std::vector<double> middle_, direction_;
    double scale_ = 1;
    bool is_usable_ = false, is_relative_ = false;
};

template <FormulaIndex f, auto& formula> void check_what_is_left()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    int lines = 0;
    for (Random random : seeds(sampled(tries))) {
        Line<f, formula> line(random);
        if (!line.is_usable()) continue;
        if (++lines > enough) break;
        const auto change = line.change_over(far);
        for (const double t : {0x1p-24, 0x1p-30, 0x1p-36, 0x1p-39, 0x1p-41}) {
            const double part = t / far;
            auto expected = line.at(-t);
            const auto found = line.at(t);
            each_pair(expected, change, of.result, false,
                      [&](auto& a, const auto& all, const Quantity&) { a += part * all; });
            require_predicted<formula>(
                found, expected, Order((0x1p-12 * t + 0x1p-45) * line.scale()),
                [&] {
                    return std::vector{line.arguments_at(-t), line.arguments_at(t),
                                       line.arguments_at(-far), line.arguments_at(far)};
                },
                [&] {
                    return fmt::format(
                        "a part of the result of {} is nearly 0, since its terms cancel: if "
                        "the arguments change by {:.1g}, the result changes by {:.1g} of what "
                        "it changes for arguments that change by {:.1g}",
                        name_of(f), 2 * t, part, 2 * far);
                });
        }
    }
    check_that(lines > 0, "the result changes with its arguments where its terms cancel");
}

struct WhatIsLeft {
    static constexpr const char* words = "keeps what is left of terms that cancel";
    static constexpr bool holds_for(FormulaIndex f) { return has_word(with_terms, name_of(f)); }
    template <FormulaIndex f, auto& formula> static void check()
    {
        check_what_is_left<f, formula>();
    }
};

[[maybe_unused]] const bool added_what_is_left = add_law<WhatIsLeft>();

} // namespace

} // namespace rigor::testing
