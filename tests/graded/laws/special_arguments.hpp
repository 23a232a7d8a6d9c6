// SPDX-License-Identifier: MIT
// Special inputs of a formula, and inputs near them. Special inputs have entries that are zero,
// equal or small whole numbers (whose sums, products and squares often coincide), have several
// vectors that are zero, turn about an axis of the frame or by quarters of a turn, have a point
// straight above another one, or in the middle of others, repeat an argument, or coincide with
// entries of others. Ordinary random numbers almost never do any of this.
#pragma once

#include "coincidences.hpp"

#include <numbers>

namespace rigor::testing {

inline bool one_in(int n, Random& random)
{
    return random_index(random, static_cast<std::size_t>(n)) == 0;
}

/// Sets entries to zero, or to another entry or its negative.
template <class Entries> void make_entries_special(Entries& x, bool may_vanish, Random& random)
{
    for (int i = 0; i < x.size(); ++i) {
        if (may_vanish && one_in(3, random)) x(i) = 0;
        if (!one_in(4, random)) continue;
        const double other = x(random_index(random, static_cast<std::size_t>(x.size())));
        x(i) = may_vanish && one_in(2, random) ? -other : other;
    }
}

/// A whole number from `least` to `most`.
inline double whole(int least, int most, Random& random)
{
    return least + random_index(random, static_cast<std::size_t>(most - least + 1));
}

/// A turn about an axis or a diagonal of the frame, or one without a part about some axes; the real
/// part has either sign, or is 0 for half a turn.
inline Quaternion special_unit_quaternion(Random& random)
{
    Eigen::Vector4d q(random.uniform(-1, 1), 0, 0, 0);
    q.tail<3>() = random.vector();
    make_entries_special(q, true, random);
    if (one_in(4, random)) { // a turn that takes a cube to itself, with entries that are equal
        const int first = random_index(random, 4), second = random_index(random, 4);
        const bool has_all = first == second; // a third of a turn about a diagonal
        for (int i = 0; i < 4; ++i) {
            q[i] = has_all || i == first || i == second ? 1 : 0;
            if (one_in(2, random)) q[i] = -q[i];
        }
        q *= has_all ? 0.5 : std::numbers::sqrt2 / 2;
        return {q[0], q.tail<3>()};
    }
    if (one_in(4, random)) q.setZero(); // no turn, or half a turn about an axis
    if (q.norm() < 0.1) q[random_index(random, 4)] = one_in(2, random) ? 1 : -1;
    q.normalize();
    return {q[0], q.tail<3>()};
}

inline Matrix3d matrix_of(const Quaternion& q)
{
    return Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z()).toRotationMatrix();
}

/// A symmetric matrix. Two of its diagonal entries are equal, or all, or none, and any of the other
/// entries, which are at most `beside`, are 0.
inline Matrix3d special_symmetric(Vector3d diagonal, double beside, Random& random)
{
    const int i = random_index(random, 5);
    if (i < 3) diagonal[i] = diagonal[(i + 1) % 3];
    if (i == 3) diagonal.setConstant(diagonal[0]);
    Matrix3d S = diagonal.asDiagonal();
    const int zeros = random_index(random, 8);
    for (int k = 0; k < 3; ++k)
        if (!(zeros >> k & 1)) {
            const int next = (k + 1) % 3;
            S(k, next) = S(next, k) = beside * random.uniform(-1, 1);
        }
    return S;
}

/// A symmetric matrix of the unit times whole numbers: those on the diagonal are from `least` to
/// `most`, the others are -1, 0 or 1.
inline Matrix3d whole_symmetric(int least, int most, double unit, Random& random)
{
    Matrix3d S;
    for (int i = 0; i < 3; ++i) {
        S(i, i) = whole(least, most, random);
        const int next = (i + 1) % 3;
        S(i, next) = S(next, i) = whole(-1, 1, random);
    }
    return unit * S;
}

/// A body's inertia, or its inverse: moments that are equal or not, products that are 0 or not.
/// The eigenvalues lie between 0.6 and 1.2, so no moment is above the sum of the others.
inline Matrix3d special_definite(Random& random)
{
    if (one_in(4, random)) return whole_symmetric(14, 16, 0.0625, random);
    return special_symmetric(0.9 * Vector3d::Ones() + 0.1 * random.vector(), 0.1, random);
}

/// Makes a number, vector or matrix special within its set.
template <class T> void make_special(T& value, const Quantity& q, Random& random)
{
    const bool may_vanish = q.kind != Kind::along_axes || q.dimension == quantities::none;
    if constexpr (std::is_same_v<T, double>) {
        if (q.kind == Kind::any_number)
            value = random_index(random, 3) - 1;
        else if (q.kind == Kind::number && q.dimension != quantities::duration.dimension)
            value = 1;
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        make_entries_special(value, may_vanish, random);
        if (one_in(6, random)) value.setConstant(value[0]); // a cube, or a diagonal of the frame
        if (one_in(6, random))
            for (double& entry : value)
                entry = may_vanish ? whole(-2, 2, random) : whole(1, 7, random) / 4;
        if (q.kind != Kind::unit) return;
        if (value.norm() < 0.1) value = Vector3d::Unit(random_index(random, 3));
        value.normalize();
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        if (q.kind == Kind::rotation) {
            value = matrix_of(special_unit_quaternion(random));
        } else if (q.kind == Kind::definite) {
            value = special_definite(random);
        } else if (q.kind == Kind::symmetric && one_in(4, random)) {
            value = whole_symmetric(-1, 1, 1, random);
        } else if (q.kind == Kind::symmetric) {
            Vector3d diagonal = value.diagonal();
            if (one_in(4, random)) diagonal[random_index(random, 3)] = 0;
            if (one_in(8, random)) diagonal.setZero();
            value = special_symmetric(diagonal, one_in(2, random) ? 0.1 : 1, random);
        } else if (q.kind == Kind::columns) { // near a rotation, so they stay independent
            Matrix3d change = 0.2 * value;
            make_entries_special(change, true, random);
            value = matrix_of(special_unit_quaternion(random)) + change;
        } else {
            make_entries_special(value, true, random);
            if (one_in(3, random)) value.diagonal().setZero();
        }
    }
}

/// Moves a value by about t within its set.
template <class T> void nudge(T& value, const Quantity& q, double t, Random& random)
{
    if constexpr (std::is_same_v<T, double>) {
        value += t * random.uniform(-1, 1);
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        value += t * random.vector();
        if (q.kind == Kind::unit) value.normalize();
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        Matrix3d change;
        change << random.vector(), random.vector(), random.vector();
        if (q.kind == Kind::rotation) {
            const Vector3d axis = random.unit_vector();
            value = Eigen::AngleAxisd(t, axis) * value;
        } else {
            if (q.kind == Kind::symmetric || q.kind == Kind::definite)
                change = (change + change.transpose()).eval() / 2;
            value += t * change;
        }
    }
}

template <class T> void make_unit(T& value, const Quantity& q)
{
    if constexpr (std::is_same_v<T, RigidState>)
        make_unit(value.orientation, quantities::orientation);
    if constexpr (std::is_same_v<T, Quaternion>) {
        if (q.kind != Kind::orientation) return;
        const double length = std::hypot(value.s, value.v.norm());
        value.s /= length;
        value.v /= length;
    }
}

template <class T> void make_argument_special(T& value, const Quantity& q, Random& random)
{
    if constexpr (std::is_same_v<T, LevelSet>) {
        if (one_in(2, random))
            for (double& distance : value.distances)
                distance = whole(-1, one_in(2, random) ? 1 : 0, random);
        return;
    }
    const T ordinary = value;
    each_pair(value, ordinary, q, false, [&](auto& leaf, const auto&, const Quantity& of) {
        if (of.kind != Kind::index && !one_in(3, random)) make_special(leaf, of, random);
    });
    if constexpr (std::is_same_v<T, RigidState>) {
        if (one_in(2, random)) value.orientation = special_unit_quaternion(random);
    } else if constexpr (std::is_same_v<T, Quaternion>) {
        if (one_in(2, random) || std::hypot(value.s, value.v.norm()) < 0.1)
            value = special_unit_quaternion(random);
    }
    make_unit(value, q);
}

/// Makes half of the vectors and matrices of an argument zero that may be zero, so that all
/// combinations of zero and other ones occur. Parts of a quaternion are zero elsewhere.
template <class T> void make_zero(T& value, const Quantity& q, Random& random)
{
    if constexpr (std::is_same_v<T, Quaternion>) return;
    const T before = value;
    each_pair(value, before, q, false, [&](auto& leaf, const auto&, const Quantity& of) {
        using Leaf = std::remove_cvref_t<decltype(leaf)>;
        constexpr bool is_vector = std::is_same_v<Leaf, Vector3d>,
                       is_matrix = std::is_same_v<Leaf, Matrix3d>;
        if constexpr (is_vector || is_matrix) {
            const bool has_size = of.kind == Kind::unit || of.kind == Kind::along_axes ||
                                  of.kind == Kind::rotation || of.kind == Kind::definite ||
                                  of.kind == Kind::columns || of.kind == Kind::orientation;
            if (!has_size && one_in(2, random)) leaf.setZero();
        }
    });
}

template <class T> void nudge_argument(T& value, const Quantity& q, double t, Random& random)
{
    const T before = value;
    each_pair(value, before, q, false, [&](auto& leaf, const auto&, const Quantity& of) {
        if (of.kind != Kind::index) nudge(leaf, of, t, random);
    });
    make_unit(value, q);
}

/// If the last two arguments are vectors, such as points, makes entries of their difference zero or
/// equal, in half of the cases.
template <class Arguments> void align_points(Arguments& arguments, Random& random)
{
    if constexpr (std::tuple_size_v<Arguments> >= 2) {
        constexpr std::size_t last = std::tuple_size_v<Arguments> - 1;
        auto& x = std::get<last>(arguments);
        auto& X = std::get<last - 1>(arguments);
        if constexpr (std::is_same_v<decltype(x), Vector3d&> &&
                      std::is_same_v<decltype(X), Vector3d&>) {
            Vector3d arm = random.vector();
            make_entries_special(arm, true, random);
            if (one_in(2, random)) x = X + arm;
        }
    }
}

/// If the first two arguments are a quaternion and a vector, may give the vector the direction of
/// the quaternion's axis.
template <class Arguments> void align_with_axis(Arguments& arguments, Random& random)
{
    if constexpr (std::tuple_size_v<Arguments> >= 2) {
        auto& q = std::get<0>(arguments);
        auto& w = std::get<1>(arguments);
        if constexpr (std::is_same_v<decltype(q), Quaternion&> &&
                      std::is_same_v<decltype(w), Vector3d&>)
            if (one_in(4, random)) w = random.uniform(-2, 2) * q.v;
    }
}

/// If the first two arguments are a list and a point, may place the elements of the list in pairs
/// on both sides of the point. Then the point is their mean. It is their center of mass too if the
/// masses of each pair are equal. All coordinates are whole numbers, so that sums are exact.
template <class Arguments> void balance_around_point(Arguments& arguments, Random& random)
{
    if constexpr (std::tuple_size_v<Arguments> >= 2) {
        auto& list = std::get<0>(arguments);
        auto& X = std::get<1>(arguments);
        const auto place = [](auto& element) -> Vector3d& {
            if constexpr (requires { element.point; })
                return element.point;
            else
                return element.position;
        };
        constexpr bool has_places = requires
        {
            list[0].point;
        }
        || requires
        {
            list[0].position;
        };
        if constexpr (std::is_same_v<decltype(X), Vector3d&> && has_places) {
            if (!one_in(4, random)) return;
            const auto whole_vector = [&] {
                return Vector3d(whole(-2, 2, random), whole(-2, 2, random), whole(-2, 2, random));
            };
            const bool is_alike = one_in(2, random);
            X = whole_vector();
            for (std::size_t i = 0; i < list.size(); ++i) {
                const bool is_second = i % 2 == 1, is_single = i + 1 == list.size() && !is_second;
                const Vector3d arm = is_second ? Vector3d(X - place(list[i - 1])) : whole_vector();
                if (is_second && is_alike) list[i] = list[i - 1];
                place(list[i]) = is_single ? X : Vector3d(X + arm);
            }
        }
    }
}

/// Makes Euler angles, or the angle of a step, multiples of a quarter turn. The angles of
/// `euler_rates` stay away from gimbal lock.
template <FormulaIndex f, class Arguments>
void turn_by_quarters(Arguments& arguments, Random& random)
{
    constexpr double quarter = std::numbers::pi / 2;
    const auto quarters = [&] { return quarter * (random_index(random, 9) - 4); };
    if constexpr (f == FormulaIndex::euler_to_matrix || f == FormulaIndex::euler_rates) {
        Vector3d& angles = std::get<0>(arguments);
        for (const int i : {0, 2})
            if (one_in(2, random)) angles[i] = quarters();
        if (one_in(2, random)) angles[1] = 2 * quarters();
        if (f == FormulaIndex::euler_to_matrix && one_in(2, random)) angles[1] = quarters();
    } else if constexpr (f == FormulaIndex::advance_exact) {
        auto& [q, omega, time_step] = arguments;
        if (one_in(3, random) && !omega.isZero(0.1)) time_step = quarters() / omega.norm();
    }
}

/// Special arguments of the formula that the contract allows together.
template <FormulaIndex f, auto& formula> Arguments<formula> special_arguments(Random& random)
{
    using F = FormulaIndex;
    constexpr bool is_impulse = f == F::frictionless_impulse || f == F::static_friction_impulse;
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    Arguments<formula> arguments =
        random_arguments<f, formula>(static_cast<unsigned>(random.bits()));
    std::size_t k = 0;
    std::apply([&](auto&... one) { (make_argument_special(one, of.arguments[k++], random), ...); },
               arguments);
    k = 0;
    if (one_in(4, random))
        std::apply([&](auto&... one) { (make_zero(one, of.arguments[k++], random), ...); },
                   arguments);
    if constexpr (f == F::sample_level_set) {
        auto& [grid, p] = arguments;
        for (int i = 0; i < 3; ++i) // a node, half-way between nodes, or elsewhere, also outside
            p[i] = grid.origin[i] + grid.cell_size / 2 * (random_index(random, 12) - 3) +
                   (one_in(3, random) ? grid.cell_size * random.uniform(-1, 1) : 0);
    } else if constexpr (is_impulse) {
        const Vector3d& n = std::get<2>(arguments);
        Vector3d& v = std::get<1>(arguments);
        if (v.dot(n) > 0) v = -v; // bodies that approach
        if (v.dot(n) > -0.05) v -= n;
    } else {
        align_points(arguments, random);
        balance_around_point(arguments, random);
        align_with_axis(arguments, random);
        turn_by_quarters<f>(arguments, random);
        if (one_in(3, random)) make_coincident(arguments, of, random);
    }
    return arguments;
}

} // namespace rigor::testing
