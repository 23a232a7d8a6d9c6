// SPDX-License-Identifier: MIT
// Finds in a value the first number that is NaN or infinite.
#pragma once

#include "worker/protocol/wire.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rigor {

inline std::string name_of_non_finite(double number)
{
    return std::isnan(number) ? " is NaN" : number > 0 ? " is +infinity" : " is -infinity";
}

/// Whether every number in `value` is finite.
template <class T> bool is_finite(const T& value)
{
    if constexpr (std::is_floating_point_v<T>) {
        return std::isfinite(value);
    } else if constexpr (wire::FixedMatrix<T>) {
        return value.allFinite();
    } else if constexpr (wire::is_array<T> || wire::is_vector<T>) {
        return std::all_of(value.begin(), value.end(), [](const auto& x) { return is_finite(x); });
    } else if constexpr (wire::is_optional<T>) {
        return !value || is_finite(*value);
    } else {
        bool all = true;
        if constexpr (Plain<T>)
            Fields<T>::each(value,
                            [&](std::string_view, const auto& field) { all &= is_finite(field); });
        return all;
    }
}

/// The first number in `value` that is not finite, named by the fields that lead to it, such as
/// `angular_momentum.y is NaN`. The result is empty if all numbers are finite.
template <class T> std::string find_non_finite(const T& value, const std::string& path = "")
{
    std::string found;
    if constexpr (std::is_floating_point_v<T>) {
        if (!std::isfinite(value)) found = (path.empty() ? "it" : path) + name_of_non_finite(value);
    } else if constexpr (wire::FixedMatrix<T>) {
        for (int i = 0; i < value.size() && found.empty(); ++i) {
            if (std::isfinite(value.data()[i])) continue;
            const int row = i % T::RowsAtCompileTime, column = i / T::RowsAtCompileTime;
            const std::string element =
                T::ColsAtCompileTime == 1 && T::RowsAtCompileTime == 3
                    ? std::string(path.empty() ? "its component " : ".") + "xyz"[row]
                    : std::string(path.empty() ? "its entry " : "") + "(" + std::to_string(row) +
                          ", " + std::to_string(column) + ")";
            found = path + element + name_of_non_finite(value.data()[i]);
        }
    } else if constexpr (wire::is_array<T> || wire::is_vector<T>) {
        for (std::size_t i = 0; i < value.size() && found.empty(); ++i)
            found = find_non_finite(value[i], path + "[" + std::to_string(i) + "]");
    } else if constexpr (wire::is_optional<T>) {
        if (value) found = find_non_finite(*value, path);
    } else if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view name, const auto& field) {
            if (!found.empty()) return;
            found = find_non_finite(field, path + (path.empty() ? "" : ".") + std::string(name));
        });
    }
    return found;
}

} // namespace rigor
