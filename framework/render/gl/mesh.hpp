// SPDX-License-Identifier: MIT
// The meshes of unit solids, and drawing many instances of a mesh at once.
#pragma once

#include "render/gl/gl.hpp"
#include "render/picture.hpp"

#include <span>
#include <vector>

namespace rigor {

/// A cube from -1 to 1 with flat faces.
std::vector<SurfaceVertex> cube_mesh();

/// A ball of radius 1: an octahedron whose edges are halved `levels` times.
std::vector<SurfaceVertex> ball_mesh(int levels);

/// A closed cylinder or cone of radius 1 about z, from z = 0 to z = 1.
std::vector<SurfaceVertex> rod_mesh(bool pointed);

/// A mesh in the memory of the graphics library, drawn once for each instance.
class SolidDrawing {
public:
    explicit SolidDrawing(const std::vector<SurfaceVertex>& triangles);
    void draw(std::span<const Instance> instances);

private:
    GlArrays arrays_;
    GlBuffer vertices_, instances_;
    GLsizei count_;
};

/// Triangles in the world frame, sent again for each picture.
class DeformedDrawing {
public:
    DeformedDrawing();
    void send(std::span<const DeformedVertex> triangles);
    void draw() const;

private:
    GlArrays arrays_;
    GlBuffer vertices_;
    GLsizei count_ = 0;
};

/// Triangles on a ground, sent again for each picture.
class FlatDrawing {
public:
    FlatDrawing();
    void draw(std::span<const Eigen::Vector2f> triangles);

private:
    GlArrays arrays_;
    GlBuffer vertices_;
};

} // namespace rigor
