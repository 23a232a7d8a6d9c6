// SPDX-License-Identifier: MIT
// Axes along which two boxes are apart, or overlap least: of the 15 of Gottschalk, Lin and Manocha
// (1996, "OBBTree: a hierarchical structure for rapid interference detection").
#pragma once

#include "formulas/types.hpp"

#include <limits>

namespace rigor {

/// A box at its place; its axes are the columns of R.
struct PlacedBox {
    Matrix3d R;
    Vector3d center, half;
};

/// A separating axis, unit, pointing from box 1 to box 2, with the distance of the boxes along it.
struct BoxAxis {
    double separation = -std::numeric_limits<double>::infinity();
    int axis1 = 0, axis2 = 0;
    Vector3d direction = Vector3d::Zero();
};

/// The two boxes in numbers that every axis needs: C = AᵀB, |C|, and the distance of the centers in the
/// frame of either.
struct BoxRelation {
    Matrix3d C, C_abs;
    Vector3d d_a, d_b;

    BoxRelation(const PlacedBox& a, const PlacedBox& b)
    {
        const Vector3d d = b.center - a.center;
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i)
                C(i, j) = a.R.col(i).dot(b.R.col(j));
            d_a[j] = a.R.col(j).dot(d);
            d_b[j] = b.R.col(j).dot(d);
        }
        C_abs = C.cwiseAbs();
    }
};

/// The best of the three faces of `a`; the direction points towards b.
BoxAxis best_face(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of);

/// The best of the three faces of `b`, its axis in `axis1`; the direction points towards a.
BoxAxis best_other_face(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of);

/// The best of the nine pairs of edges, if it is better than `least`. Parallel edges separate no better
/// than a face does.
BoxAxis best_edges(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of, double least);

/// A face that separates the boxes, and how far it will when they have moved on.
struct FaceAhead {
    double separation = -std::numeric_limits<double>::infinity();
    BoxAxis axis;
    bool is_of_first = true;
};

/// Of the faces that separate the boxes now, to `slop`, the one that will have them overlap least.
/// @param move  of box 1, against box 2, in the step to come [m]
FaceAhead best_face_ahead(const PlacedBox& a, const PlacedBox& b, const BoxRelation& of,
                          const Vector3d& move, double slop);

} // namespace rigor
