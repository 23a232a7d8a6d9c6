// SPDX-License-Identifier: MIT
// A value as a sequence of numbers, with their names and a text for people. Values are doubles,
// integers, bools, fixed Eigen matrices, the plain structs of formulas/fields.hpp, and optionals,
// arrays and vectors of these. Names are made only for the numbers that are reported, since lists
// may have a million elements.
#pragma once

#include "formulas/fields.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rigor::testing {

/// Where a part lies in a value: a field or an element of another part.
struct Place {
    const Place* outer = nullptr; // null: the whole value
    std::string_view field;       // empty: an element
    std::size_t index = 0;        // the number of this element
    std::string text() const;     // "contacts[2].normal"
};

/// A number, a vector or a matrix, by columns.
struct NumberBlock {
    const double* data;
    int rows, columns;
    int size() const { return rows * columns; }
};

template <class T> struct IsOptional : std::false_type {
};
template <class T> struct IsOptional<std::optional<T>> : std::true_type {
};

/// Walks through a value: visitor.block(place, block) for each number, vector and matrix,
/// visitor.size(n) before the elements of a list, visitor.presence(is_present) for an optional.
template <class T, class Visitor>
void walk_through(const T& value, const Place& place, Visitor& visitor)
{
    if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view name, const auto& field) {
            walk_through(field, {&place, name, 0}, visitor);
        });
    } else if constexpr (IsOptional<T>::value) {
        visitor.presence(value.has_value());
        if (value) walk_through(*value, place, visitor);
    } else if constexpr (std::is_arithmetic_v<T>) {
        const double number = static_cast<double>(value);
        visitor.block(place, NumberBlock{&number, 1, 1});
    } else if constexpr (requires { value.colPivHouseholderQr(); }) {
        const auto& matrix = value.eval();
        visitor.block(place, NumberBlock{matrix.data(), static_cast<int>(matrix.rows()),
                                         static_cast<int>(matrix.cols())});
    } else {
        visitor.size(value.size());
        for (std::size_t i = 0; i < value.size(); ++i)
            walk_through(value[i], {&place, {}, i}, visitor);
    }
}

/// The numbers of a value. An empty optional has none, and `shape` says so.
struct Components {
    std::vector<double> numbers;
    // sizes of vectors and presence of optionals, which must agree before numbers are compared
    std::string shape;

    /// The norm of the vector or matrix that number i belongs to, or the magnitude of the number.
    double scale(std::size_t i) const;

    void block(const Place&, const NumberBlock& block);
    void size(std::size_t n);
    void presence(bool is_present);

private:
    struct Block {
        std::size_t first, end;                  // its numbers
        mutable std::optional<double> norm = {}; // computed when it is first asked for
    };
    std::vector<Block> blocks_; // those of several numbers
};

template <class T> Components components(const T& value)
{
    Components parts;
    walk_through(value, {}, parts);
    return parts;
}

/// Finds the name of one number of a value.
struct ComponentName {
    std::size_t left; // numbers before the one that is sought
    std::string name;
    void block(const Place& place, const NumberBlock& block);
    void size(std::size_t) {}
    void presence(bool) {}
};

/// The name of number i of a value: "inertia(0, 1)".
template <class T> std::string component_name(const T& value, std::size_t i)
{
    ComponentName finder{i, {}};
    walk_through(value, {}, finder);
    return finder.name;
}

/// Writes a value, or its beginning if it is long.
struct ComponentText {
    std::string text;
    void block(const Place& place, const NumberBlock& block);
    void size(std::size_t) {}
    void presence(bool is_present);
};

/// A value to be read: vectors as (1, 2, 3), matrices by rows (1 2; 3 4).
template <class T> std::string component_text(const T& value)
{
    ComponentText writer;
    walk_through(value, {}, writer);
    return writer.text;
}

/// The numbers of a value, and the value to be read.
struct ReadableComponents {
    const Components& parts;
    std::string text;
};

} // namespace rigor::testing
