// SPDX-License-Identifier: MIT
// Checks that inputs are as the contract says: each lies in the set that the table of quantities
// names for it. A rotation is orthonormal, a normal is unit, an inertia is symmetric and no moment
// in it is negative, a mass is not negative.
#pragma once

#include "strata.hpp"

namespace rigor::testing {

/// The deviation of the sets below from their definitions that rounding may cause.
inline constexpr double rounding_of_sets = 1e-12;

inline bool is_symmetric(const Matrix3d& A)
{
    return (A - A.transpose()).norm() <= rounding_of_sets * A.norm();
}

/// Whether a number, vector or matrix lies in the set of its quantity.
template <class T> bool lies_in_set(const T& value, const Quantity& q)
{
    if constexpr (std::is_same_v<T, double>) {
        return std::isfinite(value) && (q.kind != Kind::number || value >= 0);
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        if (!value.allFinite()) return false;
        return q.kind != Kind::unit || std::abs(value.norm() - 1) <= rounding_of_sets;
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        if (!value.allFinite()) return false;
        switch (q.kind) {
        case Kind::rotation:
            return value.isUnitary(rounding_of_sets) && value.determinant() > 0;
        case Kind::symmetric:
            return is_symmetric(value);
        case Kind::definite:
            return is_symmetric(value) &&
                   Eigen::SelfAdjointEigenSolver<Matrix3d>(value).eigenvalues().minCoeff() >=
                       -rounding_of_sets * value.norm();
        default:
            return true;
        }
    } else {
        return value.allFinite();
    }
}

/// Whether all parts of an argument lie in their sets.
template <class T> bool satisfies(const T& value, const Quantity& q)
{
    T copy = value;
    bool is_in = true;
    each_pair(copy, value, q, false, [&](const auto&, const auto& part, const Quantity& of) {
        is_in &= lies_in_set(part, of);
    });
    if constexpr (std::is_same_v<T, Quaternion>)
        if (q.kind == Kind::orientation)
            is_in &= std::abs(std::hypot(value.s, value.v.norm()) - 1) <= rounding_of_sets;
    if constexpr (std::is_same_v<T, RigidState>)
        is_in &= satisfies(value.orientation, {{}, Kind::orientation});
    return is_in;
}

/// The names of the arguments outside of their sets, empty if there are none.
template <FormulaIndex f, class Arguments> std::string broken_preconditions(const Arguments& all)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    const std::string_view names = formulas[static_cast<unsigned>(f)].arguments;
    std::string broken;
    std::size_t i = 0;
    std::apply(
        [&](const auto&... argument) {
            ((broken +=
              satisfies(argument, of.arguments[i]) ? "" : std::string(nth_word(names, i)) + " ",
              ++i),
             ...);
        },
        all);
    return broken;
}

} // namespace rigor::testing
