// SPDX-License-Identifier: MIT
// Second moments about the origin or a vertex, moved by the parallel axis theorem; Jacobi's axes.
#include "formulas/inertia.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

// The moments ∫ dm, ∫ x dm and ∫ x xᵀ dm about a point.
struct Moments {
    double M = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();

    void add(double m, const Vector3d& x)
    {
        M += m;
        first += m * x;
        second += m * x * x.transpose();
    }
    MassProperties about_center(const Vector3d& origin) const
    {
        if (M == 0) return {};
        const Vector3d X = first / M;
        const Matrix3d C = second - M * X * X.transpose();
        return {M, origin + X, C.trace() * Matrix3d::Identity() - C};
    }
};

Matrix3d turned(const Matrix3d& R, const Matrix3d& A)
{
    // R A Rᵀ = Σ A_ij r_i r_jᵀ
    Matrix3d sum = Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sum += A(i, j) * R.col(i) * R.col(j).transpose();
    return sum;
}

// A solid of mass M whose principal axes are x, y and z, with the second moments M s.
MassProperties solid(double M, const Vector3d& s)
{
    const Vector3d I = M * Vector3d(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    if (particles.empty()) return {};
    const Vector3d origin = particles.front().position; // keeps the moments small
    Moments moments;
    for (auto particle = particles.rbegin(); particle != particles.rend(); ++particle)
        moments.add(particle->mass, particle->position - origin);
    return moments.about_center(origin);
}

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return turned(R, I_body);
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return turned(R, I_body_inverse);
}

PrincipalAxes principal_axes(const Matrix3d& I)
{
    // Jacobi's rotations, always at the largest entry beside the diagonal
    Matrix3d A = I, Q = Matrix3d::Identity();
    for (int step = 0; step < 60; ++step) {
        int p = 0, q = 1;
        for (const auto& [i, j] : {std::pair(0, 2), std::pair(1, 2)})
            if (std::abs(A(i, j)) > std::abs(A(p, q))) p = i, q = j;
        if (A(p, q) == 0) break;
        const double angle = std::atan2(2 * A(p, q), A(q, q) - A(p, p)) / 2;
        Matrix3d J = Matrix3d::Identity();
        J(p, p) = J(q, q) = std::cos(angle);
        J(p, q) = std::sin(angle);
        J(q, p) = -J(p, q);
        A = (J.transpose() * A * J).eval();
        A(q, p) = A(p, q) = 0;
        Q = (Q * J).eval();
    }
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return A(a, a) < A(b, b); });
    PrincipalAxes result;
    for (int i = 0; i < 3; ++i) {
        result.rotation.col(i) = Q.col(order[i]);
        result.moments[i] = std::max(A(order[i], order[i]), 0.0);
    }
    result.rotation.col(2) = result.rotation.col(0).cross(result.rotation.col(1));
    return result;
}

Vector3d invert_moments(const Vector3d& moments)
{
    Vector3d result = Vector3d::Zero();
    const double limit = 1e-12 * std::max({moments.x(), moments.y(), moments.z()});
    for (int i = 2; i >= 0; --i)
        result[i] = moments[i] <= limit ? 0.0 : 1 / moments[i];
    return result;
}

MassProperties solid_sphere(double density, double radius)
{
    const double M = density * (std::numbers::pi * std::pow(radius, 3) / 0.75);
    return solid(M, Vector3d::Constant(radius * radius / 5));
}

MassProperties solid_box(double density, const Vector3d& size)
{
    return solid(density * size.prod(), size.cwiseProduct(size) / 12);
}

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double M = height * (density * (std::numbers::pi * std::pow(radius, 2)));
    const double across = radius * radius / 4;
    return solid(M, {across, height * height / 12, across});
}

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    return solid(density * radii.prod() * (std::numbers::pi / 0.75), radii.cwiseAbs2() / 5);
}

MassProperties thin_rod(double line_density, double length)
{
    return solid(line_density * length, {0, length * length / 12, 0});
}

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    std::vector<Particle> particles;
    for (const auto& [position, density] : samples)
        particles.push_back({density * std::pow(cell_size, 3), position});
    return particle_mass_properties(particles);
}

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    std::vector<Particle> particles;
    for (const auto& [position, density] : samples)
        particles.push_back({density, position});
    MassProperties mean = particle_mass_properties(particles);
    if (samples.empty()) return mean;
    const double share = volume / static_cast<double>(samples.size());
    mean.mass *= share;
    mean.inertia *= share;
    return mean.mass == 0 ? MassProperties() : mean;
}

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    if (mesh.triangles.empty()) return {};
    // Each tetrahedron has the moments of four particles with m/20 in its corners and one with
    // 4/5 m in its center.
    const Vector3d origin = mesh.vertices[mesh.triangles.back()[2]];
    Moments moments;
    for (const auto& triangle : mesh.triangles) {
        Matrix3d x;
        for (int i = 0; i < 3; ++i)
            x.col(i) = mesh.vertices[triangle[i]] - origin;
        const double m = density * x.determinant() / 6;
        for (int i = 0; i < 3; ++i)
            moments.add(m / 20, x.col(i));
        moments.add(m / 20, Vector3d::Zero());
        moments.add(m * 4 / 5, x.rowwise().sum() / 4);
    }
    return moments.about_center(origin);
}

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0 || b.mass == 0) return a.mass == 0 ? b : a;
    // the reduced mass at the distance between the two centers
    const double M = a.mass + b.mass, mu = a.mass * (b.mass / M);
    const Vector3d d = b.center_of_mass - a.center_of_mass;
    return {M, a.center_of_mass + b.mass / M * d,
            a.inertia + b.inertia +
                mu * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose())};
}

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    Vector3d center, half;
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] =
            std::minmax_element(vertices.begin(), vertices.end(),
                                [i](const auto& a, const auto& b) { return a[i] < b[i]; });
        half[i] = ((*high)[i] - (*low)[i]) / 2;
        center[i] = (*low)[i] + half[i];
    }
    MassProperties box = solid(mass, half.cwiseAbs2() / 3);
    box.center_of_mass = center;
    return box;
}

} // namespace rigor
