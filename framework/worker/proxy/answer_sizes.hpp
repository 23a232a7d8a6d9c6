// SPDX-License-Identifier: MIT
// Checks the lengths of lists, the indices and the ranges in the answers of formulas. Tests and the
// engine use these numbers as indices into their own arrays, and pass them on to the reference, in
// processes that a student's code must not affect. So the proxy throws if an answer does not fit
// its arguments.
#pragma once

#include "deformable/fracture/checked_answers.hpp"
#include "formulas/table.hpp"
#include "worker/proxy/questions.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <tuple>

namespace rigor {

/// @throws std::out_of_range that names the formula, unless `found` is the expected number
inline void require_size(FormulaIndex formula, const char* what, std::size_t found,
                         std::size_t expected)
{
    if (found != expected)
        throw std::out_of_range(std::string(formulas[static_cast<unsigned>(formula)].name) +
                                " returned " + std::to_string(found) + " " + what + " where " +
                                std::to_string(expected) + " were expected");
}

/// @throws std::out_of_range unless each level is 0 … n, with n levels in all
inline void require_levels(const std::vector<int>& levels)
{
    const auto n = static_cast<int>(levels.size());
    for (int body = 0; body < n; ++body)
        if (levels[body] < 0 || levels[body] > n)
            throw std::out_of_range("contact_levels returned the level " +
                                    std::to_string(levels[body]) + " for body " +
                                    std::to_string(body) + " where 0 to " + std::to_string(n) +
                                    ", the number of bodies, was expected");
}

/// Checks an answer against the arguments of the call. An answer of fixed size, such as a number or
/// a matrix, always fits. @throws std::out_of_range
template <FormulaIndex formula, class Result, class... Argument>
void check_sizes(const Result& result, const Argument&... argument)
{
    using F = FormulaIndex;
    const auto arguments = std::tie(argument...);
    if constexpr (formula == F::resolve_contacts || formula == F::shock_propagation ||
                  formula == F::resolve_simultaneously) {
        require_size(formula, "bodies", result.bodies.size(), std::get<0>(arguments).size());
        require_size(formula, "impulses", result.impulses.size(), std::get<1>(arguments).size());
    } else if constexpr (formula == F::contact_levels) {
        require_size(formula, "levels", result.size(), std::get<1>(arguments).size());
        require_levels(result);
    } else if constexpr (formula == F::max_time_step) {
        if (result < 0)
            throw std::out_of_range(fmt::format(
                "max_time_step returned {:.3g} where a time above 0 was expected", result));
    } else if constexpr (formula == F::deepest_approaching_point) {
        const auto n = static_cast<long>(std::get<0>(arguments).size());
        if (result && (*result < 0 || *result >= n))
            throw std::out_of_range("deepest_approaching_point returned " +
                                    std::to_string(*result) + " for " + std::to_string(n) +
                                    " points");
    } else if constexpr (formula == F::smooth_stress) {
        checked_stresses(result, std::get<0>(arguments).size());
    } else if constexpr (formula == F::closest_face) {
        checked_face(result);
    } else if constexpr (formula == F::split_along_faces) {
        checked_split_along_faces(result, std::get<0>(arguments));
    } else if constexpr (formula == F::split_element) {
        checked_split_element(result, std::get<0>(arguments));
    } else if constexpr (formula == F::virtual_nodes) {
        checked_embedding(result, std::get<0>(arguments));
    } else if constexpr (std::is_same_v<Result, Judgement>) {
        check_judgement(formulas[static_cast<unsigned>(formula)].name, result, argument...);
    } else {
        constexpr bool is_list = requires
        {
            result.begin();
        }
        &&!requires
        {
            Result::SizeAtCompileTime;
        };
        static_assert(!is_list, "a formula with a list as its result needs a check of its size");
    }
}

} // namespace rigor
