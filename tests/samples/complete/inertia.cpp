// SPDX-License-Identifier: MIT
// A sample submission that is complete and is not written like the reference.
#include "formulas/inertia.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

const double pi = std::acos(-1.0);

// Parallel-axis theorem: the inertia that a mass adds if its center is displaced by d.
Matrix3d shifted(double mass, const Vector3d& d)
{
    Matrix3d result;
    result << d.y() * d.y() + d.z() * d.z(), -d.x() * d.y(), -d.x() * d.z(), //
        -d.x() * d.y(), d.x() * d.x() + d.z() * d.z(), -d.y() * d.z(),       //
        -d.x() * d.z(), -d.y() * d.z(), d.x() * d.x() + d.y() * d.y();
    return mass * result;
}

MassProperties about_center(double mass, double Ixx, double Iyy, double Izz)
{
    MassProperties result;
    result.mass = mass;
    result.inertia.diagonal() << Ixx, Iyy, Izz;
    return result;
}

// A tetrahedron with one corner at the origin and density 1. Its volume may be negative.
struct Tetrahedron {
    double volume;
    Vector3d center;
    Matrix3d second_moment; // ∫ x xᵀ dV
};

Tetrahedron tetrahedron(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
    const double volume = a.cross(b).dot(c) / 6;
    const Vector3d center = (a + b + c) / 4;
    const Matrix3d second = volume / 20 *
                            (16 * center * center.transpose() + a * a.transpose() +
                             b * b.transpose() + c * c.transpose());
    return {volume, center, second};
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    MassProperties result;
    for (const Particle& p : particles)
        result.mass += p.mass;
    if (result.mass == 0) return MassProperties();
    for (const Particle& p : particles)
        result.center_of_mass += p.mass / result.mass * p.position;
    for (const Particle& p : particles)
        result.inertia += shifted(p.mass, p.position - result.center_of_mass);
    return result;
}

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    const Matrix3d half = R * I_body;
    return half * R.transpose();
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return R * (I_body_inverse * R.transpose());
}

PrincipalAxes principal_axes(const Matrix3d& I)
{
    Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
    PrincipalAxes axes;
    axes.moments = solver.eigenvalues();
    axes.rotation.col(0) = solver.eigenvectors().col(0);
    axes.rotation.col(1) = solver.eigenvectors().col(1);
    axes.rotation.col(2) = axes.rotation.col(0).cross(axes.rotation.col(1)); // right-handed
    for (int i = 0; i < 3; ++i)
        axes.moments[i] = std::max(axes.moments[i], 0.0);
    return axes;
}

Vector3d invert_moments(const Vector3d& moments)
{
    const double largest = std::max({moments[0], moments[1], moments[2]});
    const auto inverse = [&](double m) { return m <= 1e-12 * largest ? 0.0 : 1 / m; };
    return {inverse(moments[0]), inverse(moments[1]), inverse(moments[2])};
}

MassProperties solid_sphere(double density, double radius)
{
    const double mass = density * 4 * pi * std::pow(radius, 3) / 3;
    const double I = 0.4 * mass * radius * radius;
    return about_center(mass, I, I, I);
}

MassProperties solid_box(double density, const Vector3d& size)
{
    const double mass = density * size.prod();
    const Vector3d s = size.cwiseAbs2() / 12;
    return about_center(mass, mass * (s.y() + s.z()), mass * (s.z() + s.x()),
                        mass * (s.x() + s.y()));
}

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double mass = density * pi * radius * radius * height;
    const double across = mass * (radius * radius / 4 + height * height / 12);
    return about_center(mass, across, mass * radius * radius / 2, across);
}

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    const double mass = density * 4 * pi * radii.prod() / 3;
    const Vector3d s = radii.cwiseAbs2() / 5;
    return about_center(mass, mass * (s.y() + s.z()), mass * (s.z() + s.x()),
                        mass * (s.x() + s.y()));
}

MassProperties thin_rod(double line_density, double length)
{
    const double mass = line_density * length;
    return about_center(mass, mass * length * length / 12, 0, mass * length * length / 12);
}

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    std::vector<Particle> cells;
    for (const DensitySample& sample : samples)
        cells.push_back({sample.density * std::pow(cell_size, 3), sample.position});
    return particle_mass_properties(cells);
}

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    std::vector<Particle> shares;
    for (const DensitySample& sample : samples)
        shares.push_back(
            {sample.density * volume / static_cast<double>(samples.size()), sample.position});
    return particle_mass_properties(shares);
}

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    if (mesh.vertices.empty() || density == 0) return MassProperties();
    Vector3d middle = Vector3d::Zero(); // keeps the tetrahedra small, wherever the body is
    for (const Vector3d& vertex : mesh.vertices)
        middle += vertex / static_cast<double>(mesh.vertices.size());

    double volume = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();
    for (const auto& corners : mesh.triangles) {
        const Tetrahedron t =
            tetrahedron(mesh.vertices[corners[0]] - middle, mesh.vertices[corners[1]] - middle,
                        mesh.vertices[corners[2]] - middle);
        volume += t.volume;
        first += t.volume * t.center;
        second += t.second_moment;
    }
    if (volume == 0) return MassProperties();

    MassProperties result;
    result.mass = density * volume;
    const Vector3d center = first / volume;
    result.center_of_mass = middle + center;
    const Matrix3d spread = density * (second - volume * center * center.transpose());
    result.inertia = spread.trace() * Matrix3d::Identity() - spread;
    return result;
}

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (b.mass == 0) return a;
    if (a.mass == 0) return b;
    MassProperties both;
    both.mass = a.mass + b.mass;
    both.center_of_mass =
        a.center_of_mass + b.mass / both.mass * (b.center_of_mass - a.center_of_mass);

    // The shifts of both bodies to the common center add up to that of the reduced mass by the
    // distance of their centers.
    const double reduced = a.mass * b.mass / both.mass;
    both.inertia = a.inertia + b.inertia + shifted(reduced, b.center_of_mass - a.center_of_mass);
    return both;
}

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    Vector3d low = vertices.front(), high = low;
    for (const Vector3d& vertex : vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const Vector3d s = (high - low).cwiseAbs2();
    const Vector3d I = mass / 12 * Vector3d(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
    return {mass, (low + high) / 2, I.asDiagonal()};
}

} // namespace rigor
