// SPDX-License-Identifier: MIT
// The shapes a body is made of. Shapes of revolution have their axis along y.
#pragma once

#include "formulas/types.hpp"

#include <memory>
#include <variant>

namespace rigor {

class SolidMesh;

/// A solid ball, centered at the origin.
struct Sphere {
    double radius = 0; // [m]
};

/// A solid cylinder between two half balls, centered at the origin.
struct Capsule {
    double radius = 0; // [m]
    double height = 0; // height of the cylinder, without the half balls [m]
};

/// A solid ring with a circular cross-section, centered at the origin.
struct Torus {
    double radius = 0; // from the axis to the middle of the tube [m]
    double tube = 0;   // radius of the tube, smaller than `radius` [m]
};

/// A solid box, centered at the origin, with its edges along x, y and z.
struct Box {
    Vector3d size = Vector3d::Zero(); // full edge lengths [m]
};

/// A solid cylinder, centered at the origin.
struct Cylinder {
    double radius = 0; // [m]
    double height = 0; // [m]
};

/// A solid cone with its center of mass at the origin: the base is at y = -height/4, the tip
/// at y = 3/4 height.
struct Cone {
    double radius = 0; // radius of the base [m]
    double height = 0; // [m]
};

/// A solid ellipsoid, centered at the origin, with its semi-axes along x, y and z.
struct Ellipsoid {
    Vector3d radii = Vector3d::Zero(); // semi-axes [m]
};

/// The solid inside a closed triangle mesh, in the frame of the mesh. All bodies with the same mesh
/// share one `SolidMesh`.
struct Mesh {
    std::shared_ptr<const SolidMesh> solid; // never null
};

/// The half-space y ≤ 0. Only static bodies that are not driven have this shape.
struct Plane {};

using Shape = std::variant<Sphere, Capsule, Torus, Box, Cylinder, Cone, Ellipsoid, Mesh, Plane>;

/// A shape at its place in a body's frame. A compound body has several parts.
struct Part {
    Shape shape;
    Vector3d position = Vector3d::Zero(); // position of the shape's origin in the body's frame [m]
    Quaternion orientation;
    double density = 1000; // [kg/m³]
};

/// Volume of a shape [m³]. For a plane the result is 0, so that a plane gets no mass.
double volume(const Shape& shape);

} // namespace rigor
