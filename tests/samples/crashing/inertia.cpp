// SPDX-License-Identifier: MIT
// A sample submission: one function crashes, one never returns, and one is a stub. The others are
// right and get their points.
#include "formulas/inertia.hpp"

#include <cmath>

namespace rigor {

namespace {

const double pi = std::acos(-1.0);

Matrix3d point_inertia(double mass, const Vector3d& d)
{
    return mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
}

MassProperties solid(double mass, double Ixx, double Iyy, double Izz)
{
    return {mass, Vector3d::Zero(), Vector3d(Ixx, Iyy, Izz).asDiagonal()};
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    double M = 0;
    Vector3d X = Vector3d::Zero();
    for (const Particle& p : particles) {
        M += p.mass;
        X += p.mass * p.position;
    }
    if (M == 0) return {};
    X /= M;
    Matrix3d I = Matrix3d::Zero();
    for (const Particle& p : particles)
        I += point_inertia(p.mass, p.position - X);
    return {M, X, I};
}

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return R * I_body * R.transpose();
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return R * I_body_inverse * R.transpose();
}

// Mistake: Jacobi's rotation has the wrong sign. The entries that it should remove grow again, so
// the loop never ends.
PrincipalAxes principal_axes(const Matrix3d& I)
{
    Matrix3d A = I, Q = Matrix3d::Identity();
    while (std::abs(A(0, 1)) + std::abs(A(0, 2)) + std::abs(A(1, 2)) > 1e-14 * A.norm())
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                const double angle = -0.5 * std::atan2(2 * A(p, q), A(q, q) - A(p, p));
                Matrix3d J = Matrix3d::Identity();
                J(p, p) = J(q, q) = std::cos(angle);
                J(p, q) = std::sin(angle);
                J(q, p) = -std::sin(angle);
                A = J.transpose() * A * J;
                Q = Q * J;
            }
    return {Q, A.diagonal()};
}

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d result = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (moments[i] > 1e-12 * moments.maxCoeff()) result[i] = 1 / moments[i];
    return result;
}

MassProperties solid_sphere(double density, double radius)
{
    const double M = density * 4 / 3 * pi * radius * radius * radius, I = 0.4 * M * radius * radius;
    return solid(M, I, I, I);
}

MassProperties solid_box(double density, const Vector3d& size)
{
    const double a = size[0], b = size[1], c = size[2], M = density * a * b * c;
    return solid(M, M / 12 * (b * b + c * c), M / 12 * (a * a + c * c), M / 12 * (a * a + b * b));
}

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double M = density * pi * radius * radius * height;
    const double across = M / 12 * (3 * radius * radius + height * height);
    return solid(M, across, M / 2 * radius * radius, across);
}

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    const double a = radii[0], b = radii[1], c = radii[2], M = density * 4 / 3 * pi * a * b * c;
    return solid(M, M / 5 * (b * b + c * c), M / 5 * (a * a + c * c), M / 5 * (a * a + b * b));
}

MassProperties thin_rod(double line_density, double length)
{
    const double M = line_density * length;
    return solid(M, M * length * length / 12, 0, M * length * length / 12);
}

// Mistake: the list of samples may be empty.
MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    const Vector3d origin = samples[0].position;
    std::vector<Particle> cells;
    for (const DensitySample& sample : samples)
        cells.push_back(
            {sample.density * cell_size * cell_size * cell_size, sample.position - origin});
    MassProperties result = particle_mass_properties(cells);
    if (result.mass != 0) result.center_of_mass += origin;
    return result;
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
    throw NotImplemented("inertia::mesh_mass_properties");
}

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;
    const double M = a.mass + b.mass;
    const Vector3d X = (a.mass * a.center_of_mass + b.mass * b.center_of_mass) / M;
    return {M, X,
            a.inertia + point_inertia(a.mass, a.center_of_mass - X) + b.inertia +
                point_inertia(b.mass, b.center_of_mass - X)};
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
