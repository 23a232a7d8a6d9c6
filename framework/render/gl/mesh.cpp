// SPDX-License-Identifier: MIT
// Meshes of unit solids: a cube with flat faces, a ball as an octahedron that is subdivided again
// and again, and a cylinder or cone with 16 sides. One call draws all instances of a mesh.
#include "render/gl/mesh.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace rigor {
namespace {

// Sets an attribute of the shaders. For each vertex: 0 position, 1 normal, 7 edges. For each
// instance: 2, 3, 4 axes, 5 position, 6 color (which a deforming surface has for each vertex).
void attribute(GLuint index, int size, std::size_t stride, std::size_t offset, GLuint divisor)
{
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(index, divisor);
}

void add_flat(std::vector<SurfaceVertex>& mesh, const Vector3f& a, const Vector3f& b,
              const Vector3f& c)
{
    const Vector3f normal = (b - a).cross(c - a).normalized();
    for (const Vector3f& corner : {a, b, c})
        mesh.push_back({corner, normal});
}

void add_round(std::vector<SurfaceVertex>& mesh, const Vector3f& a, const Vector3f& b,
               const Vector3f& c, int levels)
{
    if (levels == 0) {
        for (const Vector3f& corner : {a, b, c})
            mesh.push_back({corner, corner});
        return;
    }
    const Vector3f ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
    add_round(mesh, a, ab, ca, levels - 1);
    add_round(mesh, ab, b, bc, levels - 1);
    add_round(mesh, ca, bc, c, levels - 1);
    add_round(mesh, ab, bc, ca, levels - 1);
}

} // namespace

std::vector<SurfaceVertex> cube_mesh()
{
    std::vector<SurfaceVertex> mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0F, 1.0F}) {
            const Vector3f n = side * Vector3f::Unit(axis), u = Vector3f::Unit((axis + 1) % 3);
            const Vector3f v = n.cross(u);
            add_flat(mesh, n - u - v, n + u - v, n + u + v);
            add_flat(mesh, n - u - v, n + u + v, n - u + v);
        }
    }
    return mesh;
}

std::vector<SurfaceVertex> ball_mesh(int levels)
{
    std::vector<SurfaceVertex> mesh;
    for (const float x : {-1.0F, 1.0F}) {
        for (const float y : {-1.0F, 1.0F}) {
            for (const float z : {-1.0F, 1.0F}) {
                const Vector3f a = x * Vector3f::UnitX(), b = y * Vector3f::UnitY(),
                               c = z * Vector3f::UnitZ();
                if (x * y * z > 0)
                    add_round(mesh, a, b, c, levels);
                else
                    add_round(mesh, a, c, b, levels);
            }
        }
    }
    return mesh;
}

std::vector<SurfaceVertex> rod_mesh(bool pointed)
{
    constexpr int sides = 16; // more would make rods rounder, but take time; rods are thin
    const Vector3f top = Vector3f::UnitZ();
    std::vector<SurfaceVertex> mesh;
    const auto rim = [](int side) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / sides;
        return Vector3f(std::cos(angle), std::sin(angle), 0);
    };
    for (int side = 0; side < sides; ++side) {
        const Vector3f a = rim(side), b = rim(side + 1);
        const Vector3f up = pointed ? top : Vector3f::Zero(); // normals of a cone lean to its tip
        const Vector3f n_a = (a + up).normalized(), n_b = (b + up).normalized();
        add_flat(mesh, Vector3f::Zero(), b, a);
        mesh.insert(mesh.end(), {{a, n_a}, {b, n_b}, {pointed ? top : b + top, n_b}});
        if (pointed) continue;
        mesh.insert(mesh.end(), {{a, n_a}, {b + top, n_b}, {a + top, n_a}});
        add_flat(mesh, top, a + top, b + top);
    }
    return mesh;
}

SolidDrawing::SolidDrawing(const std::vector<SurfaceVertex>& triangles)
    : count_(static_cast<GLsizei>(triangles.size()))
{
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(SurfaceVertex)),
                 triangles.data(), GL_STATIC_DRAW);
    attribute(0, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, position), 0);
    attribute(1, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, normal), 0);
    attribute(7, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, edges), 0);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    for (GLuint column = 0; column < 3; ++column)
        attribute(2 + column, 3, sizeof(Instance), 3 * sizeof(float) * column, 1);
    attribute(5, 3, sizeof(Instance), 9 * sizeof(float), 1);
    attribute(6, 4, sizeof(Instance), 12 * sizeof(float), 1);
}

void SolidDrawing::draw(std::span<const Instance> instances)
{
    static_assert(sizeof(Instance) == 16 * sizeof(float));
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
                 GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLES, 0, count_, static_cast<GLsizei>(instances.size()));
}

DeformedDrawing::DeformedDrawing()
{
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    attribute(0, 3, sizeof(DeformedVertex), offsetof(DeformedVertex, position), 0);
    attribute(1, 3, sizeof(DeformedVertex), offsetof(DeformedVertex, normal), 0);
    attribute(7, 3, sizeof(DeformedVertex), offsetof(DeformedVertex, edges), 0);
    attribute(6, 4, sizeof(DeformedVertex), offsetof(DeformedVertex, color), 0);
}

void DeformedDrawing::send(std::span<const DeformedVertex> triangles)
{
    count_ = static_cast<GLsizei>(triangles.size());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(),
                 GL_STREAM_DRAW);
}

void DeformedDrawing::draw() const
{
    if (count_ == 0) return;
    glBindVertexArray(arrays_);
    glVertexAttrib3f(2, 1, 0, 0); // one instance without rotation: corners are in the world frame
    glVertexAttrib3f(3, 0, 1, 0);
    glVertexAttrib3f(4, 0, 0, 1);
    glVertexAttrib3f(5, 0, 0, 0);
    glDrawArrays(GL_TRIANGLES, 0, count_);
}

FlatDrawing::FlatDrawing()
{
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    attribute(0, 2, sizeof(Eigen::Vector2f), 0, 0);
}

void FlatDrawing::draw(std::span<const Eigen::Vector2f> triangles)
{
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(),
                 GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
}

} // namespace rigor
