// SPDX-License-Identifier: MIT
#include "rigid/box_axes.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

Vector3d oriented(const Vector3d& axis, const Vector3d& towards)
{
    return axis.dot(towards) < 0 ? Vector3d(-axis) : axis;
}

} // namespace

BoxAxis best_face(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of)
{
    BoxAxis best;
    for (int i = 0; i < 3; ++i) {
        const double separation = std::abs(of.d_a[i]) - a.half[i] - of.C_abs.row(i).dot(b.half);
        if (separation > best.separation) best = {separation, i, 0, Vector3d::Zero()};
    }
    const Vector3d n = a.R.col(best.axis1);
    best.direction = of.d_a[best.axis1] < 0 ? Vector3d(-n) : n;
    return best;
}

BoxAxis best_other_face(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of)
{
    BoxAxis best;
    for (int j = 0; j < 3; ++j) {
        const double separation = std::abs(of.d_b[j]) - b.half[j] - of.C_abs.col(j).dot(a.half);
        if (separation > best.separation) best = {separation, j, 0, Vector3d::Zero()};
    }
    const Vector3d n = b.R.col(best.axis1);
    best.direction = of.d_b[best.axis1] > 0 ? Vector3d(-n) : n;
    return best;
}

BoxAxis best_edges(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of, double least)
{
    BoxAxis best;
    best.separation = least;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double distance = std::abs(of.d_a[i2] * of.C(i1, j) - of.d_a[i1] * of.C(i2, j));
            const double reach = a.half[i1] * of.C_abs(i2, j) + a.half[i2] * of.C_abs(i1, j) +
                                 b.half[j1] * of.C_abs(i, j2) + b.half[j2] * of.C_abs(i, j1);
            const double between = distance - reach; // times the length of the axis, at most 1
            if (between <= std::min(best.separation, 0.0)) continue;
            const double c = of.C(i, j), squared = 1 - c * c; // of the length of the axis
            if (squared < 1e-6) continue;
            const double separation = between / std::sqrt(squared);
            if (separation > best.separation) best = {separation, i, j, Vector3d::Zero()};
        }
    if (best.separation > least) {
        const Vector3d l = a.R.col(best.axis1).cross(b.R.col(best.axis2)).normalized();
        best.direction = oriented(l, b.center - a.center);
    }
    return best;
}

FaceAhead best_face_ahead(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of,
                          const Vector3d& move, double slop)
{
    FaceAhead best;
    for (const bool is_of_first : {true, false})
        for (int i = 0; i < 3; ++i) {
            const PlacedBox& box = is_of_first ? a : b;
            const double d = is_of_first ? of.d_a[i] : -of.d_b[i]; // towards the other box
            const double reach =
                is_of_first ? of.C_abs.row(i).dot(b.half) : of.C_abs.col(i).dot(a.half);
            const double now = std::abs(d) - box.half[i] - reach;
            if (now < -slop) continue;
            const Vector3d out = d < 0 ? Vector3d(-box.R.col(i)) : Vector3d(box.R.col(i));
            const double then = now - (is_of_first ? 1 : -1) * move.dot(out);
            if (then > best.separation) best = {then, {now, i, 0, out}, is_of_first};
        }
    return best;
}

} // namespace rigor
