// SPDX-License-Identifier: MIT
// Finds in a value the first number that is NaN, infinite, or larger than a limit.
#pragma once

#include "worker/protocol/wire.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace rigor {

/// Without another limit, every finite number is accepted.
inline constexpr double any_magnitude = std::numeric_limits<double>::max();

/// What is wrong with a number: ` is NaN`, ` is 1e+200, beyond 1e+100`.
inline std::string fault_of_number(double number, double largest)
{
    if (std::isnan(number)) return " is NaN";
    if (std::isinf(number)) return number > 0 ? " is +infinity" : " is -infinity";
    char text[64];
    std::snprintf(text, sizeof text, " is %.3g, beyond %.0e", number, largest);
    return text;
}

/// Whether every number in `value` is finite and at most `largest` in magnitude.
template <class T> bool is_finite(const T& value, double largest = any_magnitude)
{
    if constexpr (std::is_floating_point_v<T>) {
        return std::abs(value) <= largest;
    } else if constexpr (wire::FixedMatrix<T>) {
        return (value.array().abs() <= largest).all();
    } else if constexpr (wire::is_array<T> || wire::is_vector<T>) {
        return std::all_of(value.begin(), value.end(),
                           [&](const auto& x) { return is_finite(x, largest); });
    } else if constexpr (wire::is_optional<T>) {
        return !value || is_finite(*value, largest);
    } else {
        bool all = true;
        if constexpr (Plain<T>)
            Fields<T>::each(value, [&](std::string_view, const auto& field) {
                all &= is_finite(field, largest);
            });
        return all;
    }
}

/// The first number in `value` that is not finite or larger than `largest`, named by the fields
/// that lead to it, such as `angular_momentum.y is NaN`. The result is empty if there is none.
template <class T>
std::string find_non_finite(const T& value, double largest = any_magnitude,
                            const std::string& path = "")
{
    std::string found;
    if constexpr (std::is_floating_point_v<T>) {
        if (!(std::abs(value) <= largest))
            found = (path.empty() ? "it" : path) + fault_of_number(value, largest);
    } else if constexpr (wire::FixedMatrix<T>) {
        for (int i = 0; i < value.size() && found.empty(); ++i) {
            if (std::abs(value.data()[i]) <= largest) continue;
            const int row = i % T::RowsAtCompileTime, column = i / T::RowsAtCompileTime;
            const std::string element =
                T::ColsAtCompileTime == 1 && T::RowsAtCompileTime == 3
                    ? std::string(path.empty() ? "its component " : ".") + "xyz"[row]
                    : std::string(path.empty() ? "its entry " : "") + "(" + std::to_string(row) +
                          ", " + std::to_string(column) + ")";
            found = path + element + fault_of_number(value.data()[i], largest);
        }
    } else if constexpr (wire::is_array<T> || wire::is_vector<T>) {
        for (std::size_t i = 0; i < value.size() && found.empty(); ++i)
            found = find_non_finite(value[i], largest, path + "[" + std::to_string(i) + "]");
    } else if constexpr (wire::is_optional<T>) {
        if (value) found = find_non_finite(*value, largest, path);
    } else if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view name, const auto& field) {
            if (!found.empty()) return;
            found = find_non_finite(field, largest,
                                    path + (path.empty() ? "" : ".") + std::string(name));
        });
    }
    return found;
}

} // namespace rigor
