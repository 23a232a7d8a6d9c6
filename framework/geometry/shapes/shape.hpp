// SPDX-License-Identifier: MIT
// The shapes a body is made of. Shapes of revolution have their axis along y.
#pragma once

#include "formulas/types.hpp"

#include <memory>
#include <variant>

namespace rigor {

class SolidMesh;

/// A solid ball about the origin.
struct Sphere {
    double radius = 0; // [m]
};

/// A cylinder between two half balls, about the origin.
struct Capsule {
    double radius = 0; // [m]
    double height = 0; // without the half balls [m]
};

/// A ring of circular section about the origin.
struct Torus {
    double radius = 0; // from the axis to the middle of the tube [m]
    double tube = 0;   // radius of the tube, smaller than `radius` [m]
};

/// A solid box about the origin, its edges along the axes.
struct Box {
    Vector3d size = Vector3d::Zero(); // full edge lengths [m]
};

/// A solid cylinder about the origin.
struct Cylinder {
    double radius = 0; // [m]
    double height = 0; // [m]
};

/// A solid cone about its center of mass: the base at y = -height/4, the tip at y = 3/4 height.
struct Cone {
    double radius = 0; // radius of the base [m]
    double height = 0; // [m]
};

/// A solid ellipsoid about the origin, its semi-axes along the axes.
struct Ellipsoid {
    Vector3d radii = Vector3d::Zero(); // semi-axes [m]
};

/// The solid inside a closed triangle mesh, in the frame of the mesh. All bodies with the same mesh
/// share one `SolidMesh`.
struct Mesh {
    std::shared_ptr<const SolidMesh> solid; // never null
};

/// The half-space y ≤ 0. Static bodies only.
struct Plane {};

using Shape = std::variant<Sphere, Capsule, Torus, Box, Cylinder, Cone, Ellipsoid, Mesh, Plane>;

/// A shape at its place in a body's frame. A compound body has several.
struct Part {
    Shape shape;
    Vector3d position = Vector3d::Zero(); // position of the shape's origin in the body's frame [m]
    Quaternion orientation;
    double density = 1000; // [kg/m³]
};

/// Volume of a shape [m³]. That of a plane is 0, because it has no mass.
double volume(const Shape& shape);

} // namespace rigor
