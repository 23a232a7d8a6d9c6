// SPDX-License-Identifier: MIT
// Computes the volume of each shape in closed form. The volume of a mesh is stored with the mesh.
#include "geometry/shapes/shape.hpp"

#include "geometry/shapes/solid_mesh.hpp"

#include <numbers>

namespace rigor {

namespace {

constexpr double pi = std::numbers::pi;

struct Volume {
    double operator()(const Sphere& s) const
    {
        return 4.0 / 3 * pi * s.radius * s.radius * s.radius;
    }
    double operator()(const Capsule& c) const
    {
        return pi * c.radius * c.radius * (c.height + 4.0 / 3 * c.radius);
    }
    double operator()(const Torus& t) const { return 2 * pi * pi * t.radius * t.tube * t.tube; }
    double operator()(const Box& b) const { return b.size.prod(); }
    double operator()(const Cylinder& c) const { return pi * c.radius * c.radius * c.height; }
    double operator()(const Cone& c) const { return pi / 3 * c.radius * c.radius * c.height; }
    double operator()(const Ellipsoid& e) const { return 4.0 / 3 * pi * e.radii.prod(); }
    double operator()(const Mesh& m) const { return m.solid->volume(); }
    double operator()(const Plane&) const { return 0; }
};

} // namespace

double volume(const Shape& shape)
{
    return std::visit(Volume{}, shape);
}

} // namespace rigor
