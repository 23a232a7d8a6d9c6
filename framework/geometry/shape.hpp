// SPDX-License-Identifier: MIT
// The shapes a body is made of.
#pragma once

#include "formulas/types.hpp"

#include <variant>

namespace rigor {

/// A solid ball about the origin.
struct Sphere {
    double radius = 0; // [m]
};

/// A solid box about the origin, its edges along the axes.
struct Box {
    Vector3d size = Vector3d::Zero(); // full edge lengths [m]
};

/// The half-space y ≤ 0. Static bodies only.
struct Plane {};

using Shape = std::variant<Sphere, Box, Plane>;

/// A shape placed in a body's object space. A compound body has several.
struct Part {
    Shape shape;
    Vector3d position = Vector3d::Zero(); // of the shape's origin [m]
    Quaternion orientation;
    double density = 1000; // [kg/m³]
};

} // namespace rigor
