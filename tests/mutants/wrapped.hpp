// SPDX-License-Identifier: MIT
// Wrong solutions around a correct formula: an argument or the result is changed, an answer is
// remembered, or the formula returns early. The generated sources call these templates.
#pragma once

#include "formulas/fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

namespace rigor::mutants {

/// The number of the mutant of this source that runs, or 0 for the unchanged formulas. It stands in
/// the environment, RIGOR_MUTANT="stem number".
inline int chosen_of(const char* stem)
{
    const char* text = std::getenv("RIGOR_MUTANT");
    const std::size_t length = std::strlen(stem);
    if (!text || std::strncmp(text, stem, length) != 0 || text[length] != ' ') return 0;
    return std::atoi(text + length);
}

/// What is changed in a value.
enum class Change {
    in_float,     // rounded to single precision
    shifted,      // larger by the fraction `bound`
    absolute,     // without a sign
    not_negative, // at least 0
    negated,
    clamped,    // between -bound and bound
    cut,        // 0 if smaller than `bound`
    transposed, // the rest is for matrices
    diagonal,
    symmetric,
    without_last, // the rest is for lists
    without_first,
    at_most, // `bound` elements, or the number `bound`
    next     // an integer that is larger by `bound`
};

inline double changed(double x, Change change, double bound)
{
    switch (change) {
    case Change::in_float:
        return static_cast<float>(x);
    case Change::shifted:
        return x * (1 + bound);
    case Change::absolute:
        return std::abs(x);
    case Change::not_negative:
        return std::max(x, 0.0);
    case Change::negated:
        return -x;
    case Change::clamped:
        return std::clamp(x, -bound, bound);
    case Change::cut:
        return std::abs(x) < bound ? 0 : x;
    default:
        return x;
    }
}

template <class T> constexpr bool is_optional = false;
template <class T> constexpr bool is_optional<std::optional<T>> = true;

template <class Matrix> void apply_to_matrix(Matrix& A, Change change, double bound)
{
    if constexpr (Matrix::RowsAtCompileTime == Matrix::ColsAtCompileTime) {
        if (change == Change::transposed) A = A.transpose().eval();
        if (change == Change::diagonal) A = Matrix(A.diagonal().asDiagonal());
        if (change == Change::symmetric) A = ((A + A.transpose()) / 2).eval();
    }
    for (Eigen::Index i = 0; i < A.size(); ++i)
        A(i) = changed(A(i), change, bound);
}

template <class T> void apply(T& value, Change change, double bound)
{
    if constexpr (std::is_floating_point_v<T>) {
        value = changed(value, change, bound);
    } else if constexpr (std::is_same_v<T, int>) {
        if (change == Change::at_most) value = std::min(value, static_cast<int>(bound));
        if (change == Change::next) value += static_cast<int>(bound);
    } else if constexpr (std::is_same_v<T, bool>) {
        if (change == Change::negated) value = !value;
    } else if constexpr (is_optional<T>) {
        if (value) apply(*value, change, bound);
    } else if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view, auto& field) { apply(field, change, bound); });
    } else if constexpr (requires { value.colPivHouseholderQr(); }) {
        apply_to_matrix(value, change, bound);
    } else if constexpr (requires {
                             value.resize(1);
                             value.pop_back();
                         }) {
        const auto n = static_cast<double>(value.size());
        if (change == Change::without_last && n > 0) value.pop_back();
        if (change == Change::without_first && n > 0) value.erase(value.begin());
        if (change == Change::at_most && n > bound) value.resize(static_cast<std::size_t>(bound));
        if constexpr (!std::is_same_v<T, std::vector<bool>>)
            if (change < Change::without_last)
                for (auto& element : value)
                    apply(element, change, bound);
    } else {
        for (auto& element : value)
            apply(element, change, bound);
    }
}

/// All numbers of a value, in order.
template <class T> void append_numbers(std::vector<double>& numbers, const T& value)
{
    if constexpr (std::is_arithmetic_v<T>) {
        numbers.push_back(static_cast<double>(value));
    } else if constexpr (is_optional<T>) {
        if (value) append_numbers(numbers, *value);
    } else if constexpr (Plain<T>) {
        Fields<T>::each(
            value, [&](std::string_view, const auto& field) { append_numbers(numbers, field); });
    } else if constexpr (requires { value.colPivHouseholderQr(); }) {
        numbers.insert(numbers.end(), value.data(), value.data() + value.size());
    } else {
        for (const auto& element : value)
            append_numbers(numbers, static_cast<std::remove_cvref_t<decltype(value[0])>>(element));
    }
}

/// The formula with argument i changed.
template <std::size_t i, class Formula, class... Argument>
auto with_argument(Formula* formula, Change change, double bound, const Argument&... argument)
{
    std::tuple<Argument...> arguments(argument...);
    apply(std::get<i>(arguments), change, bound);
    return std::apply(formula, arguments);
}

/// The formula with its result changed.
template <class Formula, class... Argument>
auto with_result(Formula* formula, Change change, double bound, const Argument&... argument)
{
    auto result = formula(argument...);
    apply(result, change, bound);
    return result;
}

/// An early return, of zero, if all numbers of argument i are below `bound` (or one is above it,
/// for `is_upper`).
template <std::size_t i, class Formula, class... Argument>
auto guarded(Formula* formula, bool is_upper, double bound, const Argument&... argument)
{
    std::vector<double> numbers;
    append_numbers(numbers, std::get<i>(std::tie(argument...)));
    double largest = 0;
    for (const double number : numbers)
        largest = std::max(largest, std::abs(number));
    if (is_upper ? largest > bound : largest < bound) return decltype(formula(argument...)){};
    return formula(argument...);
}

/// An early return, of zero, if argument i is a list of more than `bound` elements.
template <std::size_t i, class Formula, class... Argument>
auto limited(Formula* formula, double bound, const Argument&... argument)
{
    if (static_cast<double>(std::get<i>(std::tie(argument...)).size()) > bound)
        return decltype(formula(argument...)){};
    return formula(argument...);
}

/// The formula gives its last answer again if no argument but the i-th has changed.
template <std::size_t i, class Formula, class... Argument>
auto remembered(Formula* formula, const Argument&... argument)
{
    static std::vector<double> last;
    static std::optional<decltype(formula(argument...))> answer;
    std::vector<double> now;
    const auto append = [&, k = std::size_t{0}](const auto& value) mutable {
        if (k++ != i) append_numbers(now, value);
    };
    auto appending = append;
    (appending(argument), ...);
    if (!answer || now != last) {
        last = now;
        answer.emplace(formula(argument...));
    }
    return *answer;
}

} // namespace rigor::mutants
