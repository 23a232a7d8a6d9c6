// SPDX-License-Identifier: MIT
// Values of the contract without their types: a list of numbers, and a description of what each of
// them is. The search for the cause of a wrong answer works on these, so that its code is compiled
// once and not for each formula.
#pragma once

#include "formulas/quantities.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace rigor::diagnosis {

/// What a value consists of. Real numbers, integers, booleans and quaternions are leaves.
enum class Form { real, integer, boolean, quaternion, record, list, array, optional };

/// How the values of a type are encoded (worker/protocol/wire.hpp).
struct Encoding {
    Form form = Form::record;
    Quantity quantity;
    int rows = 1, columns = 1;      // size of a leaf
    std::size_t size = 0;           // elements of an array
    std::vector<std::string> names; // names of the fields of a record
    std::vector<Encoding> parts;    // the fields, or the one kind of element
    int role = -1;                  // index of a leaf in Layout::roles
};

/// One place in values of a type. All elements of a list share their places.
struct Role {
    std::string name; // "body.position", "contacts[i].normal"
    Quantity quantity;
    Form form = Form::real;
    int rows = 1, columns = 1;
    bool in_list = false;

    int size() const { return rows * columns; }
    bool is_scalar() const { return form == Form::real && size() == 1; }
    bool is_vector() const { return form == Form::real && rows == 3 && columns == 1; }
    bool is_matrix() const { return form == Form::real && rows == columns && rows > 1; }
    bool same_shape(const Role& other) const
    {
        return form == other.form && rows == other.rows && columns == other.columns;
    }
};

/// The numbers of one place in a value.
struct Leaf {
    int role = 0;
    std::size_t at = 0; // index of its first number
};

struct Value {
    std::vector<double> numbers;
    std::vector<Leaf> leaves;
    std::vector<std::uint64_t> sizes; // lengths of lists, and 0 or 1 for optionals, in their order

    std::span<double> of(const Leaf& leaf, const Role& role)
    {
        return std::span(numbers).subspan(leaf.at, static_cast<std::size_t>(role.size()));
    }
    std::span<const double> of(const Leaf& leaf, const Role& role) const
    {
        return std::span(numbers).subspan(leaf.at, static_cast<std::size_t>(role.size()));
    }
    bool operator==(const Value& other) const
    {
        return numbers == other.numbers && sizes == other.sizes;
    }
};

using Bytes = std::vector<std::byte>;

/// The numbers of a leaf, to be read or to be changed.
using Numbers = std::span<const double>;
using Changeable = std::span<double>;

/// A type: its encoding and its places.
struct Layout {
    Encoding encoding;
    std::vector<Role> roles;

    /// @param name  of the value; empty for an answer
    explicit Layout(Encoding type, const std::string& name = "");
    /// @throws wire::Malformed
    Value decode(std::span<const std::byte> bytes) const;
    /// The encoding of a value of this type, with as many elements as its sizes say.
    Bytes encode(const Value& value) const;
    /// All leaves of one place.
    std::vector<Leaf> leaves(const Value& value, int role) const;
};

/// The encoding of T, whose quantity is q.
template <class T> Encoding encoding_of(const Quantity& q)
{
    Encoding result;
    result.quantity = q;
    const auto of_element = [&]<class Element>(std::type_identity<Element>, Form form) {
        result.form = form;
        result.parts = {encoding_of<Element>(q)};
    };
    if constexpr (std::is_same_v<T, Quaternion>) {
        result.form = Form::quaternion;
        result.rows = 4;
    } else if constexpr (std::is_same_v<T, bool>) {
        result.form = Form::boolean;
    } else if constexpr (std::is_same_v<T, double>) {
        result.form = Form::real;
    } else if constexpr (std::is_same_v<T, int>) {
        result.form = Form::integer;
    } else if constexpr (Plain<T>) {
        const Quantity* of = FieldQuantities<T>::of;
        T prototype;
        Fields<T>::each(prototype, [&](std::string_view name, auto& field) {
            const Quantity inner = {of->dimension * q.dimension, of->kind};
            result.names.emplace_back(name);
            result.parts.push_back(encoding_of<std::remove_cvref_t<decltype(field)>>(inner));
            ++of;
        });
    } else if constexpr (requires { T::RowsAtCompileTime; }) {
        result.form = Form::real;
        result.rows = T::RowsAtCompileTime;
        result.columns = T::ColsAtCompileTime;
    } else if constexpr (requires { std::tuple_size<T>::value; }) {
        of_element(std::type_identity<typename T::value_type>(), Form::array);
        result.size = std::tuple_size_v<T>;
    } else if constexpr (requires(T value) { value.has_value(); }) {
        of_element(std::type_identity<typename T::value_type>(), Form::optional);
    } else {
        of_element(std::type_identity<typename T::value_type>(), Form::list);
    }
    return result;
}

} // namespace rigor::diagnosis
