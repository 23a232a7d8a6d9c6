// SPDX-License-Identifier: MIT
// Coincidences: two entries of the arguments that are equal or opposite, such as a component of two
// velocities, two points, or two masses, and vectors that are parallel. Numbers that are drawn one
// by one almost never coincide.
#pragma once

#include "strata.hpp"

namespace rigor::testing {

/// A number, vector or matrix of the arguments, with its quantity.
template <class T> struct Leaf {
    T* value;
    Quantity of;
};

/// The parts of all arguments that may coincide: those that are free to take each other's values.
/// Unit vectors, rotations and what is tied to the axes stay as they are.
struct Leaves {
    std::vector<Leaf<double>> numbers;
    std::vector<Leaf<Vector3d>> vectors;
    std::vector<Leaf<Matrix3d>> matrices;

    void add(double& x, const Quantity& of)
    {
        const bool is_free =
            of.kind == Kind::number || of.kind == Kind::any_number || of.kind == Kind::quaternion;
        if (is_free && of.dimension != quantities::duration.dimension) numbers.push_back({&x, of});
    }
    void add(Vector3d& x, const Quantity& of)
    {
        if (of.kind == Kind::vector || of.kind == Kind::point || of.kind == Kind::quaternion)
            vectors.push_back({&x, of});
    }
    void add(Matrix3d& x, const Quantity& of)
    {
        const bool is_stiffness = of.dimension == quantities::per_M; // K fits its v and n
        if ((of.kind == Kind::symmetric || of.kind == Kind::definite) && !is_stiffness)
            matrices.push_back({&x, of});
    }
    template <class Other> void add(Other&, const Quantity&) {}
};

/// Makes entries of two vectors equal or opposite, or the vectors parallel.
inline void make_coincide(Vector3d& a, const Vector3d& b, Random& random)
{
    const double sign = random.bits() % 2 == 0 ? 1 : -1;
    const int k = random_index(random, 3);
    switch (random.bits() % 4) {
    case 0:
        a = sign * b;
        break;
    case 1:
        a = random.uniform(-2, 2) * b;
        break;
    case 2: // all but one component
        for (int i : {(k + 1) % 3, (k + 2) % 3})
            a[i] = sign * b[i];
        break;
    default:
        a[k] = sign * b[k];
    }
}

/// Calls change(leaf, other) for two leaves of one dimension and kind, if there are any.
template <class T, class Change>
void change_pair(const std::vector<Leaf<T>>& leaves, Random& random, const Change& change)
{
    if (leaves.empty()) return;
    const Leaf<T>& leaf = leaves[random.bits() % leaves.size()];
    std::vector<Leaf<T>> others;
    for (const Leaf<T>& other : leaves)
        if (other.value != leaf.value && other.of.dimension == leaf.of.dimension &&
            other.of.kind == leaf.of.kind)
            others.push_back(other);
    if (!others.empty()) change(leaf, others[random.bits() % others.size()]);
}

/// Makes some entries of the arguments coincide.
template <class Arguments>
void make_coincident(Arguments& arguments, const FormulaQuantities& of, Random& random)
{
    Leaves leaves;
    std::size_t k = 0;
    const auto collect = [&](auto& argument) {
        using Argument = std::remove_cvref_t<decltype(argument)>;
        const Argument same = argument;
        const Quantity& q = of.arguments[k++];
        if constexpr (!std::is_same_v<Argument, LevelSet>)
            each_pair(argument, same, q, false,
                      [&](auto& x, const auto&, const Quantity& its) { leaves.add(x, its); });
    };
    std::apply([&](auto&... argument) { (collect(argument), ...); }, arguments);

    const auto opposite = [&] { return random.bits() % 2 == 0; };
    for (int n = 0; n < 2; ++n) {
        change_pair(leaves.vectors, random,
                    [&](auto& a, auto& b) { make_coincide(*a.value, *b.value, random); });
        change_pair(leaves.numbers, random, [](auto& a, auto& b) { *a.value = *b.value; });
        change_pair(leaves.matrices, random, [&](auto& a, auto& b) {
            *a.value = a.of.kind == Kind::symmetric && opposite() ? Matrix3d(-*b.value) : *b.value;
        });
    }
    if (leaves.vectors.size() >= 2) // these two may be different quantities
        make_coincide(*leaves.vectors.front().value, *leaves.vectors.back().value, random);
}

} // namespace rigor::testing
