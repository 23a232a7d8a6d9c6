// SPDX-License-Identifier: MIT
// Changes of one place of the arguments by the numbers of another.
#include "diagnosis/transforms.hpp"

#include <fmt/format.h>

namespace rigor::diagnosis {

namespace {

using V = Eigen::Map<Vector3d>;
using M = Eigen::Map<Matrix3d>;

Matrix3d matrix_of(Changeable q)
{
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

bool is_finite(Changeable numbers)
{
    return Eigen::Map<Eigen::VectorXd>(numbers.data(), static_cast<int>(numbers.size()))
        .allFinite();
}

void add_same_shape(std::vector<PairChange>& changes, const Role& a, const Role& b)
{
    const bool same_unit = a.quantity.dimension == b.quantity.dimension;
    changes.push_back({fmt::format("`{}` in the place of `{}`", b.name, a.name), "",
                       [](Changeable x, Changeable y) {
                           std::copy(y.begin(), y.end(), x.begin());
                           return true;
                       }});
    if (a.name < b.name)
        changes.push_back({fmt::format("`{}` and `{}` exchanged", a.name, b.name),
                           "they may have changed places", [](Changeable x, Changeable y) {
                               std::swap_ranges(x.begin(), x.end(), y.begin());
                               return true;
                           }});
    if (a.form != Form::real || !same_unit) return;
    for (const int sign : {-1, 1})
        changes.push_back(
            {fmt::format("`{}` {} `{}` in the place of `{}`", a.name, sign < 0 ? "-" : "+", b.name,
                         a.name),
             sign < 0 ? "a difference may be subtracted twice" : "a difference may be missing",
             [sign](Changeable x, Changeable y) {
                 for (std::size_t i = 0; i < x.size(); ++i)
                     x[i] += sign * y[i];
                 return true;
             }});
}

// The product M v in the place of v, or M⁻¹ v, and for rotations Mᵀ v.
void add_turned(std::vector<PairChange>& changes, const Role& v, const Role& by,
                const std::function<Matrix3d(Changeable)>& matrix)
{
    const bool is_rotation = by.form == Form::quaternion || by.quantity.kind == Kind::rotation;
    const std::string advice = is_rotation ? "it may be in the wrong frame" : "";
    changes.push_back({is_rotation ? fmt::format("`{}` turned by `{}`", v.name, by.name)
                                   : fmt::format("`{}` multiplied by `{}`", v.name, by.name),
                       advice, [matrix](Changeable x, Changeable y) {
                           V(x.data()) = (matrix(y) * V(x.data())).eval();
                           return true;
                       }});
    changes.push_back({is_rotation
                           ? fmt::format("`{}` turned by the inverse of `{}`", v.name, by.name)
                           : fmt::format("`{}` multiplied by the inverse of `{}`", v.name, by.name),
                       advice, [matrix](Changeable x, Changeable y) {
                           V(x.data()) = (matrix(y).inverse() * V(x.data())).eval();
                           return is_finite(x);
                       }});
}

void add_turned_matrix(std::vector<PairChange>& changes, const Role& A, const Role& by,
                       const std::function<Matrix3d(Changeable)>& matrix)
{
    for (const bool inverse : {false, true})
        changes.push_back({fmt::format("`{}` turned by {}`{}`", A.name,
                                       inverse ? "the inverse of " : "", by.name),
                           "it may be in the wrong frame", [=](Changeable x, Changeable y) {
                               const Matrix3d Q = matrix(y);
                               const Matrix3d R = inverse ? Matrix3d(Q.transpose()) : Q;
                               M(x.data()) = (R * M(x.data()) * R.transpose()).eval();
                               return true;
                           }});
}

void add_parts(std::vector<PairChange>& changes, const Role& v, const Role& n)
{
    changes.push_back({fmt::format("only the part of `{}` along `{}`", v.name, n.name), "",
                       [](Changeable x, Changeable y) {
                           V(x.data()) = V(x.data()).dot(V(y.data())) * V(y.data()).eval();
                           return true;
                       }});
    changes.push_back({fmt::format("only the part of `{}` across `{}`", v.name, n.name), "",
                       [](Changeable x, Changeable y) {
                           V(x.data()) -= V(x.data()).dot(V(y.data())) * V(y.data()).eval();
                           return true;
                       }});
}

} // namespace

std::vector<PairChange> changes_of(const Role& changed, const Role& by)
{
    std::vector<PairChange> changes;
    if (changed.same_shape(by)) add_same_shape(changes, changed, by);
    if (changed.form != Form::real) return changes;
    const auto matrix = by.form == Form::quaternion
                            ? std::function<Matrix3d(Changeable)>(matrix_of)
                            : [](Changeable y) { return Matrix3d(M(y.data())); };
    const bool has_matrix = by.form == Form::quaternion || (by.is_matrix() && by.rows == 3);
    if (has_matrix && changed.is_vector()) add_turned(changes, changed, by, matrix);
    const bool is_rotation = by.form == Form::quaternion || by.quantity.kind == Kind::rotation;
    if (is_rotation && changed.is_matrix() && changed.rows == 3)
        add_turned_matrix(changes, changed, by, matrix);
    if (changed.is_vector() && by.is_vector() && by.quantity.kind == Kind::unit)
        add_parts(changes, changed, by);
    return changes;
}

} // namespace rigor::diagnosis
