// SPDX-License-Identifier: MIT
// A sample submission that is half done, with common mistakes.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

namespace {

const double pi = std::acos(-1.0);

MassProperties about_origin(double mass, const Vector3d& moments)
{
    return {mass, Vector3d::Zero(), moments.asDiagonal()};
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    MassProperties result;
    for (const Particle& p : particles) {
        result.mass += p.mass;
        result.center_of_mass += p.mass * p.position;
    }
    if (result.mass == 0) return MassProperties();
    result.center_of_mass /= result.mass;
    for (const Particle& p : particles) {
        const Vector3d d = p.position - result.center_of_mass;
        result.inertia += p.mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return result;
}

// Mistake: this turns from world to object space instead of from object to world space.
Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R.transpose() * I_body * R;
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return R * I_body_inverse * R.transpose();
}

PrincipalAxes principal_axes(const Matrix3d& I)
{
    throw NotImplemented("inertia::principal_axes");
}

// Mistake: this divides by 0, since a rod has a moment of 0.
Vector3d invert_moments(const Vector3d& moments)
{
    return moments.cwiseInverse();
}

MassProperties solid_sphere(double density, double radius)
{
    const double m = density * 4 / 3 * pi * radius * radius * radius;
    return about_origin(m, 0.4 * m * radius * radius * Vector3d::Ones());
}

MassProperties solid_box(double density, const Vector3d& size)
{
    const double m = density * size[0] * size[1] * size[2];
    const double a = size[0] * size[0], b = size[1] * size[1], c = size[2] * size[2];
    return about_origin(m, m / 12 * Vector3d(b + c, a + c, a + b));
}

// Mistake: the axis of the cylinder is z here instead of y.
MassProperties solid_cylinder(double density, double radius, double height)
{
    const double m = density * pi * radius * radius * height;
    const double across = m / 12 * (3 * radius * radius + height * height);
    return about_origin(m, Vector3d(across, across, m / 2 * radius * radius));
}

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    const double m = density * 4 / 3 * pi * radii[0] * radii[1] * radii[2];
    const double a = radii[0] * radii[0], b = radii[1] * radii[1], c = radii[2] * radii[2];
    return about_origin(m, m / 5 * Vector3d(b + c, a + c, a + b));
}

MassProperties thin_rod(double line_density, double length)
{
    const double m = line_density * length;
    return about_origin(m, Vector3d(m * length * length / 12, 0, m * length * length / 12));
}

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    throw NotImplemented("inertia::grid_mass_properties");
}

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    throw NotImplemented("inertia::sampled_mass_properties");
}

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    throw NotImplemented("inertia::mesh_mass_properties");
}

// Mistake: this adds inertias about different points.
MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    MassProperties both;
    both.mass = a.mass + b.mass;
    if (both.mass == 0) return both;
    both.center_of_mass = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / both.mass;
    both.inertia = a.inertia + b.inertia;
    return both;
}

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>&, double)
{
    throw NotImplemented("inertia::bounding_box_mass_properties");
}

} // namespace rigor
