// SPDX-License-Identifier: MIT
// Triangle meshes of simple solids: closed, with triangles counter-clockwise seen from outside.
// Solids of revolution have their axis along y. All lengths are in meters.
#pragma once

#include "formulas/types.hpp"

#include <array>
#include <vector>

namespace rigor {

/// A point in a plane [m].
using PlanePoint = std::array<double, 2>;

/// A surface of revolution: a polygon turned about y in `sides` steps. A point on the axis becomes
/// one vertex.
///
/// @param profile  corners of the polygon as (distance from the axis ≥ 0, height),
///                 counter-clockwise if drawn with the distance to the right and the height upwards
TriangleMesh surface_of_revolution(const std::vector<PlanePoint>& profile, int sides);

/// An extrusion: a polygon in the plane of x and y, from z = -thickness/2 to z = thickness/2.
///
/// @param outline  (x, y), counter-clockwise seen from +z, without self-intersections
TriangleMesh extruded(const std::vector<PlanePoint>& outline, double thickness);

/// A box of twelve triangles, centered at the origin.
TriangleMesh box_mesh(const Vector3d& size);

/// A ball: an icosahedron whose triangles are each divided into four, `levels` times. All vertices
/// are on the sphere.
TriangleMesh icosphere(double radius, int levels);

/// A ring whose cross-section is a polygon of `tube_sides` sides, inscribed in a circle of radius
/// `tube`. All vertices are on the exact torus.
TriangleMesh torus_mesh(double radius, double tube, int sides, int tube_sides);

/// A ring whose cross-section is a rectangle.
TriangleMesh ring_mesh(double inner_radius, double outer_radius, double height, int sides);

/// Three bars of square cross-section along x, y and z, which cross at the origin.
///
/// @param length, width  length and width of each bar, width < length
TriangleMesh cross_mesh(double length, double width);

/// The lower half of a hollow ball, with its rim at y = 0.
/// @param thickness  thickness of the wall, less than `radius`
TriangleMesh bowl_mesh(double radius, double thickness, int sides);

/// A spur gear with trapezoidal teeth, which reach from 0.6 d below the pitch circle to 0.5 d above
/// it; d = π radius / teeth is half the circular pitch. Two gears of the same d run together with a
/// little backlash, if their axes are as far apart as the sum of their radii.
///
/// @param radius  radius of the pitch circle [m]
/// @param bore    radius of the hole, less than radius - 0.6 d; 0 for no hole [m]
TriangleMesh gear_mesh(int teeth, double radius, double bore, double thickness);

/// An angle bracket, in the shape of an L: a foot along x and a post along y. The middle of its
/// bounds is the origin.
///
/// @param size   full extent along x, y, z
/// @param width  width of foot and post, less than size x and y
TriangleMesh angle_mesh(const Vector3d& size, double width);

/// The keystone of a round arch about z: a wedge with the angle `degrees`, from the inner to the
/// outer radius. All its faces are flat. Copies turned about z by multiples of `degrees` make an
/// arch.
TriangleMesh voussoir_mesh(double inner_radius, double outer_radius, double degrees,
                           double thickness);

} // namespace rigor
