// SPDX-License-Identifier: MIT
// Triangle meshes of simple solids: closed, counter-clockwise seen from outside. What turns has its
// axis along y.
#pragma once

#include "formulas/types.hpp"

#include <array>
#include <vector>

namespace rigor {

/// A point in a plane [m].
using PlanePoint = std::array<double, 2>;

/// A polygon turned about y in `sides` steps. Points on the axis become one vertex each.
///
/// @param profile  (distance from the axis ≥ 0, height), counter-clockwise with the height up
TriangleMesh surface_of_revolution(const std::vector<PlanePoint>& profile, int sides);

/// A polygon in the plane of x and y, `thickness` thick along z about z = 0.
///
/// @param outline  (x, y), counter-clockwise seen from +z, crossing itself nowhere
TriangleMesh extruded(const std::vector<PlanePoint>& outline, double thickness);

/// A box of twelve triangles about the origin.
TriangleMesh box_mesh(const Vector3d& size);

/// A ball as an icosahedron whose triangles are cut in four `levels` times, its vertices on the sphere.
TriangleMesh icosphere(double radius, int levels);

/// A ring whose section is a circle of radius `tube`, as polygons with vertices on the circles.
TriangleMesh torus_mesh(double radius, double tube, int sides, int tube_sides);

/// A ring whose section is a rectangle.
TriangleMesh ring_mesh(double inner_radius, double outer_radius, double height, int sides);

/// Three square bars along x, y and z that are one in the middle.
///
/// @param length, width  of a bar, width < length
TriangleMesh cross_mesh(double length, double width);

/// The lower half of a hollow ball, its rim at y = 0. @param thickness  < radius
TriangleMesh bowl_mesh(double radius, double thickness, int sides);

/// A gear wheel with trapezoid teeth, from 0.6 d below the pitch circle to 0.5 d above it, where
/// d = π radius / teeth is half the distance of two teeth. Two of the same d mesh at the sum of their
/// radii, with a little play.
///
/// @param radius  of the pitch circle [m]
/// @param bore    radius of the hole, less than radius - 0.6 d; 0: none [m]
TriangleMesh gear_mesh(int teeth, double radius, double bore, double thickness);

/// An L: a foot along x and a post along y, about the middle of its bounds.
///
/// @param size   full extent along x, y, z
/// @param width  of foot and post, less than size x and y
TriangleMesh angle_mesh(const Vector3d& size, double width);

/// A stone of a round arch about z, at the top of the arch: what a wedge of so many degrees holds
/// between two radii, with flat faces. Turned about z by multiples of `degrees` the stones make an arch.
TriangleMesh voussoir_mesh(double inner_radius, double outer_radius, double degrees,
                           double thickness);

} // namespace rigor
