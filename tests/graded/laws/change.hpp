// SPDX-License-Identifier: MIT
// Changes of the units and of the frame, applied to any argument or result of a formula. What they
// do to a value follows from the table of quantities.
#pragma once

#include "formulas/quantities.hpp"
#include "support/close.hpp"

#include <cmath>
#include <map>
#include <tuple>

namespace rigor::testing {

/// A change of units, or a rotation and translation of the whole scene.
struct Change {
    Dimension units;                   // numbers of masses are multiplied by 2^mass, and so on
    Matrix3d Q = Matrix3d::Identity(); // turns the scene
    Vector3d d = Vector3d::Zero();     // moves it afterwards [m]

    double factor(const Dimension& of) const
    {
        return std::ldexp(1,
                          units.mass * of.mass + units.length * of.length + units.time * of.time);
    }
    Change undone() const
    {
        return {{-units.mass, -units.length, -units.time}, Q.transpose(), -Q.transpose() * d};
    }
};

inline void apply(const Change& c, Vector3d& v, Kind kind)
{
    if (kind == Kind::along_axes || kind == Kind::chosen) return;
    v = (c.Q * v).eval();
    if (kind == Kind::point) v += c.d;
}

inline void apply(const Change& c, Matrix3d& A, Kind kind)
{
    if (kind == Kind::along_axes || kind == Kind::chosen) return;
    A = (c.Q * A).eval();
    if (kind != Kind::columns) A = (A * c.Q.transpose()).eval();
}

/// Changes a value that has the quantity `q`.
template <class T> void change(T& value, const Quantity& q, const Change& c)
{
    if constexpr (Plain<T>) {
        const Quantity* of = FieldQuantities<T>::of;
        Fields<T>::each(value, [&](std::string_view, auto& field) {
            change(field, {of->dimension * q.dimension, of->kind}, c);
            ++of;
        });
    } else if constexpr (IsOptional<T>::value) {
        if (value) change(*value, q, c);
    } else if constexpr (std::is_floating_point_v<T>) {
        value *= c.factor(q.dimension);
    } else if constexpr (std::is_integral_v<T> || std::is_same_v<T, std::vector<bool>>) {
        return; // an index or an answer is the same in all units and frames
    } else if constexpr (requires { value.colPivHouseholderQr(); }) {
        if constexpr (T::RowsAtCompileTime * T::ColsAtCompileTime <= 9) {
            if (!c.Q.isIdentity(0) || !c.d.isZero(0)) apply(c, value, q.kind);
            value *= c.factor(q.dimension);
        } else {
            for (int i = 0; i < value.rows() / 3; ++i)
                for (int j = 0; j < value.cols() / 3; ++j) {
                    Matrix3d block = value.template block<3, 3>(3 * i, 3 * j);
                    change(block, {q.dimension * Dimension{0, i + j, 0}, Kind::matrix}, c);
                    value.template block<3, 3>(3 * i, 3 * j) = block;
                }
        }
    } else {
        for (auto& element : value)
            change(element, q, c);
    }
}

template <class T> T changed(T value, const Quantity& q, const Change& c)
{
    change(value, q, c);
    return value;
}

/// Gives `value` what `model` has wherever several results are correct, such as the sign of an
/// axis.
template <class T> void choose_as(T& value, const T& model, const Quantity& q)
{
    if constexpr (Plain<T>) {
        std::size_t i = 0;
        const auto choose = [&](auto& field, const auto& other) {
            choose_as(field, other, FieldQuantities<T>::of[i++]);
        };
        if constexpr (std::is_same_v<T, PrincipalAxes>) choose(value.rotation, model.rotation);
        if constexpr (std::is_same_v<T, PrincipalStress>) {
            i = 1;
            choose(value.direction, model.direction);
        }
    } else if constexpr (IsOptional<T>::value) {
        if (value && model) choose_as(*value, *model, q);
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        if (q.kind == Kind::direction && value.dot(model) < 0) value = -value;
    }
    if constexpr (std::is_same_v<T, Matrix3d>)
        if (q.kind == Kind::chosen) value = model;
}

/// What is unique in a changed mesh, whose vertices and tetrahedra are in any order: the number of
/// vertices, the number of tetrahedra, and for the parts of each old tetrahedron their volume and
/// ∫ x dV.
/// @throws std::out_of_range if an index is invalid, since a mesh may come from a submission
inline std::vector<double> summary(const TetrahedralMesh& mesh, const std::vector<int>& parents)
{
    std::map<int, Eigen::Vector4d> parts;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        std::array<Vector3d, 4> x;
        for (int i = 0; i < 4; ++i)
            x[i] = mesh.vertices.at(static_cast<std::size_t>(mesh.tetrahedra[t][i]));
        const double V = (x[1] - x[0]).dot((x[2] - x[0]).cross(x[3] - x[0])) / 6;
        Eigen::Vector4d& part =
            parts.try_emplace(parents.at(t), Eigen::Vector4d::Zero()).first->second;
        part += V * (Eigen::Vector4d() << 1, (x[0] + x[1] + x[2] + x[3]) / 4).finished();
    }
    std::vector<double> result = {static_cast<double>(mesh.vertices.size()),
                                  static_cast<double>(mesh.tetrahedra.size())};
    for (const auto& [parent, part] : parts)
        result.insert(result.end(), part.data(), part.data() + 4);
    return result;
}

template <class T> const T& comparable(const T& value)
{
    return value;
}
inline std::vector<double> comparable(const SplitMesh& split)
{
    return summary(split.mesh, split.parents);
}
inline std::vector<double> comparable(const EmbeddedMesh& embedded)
{
    return summary(embedded.mesh, embedded.parents);
}

/// The tolerance of the universal laws. Inputs have numbers of about 1, and so have the terms of
/// the results. A change of units by powers of two does not change the digits that +, -, *, / and √
/// compute. Other functions and other frames change the last bits, and a formula magnifies this by
/// its condition, here up to 2^20 times.
template <class T> Tolerance universal(const T& expected)
{
    double largest = 1;
    const Components parts = components(expected);
    for (std::size_t i = 0; i < parts.numbers.size(); ++i)
        if (const double scale = parts.scale(i); std::isfinite(scale))
            largest = std::max(largest, scale);
    return Rounding(1 << 20, largest);
}

/// Changes the arguments of the formula with these quantities.
template <class... Argument>
void change_arguments(std::tuple<Argument...>& arguments, const FormulaQuantities& of,
                      const Change& c)
{
    std::size_t i = 0;
    std::apply([&](auto&... argument) { (change(argument, of.arguments[i++], c), ...); },
               arguments);
}

/// Whether an argument of the formula has a unit of mass, length or time.
constexpr bool has_units(FormulaIndex f)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    return std::any_of(
        of.arguments.begin(), of.arguments.begin() + of.count,
        [](const Quantity& q) { return q.dimension != Dimension() || q.kind == Kind::fields; });
}

} // namespace rigor::testing
