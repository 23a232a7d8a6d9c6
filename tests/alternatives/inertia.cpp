// SPDX-License-Identifier: MIT
// Particles added one by one, I = Tr(C) δ - C, Jacobi's eigenvectors, Gauss points in tetrahedra.
// C = ∫ ρ d dᵀ dV are the second moments. Principal axes come from Jacobi's rotations. A mesh is
// replaced by four Gauss points in each signed tetrahedron, which are exact for quadratic
// functions.
#include "formulas/inertia.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

const double pi = std::acos(-1.0);

// I = Tr(C) δ - C for C = ∫ ρ d dᵀ dV
Matrix3d inertia_of(const Matrix3d& C)
{
    return C.trace() * Matrix3d::Identity() - C;
}

// A solid of mass M whose principal axes are x, y and z, with ∫ ρ dᵢ² dV = M sᵢ.
MassProperties solid(double M, const Vector3d& s)
{
    return {M, Vector3d::Zero(), inertia_of((M * s).asDiagonal())};
}

// Mass properties of particles by their definition, where masses may be negative.
MassProperties weighted(const std::vector<Particle>& particles)
{
    double M = 0;
    for (const Particle& particle : particles)
        M += particle.mass;
    if (M == 0) return {};
    Vector3d X = Vector3d::Zero();
    for (const Particle& particle : particles)
        X += particle.mass / M * particle.position;
    Matrix3d C = Matrix3d::Zero();
    for (const Particle& particle : particles) {
        const Vector3d d = particle.position - X;
        C += particle.mass * d * d.transpose();
    }
    return {M, X, inertia_of(C)};
}

// One of Jacobi's rotations in the plane (p, q), which makes A(p, q) zero.
void rotate_away(Matrix3d& A, Matrix3d& Q, int p, int q)
{
    if (A(p, q) == 0) return;
    const double theta = (A(q, q) - A(p, p)) / (2 * A(p, q));
    const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::hypot(theta, 1.0));
    const double c = 1 / std::hypot(t, 1.0);
    const Eigen::JacobiRotation<double> J(c, t * c);
    A.applyOnTheLeft(p, q, J.adjoint());
    A.applyOnTheRight(p, q, J);
    Q.applyOnTheRight(p, q, J);
    A(p, q) = A(q, p) = 0;
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    // each particle joins those before it: I += m M/(m + M) (d² δ - d dᵀ)
    MassProperties all;
    for (const Particle& particle : particles)
        all = combine(all, {particle.mass, particle.position, Matrix3d::Zero()});
    return all;
}

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    // Σ Iᵢⱼ rᵢ rⱼᵀ over the columns of R
    Matrix3d I = Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            I += I_body(i, j) * R.col(i) * R.col(j).transpose();
    return I;
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return R * (R * I_body_inverse.transpose()).transpose();
}

PrincipalAxes principal_axes(const Matrix3d& I)
{
    Matrix3d A = I, Q = Matrix3d::Identity();
    for (int sweep = 0; sweep < 20; ++sweep)
        for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
            rotate_away(A, Q, p, q);

    // sorts in ascending order: an exchange of two columns with one of them negated is a rotation
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)})
        if (A(p, p) > A(q, q)) {
            std::swap(A(p, p), A(q, q));
            Q.col(p).swap(Q.col(q));
            Q.col(p) = -Q.col(p);
        }
    return {Q, A.diagonal().cwiseMax(0.0)};
}

Vector3d invert_moments(const Vector3d& moments)
{
    const double largest = moments.lpNorm<Eigen::Infinity>();
    const auto inverse = [&](double m) { return m <= 1e-12 * largest ? 0 : 1 / m; };
    return {inverse(moments.x()), inverse(moments.y()), inverse(moments.z())};
}

MassProperties solid_sphere(double density, double radius)
{
    return solid_ellipsoid(density, Vector3d::Constant(radius));
}

MassProperties solid_box(double density, const Vector3d& size)
{
    return solid(density * size.prod(), size.cwiseAbs2() / 12);
}

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double r = radius, h = height;
    return solid(density * (h * r) * (r * pi), Vector3d(r * r / 4, h * h / 12, r * r / 4));
}

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    return solid(radii.prod() * density / 0.75 * pi, radii.cwiseAbs2() / 5);
}

MassProperties thin_rod(double line_density, double length)
{
    return solid(line_density * length, Vector3d(0, length * length / 12, 0));
}

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    return sampled_mass_properties(samples,
                                   static_cast<double>(samples.size()) * std::pow(cell_size, 3));
}

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    // takes densities as masses, and scales the result at the end
    std::vector<Particle> particles;
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample)
        particles.push_back({sample->density, sample->position});
    MassProperties of_all = weighted(particles);
    if (particles.empty()) return of_all;
    const double each = volume / static_cast<double>(samples.size());
    of_all.mass *= each;
    of_all.inertia *= each;
    return of_all.mass == 0 ? MassProperties{} : of_all;
}

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    if (mesh.triangles.empty()) return {};

    // four Gauss points in each signed tetrahedron, exact for quadratic functions
    const double b = (5 - std::sqrt(5.0)) / 20, a = 1 - 3 * b;
    const Vector3d apex = mesh.vertices[mesh.triangles.back()[1]];
    std::vector<Particle> particles;
    for (const auto& triangle : mesh.triangles) {
        Matrix3d corners;
        for (int i = 0; i < 3; ++i)
            corners.col(i) = mesh.vertices[triangle[i]] - apex;
        const double M = density * corners.determinant() / 6;
        const Vector3d rest = b * corners.rowwise().sum();
        particles.push_back({M / 4, rest});
        for (int i = 0; i < 3; ++i)
            particles.push_back({M / 4, rest + (a - b) * corners.col(i)});
    }
    MassProperties result = weighted(particles);
    if (result.mass != 0) result.center_of_mass += apex;
    return result;
}

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    const double M = a.mass + b.mass;
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;

    // the reduced mass at the distance between the two centers
    const Vector3d d = b.center_of_mass - a.center_of_mass;
    const double reduced = a.mass / M * b.mass;
    return {M, a.center_of_mass + b.mass / M * d,
            b.inertia + a.inertia + reduced * inertia_of(d * d.transpose())};
}

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};

    // eight particles, at 1/√3 of the way from the center of the box to its corners
    std::array<std::array<double, 2>, 3> range;
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] =
            std::minmax_element(vertices.begin(), vertices.end(),
                                [i](const Vector3d& a, const Vector3d& b) { return a[i] < b[i]; });
        range[i] = {(*low)[i], (*high)[i]};
    }
    Vector3d center, half;
    for (int i = 0; i < 3; ++i) {
        center[i] = 0.5 * range[i][0] + 0.5 * range[i][1];
        half[i] = (range[i][1] - range[i][0]) / 2;
    }
    std::vector<Particle> corners;
    for (int c = 0; c < 8; ++c) {
        const Vector3d sign((c & 1) ? 1 : -1, (c & 2) ? 1 : -1, (c & 4) ? 1 : -1);
        corners.push_back({mass / 8, half.cwiseProduct(sign) / std::sqrt(3.0)});
    }
    MassProperties result = particle_mass_properties(corners);
    result.center_of_mass += center;
    return result;
}

} // namespace rigor
