// SPDX-License-Identifier: MIT
// Strata: the classes of special values among which an argument is drawn, such as zero, along an
// axis, or the inertia of a rod. Ordinary random values are almost never special, so a special case
// that a formula treats wrongly would hide from them.
#pragma once

#include "change.hpp"
#include "inputs.hpp"

#include <array>
#include <utility>

namespace rigor::testing {

enum class Stratum {
    ordinary,
    zero,
    aligned,   // a vector along an axis; a diagonal matrix; no turn
    equal,     // a vector or a diagonal matrix whose entries are equal: a ball; half a turn
    singular,  // a matrix with a zero eigenvalue: the inertia of a rod; a quarter turn
    traceless, // a stress without pressure
    repeated   // the value of an earlier argument
};
constexpr std::size_t stratum_count = 7;
inline constexpr std::array<std::string_view, stratum_count> stratum_names = {
    "ordinary", "zero", "aligned", "equal", "singular", "traceless", "repeated"};

inline Matrix3d special_matrix(Stratum stratum, Random& random)
{
    const Vector3d m(random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
    switch (stratum) {
    case Stratum::aligned:
        return m.asDiagonal();
    case Stratum::equal:
        return m[0] * Matrix3d::Identity();
    case Stratum::singular: { // equal perpendicular to one direction, and 0 along it: a rod
        const Vector3d n = random.bits() % 2 == 0 ? random.unit_vector() : Vector3d::UnitX();
        return m[0] * (Matrix3d::Identity() - n * n.transpose());
    }
    case Stratum::traceless: {
        const Vector3d n = random.unit_vector();
        return m[0] * (3 * n * n.transpose() - Matrix3d::Identity());
    }
    default:
        return Matrix3d::Zero();
    }
}

inline Vector3d special_vector(Stratum stratum, Random& random)
{
    const double length = random.uniform(-1, 1);
    if (stratum == Stratum::aligned) return length * Vector3d::Unit(random_index(random, 3));
    if (stratum == Stratum::equal) return length * Vector3d::Ones();
    return Vector3d::Zero();
}

/// A turn by 0, 90 or 180 degrees about an axis.
inline Quaternion special_turn(Stratum stratum, Random& random)
{
    const Vector3d axis = Vector3d::Unit(random_index(random, 3));
    if (stratum == Stratum::aligned) return {};
    if (stratum == Stratum::equal) return {0, axis};
    return {std::sqrt(0.5), std::sqrt(0.5) * axis};
}

/// Whether the quantity has special values of this stratum.
template <class T> constexpr bool has_stratum(const Quantity& q, Stratum stratum)
{
    const bool is_inverse_mass = q.dimension == quantities::per_M; // K has this dimension too
    if (stratum == Stratum::ordinary) return true;
    if constexpr (std::is_same_v<T, double>)
        return stratum == Stratum::zero;
    else if constexpr (std::is_same_v<T, Vector3d>)
        return q.kind == Kind::unit ? stratum == Stratum::aligned : stratum <= Stratum::equal;
    else if constexpr (std::is_same_v<T, Matrix3d>) {
        if (q.kind == Kind::rotation)
            return stratum >= Stratum::aligned && stratum <= Stratum::singular;
        if (is_inverse_mass) return stratum == Stratum::aligned || stratum == Stratum::equal;
        if (q.kind == Kind::definite) return stratum <= Stratum::singular;
        return stratum <= Stratum::traceless && q.kind != Kind::columns;
    } else if constexpr (std::is_same_v<T, Quaternion>)
        return stratum >= Stratum::aligned && stratum <= Stratum::singular;
    else
        return false;
}

/// Replaces a value by one from the stratum. @return whether the stratum has a value for it
template <class T> bool draw_special(T& value, const Quantity& q, Stratum stratum, Random& random)
{
    if (stratum == Stratum::ordinary || !has_stratum<T>(q, stratum)) return false;
    if constexpr (std::is_same_v<T, double>) {
        value = q.dimension == quantities::per_M ? 0x1p-24 : 0; // 1/M = 0 would be a static body
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        value = special_vector(stratum, random);
        if (q.kind == Kind::unit) value = Vector3d::Unit(random_index(random, 3));
    } else if constexpr (std::is_same_v<T, Quaternion>) {
        value = special_turn(stratum, random);
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        value = special_matrix(stratum, random);
        if (q.kind == Kind::rotation) {
            const Quaternion turn = special_turn(stratum, random);
            value = Eigen::Quaterniond(turn.s, turn.v.x(), turn.v.y(), turn.v.z()).matrix();
        }
    }
    return true;
}

/// Whether a field describes the place or the build of a body, and not its motion or the forces on
/// it.
constexpr bool is_fixed(const Quantity& q)
{
    switch (q.kind) {
    case Kind::point:
    case Kind::rotation:
    case Kind::orientation:
    case Kind::along_axes:
    case Kind::index:
    case Kind::definite:
        return true;
    case Kind::number: // an inverse mass or a size; other numbers are masses and densities
        return q.dimension == quantities::per_M || q.dimension == quantities::L;
    default:
        return false;
    }
}

/// Calls visit(a, b, quantity) for each number, vector or matrix of two values of one shape.
/// @param without_fixed  leaves out the fields of structs that are fixed
template <class T, class Visit>
void each_pair(T& a, const T& b, const Quantity& q, bool without_fixed, const Visit& visit)
{
    if constexpr (std::is_same_v<T, Quaternion>) {
        visit(a.s, b.s, q);
        visit(a.v, b.v, q);
    } else if constexpr (Plain<T>) {
        std::size_t i = 0;
        Fields<T>::each(a, [&](std::string_view name, auto& field) {
            const Quantity of = FieldQuantities<T>::of[i++];
            if (without_fixed && is_fixed(of)) return;
            Fields<T>::each(b, [&](std::string_view other, const auto& other_field) {
                using Field = std::remove_cvref_t<decltype(field)>;
                if constexpr (std::is_same_v<Field, std::remove_cvref_t<decltype(other_field)>>)
                    if (name == other) each_pair(field, other_field, of, without_fixed, visit);
            });
        });
    } else if constexpr (IsOptional<T>::value) {
        if (a && b) each_pair(*a, *b, q, without_fixed, visit);
    } else if constexpr (std::is_same_v<T, double> || requires { a.colPivHouseholderQr(); }) {
        visit(a, b, q);
    } else if constexpr (!std::is_integral_v<T> && !std::is_same_v<T, std::vector<bool>>) {
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
            each_pair(a[i], b[i], q, without_fixed, visit);
    }
}

/// Whether one of the words in `list`, separated by spaces or commas, is this name.
constexpr bool has_word(std::string_view list, std::string_view word)
{
    while (!list.empty()) {
        const std::size_t end = std::min(list.find_first_of(" ,"), list.size());
        if (list.substr(0, end) == word) return true;
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return false;
}

/// Word n of such a list, counted from 0; empty if there is none.
constexpr std::string_view nth_word(std::string_view list, std::size_t n)
{
    for (;; --n) {
        list.remove_prefix(std::min(list.find_first_not_of(" ,"), list.size()));
        const std::size_t end = std::min(list.find_first_of(" ,"), list.size());
        if (n == 0) return list.substr(0, end);
        list.remove_prefix(end);
    }
}

/// How often each stratum was drawn.
using StrataCounts = std::array<int, stratum_count>;

/// Draws an argument from random strata; its fixed fields stay.
template <class T>
void redraw(T& value, const Quantity& q, Random& random, StrataCounts* counts = nullptr)
{
    if constexpr (std::is_same_v<T, Quaternion>)
        if (q.kind == Kind::orientation) { // drawn part by part it would not be unit
            draw(value, q, random);
            const std::size_t stratum = random.bits() % stratum_count;
            const bool is_special = draw_special(value, q, static_cast<Stratum>(stratum), random);
            if (counts) ++(*counts)[is_special ? stratum : 0];
            return;
        }
    T ordinary = value;
    if constexpr (!requires { value.resize(1); }) draw(ordinary, q, random);
    each_pair(value, ordinary, q, true, [&](auto& leaf, const auto& other, const Quantity& of) {
        leaf = other;
        if constexpr (requires { value.resize(1); }) draw(leaf, of, random);
        const std::size_t stratum = random.bits() % stratum_count;
        const bool is_special = draw_special(leaf, of, static_cast<Stratum>(stratum), random);
        if (counts) ++(*counts)[is_special ? stratum : 0];
    });
    if constexpr (std::is_same_v<T, Quaternion>)
        draw_special(value, q, static_cast<Stratum>(random.bits() % stratum_count), random);
}

/// Gives argument k the value of the last argument before it with the same type and dimension, if
/// there is one. Fixed fields stay.
template <class Arguments, std::size_t... i>
void repeat(Arguments& arguments, std::size_t k, const FormulaQuantities& of,
            std::index_sequence<i...>)
{
    const auto copy = [&](auto& from, std::size_t first, auto& to, std::size_t second) {
        if constexpr (std::is_same_v<decltype(from), decltype(to)>)
            if (second == k && first < k &&
                of.arguments[first].dimension == of.arguments[k].dimension)
                each_pair(to, from, of.arguments[k], true,
                          [](auto& x, const auto& y, const Quantity&) { x = y; });
    };
    const auto copy_to = [&](auto& to, std::size_t second) {
        (copy(std::get<i>(arguments), i, to, second), ...);
    };
    (copy_to(std::get<i>(arguments), i), ...);
}

/// Redraws the arguments whose names are among the chosen ones, or with `others` all others.
template <class Arguments>
void redraw_chosen(Arguments& arguments, const FormulaQuantities& of, std::string_view names,
                   std::string_view chosen, bool others, Random& random)
{
    constexpr auto all = std::make_index_sequence<std::tuple_size_v<Arguments>>();
    std::size_t k = 0;
    std::apply(
        [&](auto&... argument) {
            const auto redraw_one = [&](auto& one) {
                if (has_word(chosen, nth_word(names, k)) != others) {
                    redraw(one, of.arguments[k], random);
                    if (random.bits() % 4 == 0) repeat(arguments, k, of, all);
                }
                ++k;
            };
            (redraw_one(argument), ...);
        },
        arguments);
}

} // namespace rigor::testing
