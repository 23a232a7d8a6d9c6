// SPDX-License-Identifier: MIT
// Calls of formulas as C++ to paste: `impulse_matrix(0.5, Matrix3d{{1, 0, 0}, …}, {0, 0, 0}, …)`.
// Numbers are written so that they read back as the same bits.
#pragma once

#include "formulas/fields.hpp"

#include <fmt/format.h>

#include <string>
#include <tuple>
#include <type_traits>

namespace rigor::testing {

/// Adds `value` to `text`. Structs and vectors are in braces without a type, since the type follows
/// from the parameter.
template <class T> void write_cpp(const T& value, std::string& text)
{
    [[maybe_unused]] auto separate = [&text, is_first = true]() mutable {
        if (!is_first) text += ", ";
        is_first = false;
    };
    if constexpr (std::is_same_v<T, bool>) {
        text += value ? "true" : "false";
    } else if constexpr (std::is_arithmetic_v<T>) {
        text += fmt::format("{}", value);
    } else if constexpr (Plain<T>) {
        text += "{";
        Fields<T>::each(value, [&](std::string_view, const auto& field) {
            separate();
            write_cpp(field, text);
        });
        text += "}";
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        text += "Matrix3d{"; // its constructor from rows is explicit
        for (int row = 0; row < 3; ++row) {
            separate();
            write_cpp(Vector3d(value.row(row)), text);
        }
        text += "}";
    } else {
        text += "{";
        for (const auto& element : value) {
            separate();
            write_cpp(static_cast<typename T::value_type>(element), text);
        }
        text += "}";
    }
}

/// The call of the formula `name` with these arguments.
template <class... Argument>
std::string call_text(std::string_view name, const std::tuple<Argument...>& arguments)
{
    std::string text(name);
    text += "(";
    std::apply(
        [&](const auto&... argument) {
            auto write = [&, is_first = true](const auto& value) mutable {
                if (!is_first) text += ", ";
                is_first = false;
                write_cpp(value, text);
            };
            (write(argument), ...);
        },
        arguments);
    return text + ")";
}

} // namespace rigor::testing
