// SPDX-License-Identifier: MIT
// Bodies and worlds for the stress cases.
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor::stress {

inline constexpr double g = 9.81;         // [m/s²]
inline constexpr double frame = 1.0 / 60; // the usual time step [s]
inline constexpr Material rough{0, 0.5};  // ε, μ

/// A world whose contacts are solved all at once, with all skips except sleep.
World world_of(std::vector<RigidBody> bodies, const Vector3d& gravity = {0, -g, 0});

RigidBody body_of(const Shape& shape, const Vector3d& X, const Material& material = rough,
                  const Quaternion& q = {}, double density = 1000);
RigidBody fixed(const Shape& shape, const Vector3d& X = {0, 0, 0}, const Material& material = rough,
                const Quaternion& q = {});

/// A cube with this edge length.
Box cube(double edge);

/// A slab made of triangles below y = 0, `width` wide and 1 m thick. Its top and bottom are divided
/// into n × n squares.
Mesh slab(int n, double width);

/// The half-space below y = 0.
RigidBody ground(const Material& material = rough);

Quaternion turn(const Vector3d& axis, double angle);

/// Sets the angular momentum: L = I(t) ω.
void spin(RigidBody& body, const Vector3d& angular_velocity);

/// n cubes stacked on the ground, whose faces touch.
World stack(int n, double edge = 1, const Vector3d& foot = {0, 0, 0});

/// n³ cubes of edge 1 with random orientations that fall onto the ground.
World falling_pile(int n, const Material& material, unsigned seed = 1);

} // namespace rigor::stress
