// SPDX-License-Identifier: MIT
// Arguments that differ from others in a single part: one number, one component of a vector, one
// pair of entries of a tensor, one element of a list, two numbers whose sum stays, or the sign or
// the order of one such group.
// Changed arguments that the contract does not allow are left out.
#pragma once

#include "preconditions.hpp"

#include <limits>

namespace rigor::testing {

/// Counts the possible changes of a value, and returns true for the one with the given number.
class Turn {
public:
    explicit Turn(int number) : left_(number), first_(number) {}
    bool operator()() { return left_-- == 0; }
    int count() const { return first_ - left_; } // the number of possible changes so far

private:
    int left_, first_;
};

/// Whether a quantity may change its sign.
inline bool has_sign(const Quantity& q)
{
    const bool is_size = q.kind == Kind::along_axes && q.dimension != quantities::none;
    return q.kind != Kind::number && !is_size;
}

inline void change_entry(double& x, bool has_sign, Turn& turn)
{
    if (has_sign && turn()) x = -x;
    if (turn()) x = x == 0 ? 0.5 : 0.75 * x;
    if (turn()) x = x == 0 ? 0.25 : 0;
    if (turn()) x *= 1 + 0x1p-44; // equal in single precision, and for Eigen's `isApprox`
}

/// Swaps two neighboring entries, so that their sum and their norm stay.
template <class List> void swap_entries(List& list, Turn& turn)
{
    for (int i = 0; i + 1 < static_cast<int>(list.size()); ++i)
        if (turn()) std::swap(list[i], list[i + 1]);
}

/// Moves a part of one number to another one, so that their sum stays.
inline void shift_between(double& x, double& y, Turn& turn)
{
    if (!turn()) return;
    const double shift = 0.25 * (std::abs(x) + std::abs(y));
    x += shift;
    y -= shift;
}

inline void change_vector(Vector3d& v, const Quantity& q, Turn& turn)
{
    for (double& x : v) {
        if (q.kind == Kind::unit && turn()) x = -x;
        if (q.kind != Kind::unit) change_entry(x, has_sign(q), turn);
    }
    if (has_sign(q) && turn()) v = -v;
    if (has_sign(q) && q.kind != Kind::unit) shift_between(v[0], v[1], turn);
    swap_entries(v, turn);
}

inline void change_rotation(Matrix3d& R, Turn& turn)
{
    if (turn()) R.transposeInPlace();
    if (turn()) R.leftCols<2>() = -R.leftCols<2>();
    if (turn()) R.rightCols<2>() = -R.rightCols<2>();
    if (turn()) R = Matrix3d(R * Eigen::AngleAxisd(0x1p-44, Vector3d::UnitX()));
}

inline void change_symmetric(Matrix3d& A, Turn& turn)
{
    const Matrix3d diagonal = A.diagonal().asDiagonal();
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, l = (i + 2) % 3;
        double pair = A(k, l);
        change_entry(pair, true, turn);
        A(k, l) = A(l, k) = pair;
        change_entry(A(i, i), true, turn);
        if (turn()) A.row(i) = -A.row(i), A.col(i) = -A.col(i); // a mirror image
        if (turn()) A.row(k).swap(A.row(l)), A.col(k).swap(A.col(l));
    }
    if (turn()) A = 2 * diagonal - A;
    if (turn()) A = -A;
    shift_between(A(0, 0), A(1, 1), turn);
    double first = A(0, 1), second = A(1, 2);
    shift_between(first, second, turn);
    A(0, 1) = A(1, 0) = first;
    A(1, 2) = A(2, 1) = second;
}

inline void change_matrix(Matrix3d& A, const Quantity& q, Turn& turn)
{
    if (q.kind == Kind::rotation) return change_rotation(A, turn);
    if (q.kind == Kind::symmetric || q.kind == Kind::definite) return change_symmetric(A, turn);
    for (int i = 0; i < 9; ++i) {
        if (q.kind == Kind::columns && turn()) A(i) += 0x1p-4; // the columns stay independent
        if (q.kind != Kind::columns) change_entry(A(i), true, turn);
    }
    if (turn()) A.transposeInPlace();
}

inline void change_quaternion(Quaternion& q, const Quantity& of, Turn& turn)
{
    if (of.kind != Kind::orientation) change_entry(q.s, true, turn);
    if (of.kind == Kind::orientation && turn()) q.s = -q.s;
    change_vector(q.v, of.kind == Kind::orientation ? quantities::unit : of, turn);
    if (turn()) std::swap(q.s, q.v[0]);
}

template <class T> void change_part(T& value, const Quantity& q, Turn& turn);

/// Changes elements of a list, their order, and its length if no index refers to its elements.
template <class List> void change_list(List& list, const Quantity& q, Turn& turn)
{
    using Element = std::remove_cvref_t<decltype(list[0])>;
    constexpr bool is_alone = Plain<Element> && !std::is_same_v<Element, Body>;
    if constexpr (std::is_same_v<List, std::vector<int>>) {
        for (int& level : list) // level 0 belongs to static bodies
            if (turn() && level > 0) ++level;
    } else if constexpr (std::is_same_v<Element, std::vector<int>>) {
        for (std::vector<int>& links : list) {
            for (int& link : links)
                if (turn() && link > 0) --link;
            if (turn()) links.clear();
        }
    } else {
        for (auto& element : list)
            change_part(element, q, turn);
    }
    swap_entries(list, turn);
    if constexpr (is_alone && requires { list.pop_back(); })
        if (turn() && list.size() > 1) list.pop_back();
}

/// Changes the vertices of a mesh by so little that nothing is inverted, and the order of the
/// corners of its triangles or tetrahedra.
template <class Mesh> void change_mesh(Mesh& mesh, Turn& turn)
{
    const auto change = [&](auto& elements) {
        for (auto& corners : elements)
            if (turn()) std::rotate(corners.begin(), corners.begin() + 1, corners.begin() + 3);
    };
    for (Vector3d& x : mesh.vertices)
        for (double& entry : x)
            if (turn()) entry += 0x1p-6;
    if constexpr (requires { mesh.tetrahedra; })
        change(mesh.tetrahedra);
    else
        change(mesh.triangles);
}

/// Makes one change to a value, if the turn is that of one of its parts.
template <class T> void change_part(T& value, const Quantity& q, Turn& turn)
{
    if constexpr (std::is_same_v<T, Quaternion>) {
        change_quaternion(value, q, turn);
    } else if constexpr (std::is_same_v<T, TriangleMesh> || std::is_same_v<T, TetrahedralMesh>) {
        change_mesh(value, turn);
    } else if constexpr (std::is_same_v<T, LevelSet>) {
        change_part(value.origin, quantities::sizes, turn);
        if (turn()) value.cell_size *= 0.75;
        change_list(value.distances, quantities::depth, turn);
    } else if constexpr (Plain<T>) {
        const Quantity* of = FieldQuantities<T>::of;
        Fields<T>::each(value, [&](std::string_view name, auto& field) {
            const Quantity its = *of++;
            if (name == "body1" || name == "body2") return;
            change_part(field, {its.dimension * q.dimension, its.kind}, turn);
        });
        if constexpr (std::is_same_v<T, BodyContact>)
            if (turn()) std::swap(value.body1, value.body2);
    } else if constexpr (std::is_same_v<T, bool>) {
        if (turn()) value = !value;
    } else if constexpr (std::is_integral_v<T>) {
        if (turn()) value += value > 0 ? -1 : 1;
    } else if constexpr (std::is_same_v<T, double>) {
        change_entry(value, has_sign(q), turn);
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        change_vector(value, q, turn);
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        change_matrix(value, q, turn);
    } else if constexpr (std::is_same_v<T, std::vector<bool>>) {
        for (std::size_t i = 0; i < value.size(); ++i)
            if (turn()) value[i] = !value[i];
    } else if constexpr (requires { value[0]; }) {
        change_list(value, q, turn);
    }
}

template <FormulaIndex f, class Arguments> int make_change(Arguments& arguments, int number)
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    Turn turn(number);
    std::size_t i = 0;
    std::apply([&](auto&... argument) { (change_part(argument, of.arguments[i++], turn), ...); },
               arguments);
    return turn.count();
}

/// Up to `most` of the arguments that differ from these in a single part.
template <FormulaIndex f, class Arguments>
std::vector<Arguments> with_one_change(const Arguments& arguments, int most, Random& random)
{
    Arguments same = arguments;
    std::vector<int> numbers(make_change<f>(same, std::numeric_limits<int>::max()));
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<Arguments> result;
    while (!numbers.empty() && static_cast<int>(result.size()) < most) {
        std::swap(numbers[random.bits() % numbers.size()], numbers.back());
        Arguments changed = arguments;
        make_change<f>(changed, numbers.back());
        numbers.pop_back();
        if (broken_preconditions<f>(changed).empty()) result.push_back(changed);
    }
    return result;
}

} // namespace rigor::testing
