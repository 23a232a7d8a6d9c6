// SPDX-License-Identifier: MIT
// Solutions of assignment A2: mass, center of mass and inertia. Simple solids have closed forms;
// grid cells and random samples become point masses; a triangle mesh becomes a sum over signed
// tetrahedra. Each function for mass properties first computes the mass and the center of mass,
// then the inertia about this center.
#include "formulas/inertia.hpp"

#include <numbers>

namespace rigor {

namespace {

constexpr double pi = std::numbers::pi;

// A moment at most this fraction of the largest one counts as 0, because it is a rounding error.
// The fraction is a few thousand times the machine epsilon.
constexpr double zero_moment = 1e-12;

// Inertia about X of a point mass M at x: M (x - X)*ᵀ (x - X)* = M (dᵀd δ - d dᵀ), d = x - X.
Matrix3d point_inertia(double M, const Vector3d& d)
{
    return M * (d.dot(d) * Matrix3d::Identity() - d * d.transpose());
}

// The mass properties of N point masses, of which `particle(i)` is the i-th.
template <class PointMass> MassProperties sum_of(std::size_t N, const PointMass& particle)
{
    // M = Σ mᵢ    X = Σ mᵢ pᵢ / M
    double M = 0;
    Vector3d X = Vector3d::Zero();
    for (std::size_t i = 0; i < N; ++i) {
        const auto& [m, p] = particle(i);
        M += m;
        X += m * p;
    }
    if (M == 0) return {}; // no mass
    X /= M;

    // I = Σ mᵢ (dᵢᵀdᵢ δ - dᵢ dᵢᵀ),  dᵢ = pᵢ - X
    Matrix3d I = Matrix3d::Zero();
    for (std::size_t i = 0; i < N; ++i) {
        const auto& [m, p] = particle(i);
        I += point_inertia(m, p - X);
    }
    return {M, X, I};
}

// One point mass at each sample: the density there times the given volume.
MassProperties sum_of_samples(const std::vector<DensitySample>& samples, double volume)
{
    return sum_of(samples.size(), [&](std::size_t i) {
        return Particle{samples[i].density * volume, samples[i].position};
    });
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    return sum_of(particles.size(), [&](std::size_t i) { return particles[i]; });
}

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    // I(t) = R I_body Rᵀ
    return R * I_body * R.transpose();
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    // I(t)⁻¹ = R I_body⁻¹ Rᵀ
    return R * I_body_inverse * R.transpose();
}

PrincipalAxes principal_axes(const Matrix3d& I)
{
    // I = Q diag(moments) Qᵀ by QR iterations. The solver's closed form (computeDirect) would lose
    // half of the digits where moments are close to each other.
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(I);
    Matrix3d Q = eigen.eigenvectors();
    if (Q.determinant() < 0) Q.col(0) = -Q.col(0); // a reflection: reverse one axis
    return {Q, eigen.eigenvalues().cwiseMax(0)};
}

Vector3d invert_moments(const Vector3d& moments)
{
    const double smallest = zero_moment * moments.maxCoeff();
    Vector3d inverse = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (moments[i] > smallest) inverse[i] = 1 / moments[i];
    return inverse;
}

MassProperties solid_sphere(double density, double radius)
{
    const double rho = density, r = radius;
    const double M = rho * 4 / 3 * pi * r * r * r;

    // I = 2/5 M r² δ
    return {M, Vector3d::Zero(), 2.0 / 5 * M * r * r * Matrix3d::Identity()};
}

MassProperties solid_box(double density, const Vector3d& size)
{
    const double rho = density, a = size[0], b = size[1], c = size[2];
    const double M = rho * a * b * c;

    // Ixx = M/12 (b² + c²), and so on
    const Vector3d I = M / 12 * Vector3d(b * b + c * c, c * c + a * a, a * a + b * b);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

MassProperties solid_cylinder(double density, double radius, double height)
{
    const double rho = density, r = radius, l = height;
    const double M = rho * pi * r * r * l;

    // Iyy = ½ M r²    Ixx = Izz = M/12 (3 r² + l²)
    const double Iyy = M / 2 * r * r;
    const double Ixx = M / 12 * (3 * r * r + l * l);
    return {M, Vector3d::Zero(), Vector3d(Ixx, Iyy, Ixx).asDiagonal()};
}

MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    const double rho = density, a = radii[0], b = radii[1], c = radii[2];
    const double M = rho * 4 / 3 * pi * a * b * c;

    // Ixx = M/5 (b² + c²), and so on
    const Vector3d I = M / 5 * Vector3d(b * b + c * c, c * c + a * a, a * a + b * b);
    return {M, Vector3d::Zero(), I.asDiagonal()};
}

MassProperties thin_rod(double line_density, double length)
{
    const double lambda = line_density, l = length;
    const double M = lambda * l;

    // Ixx = Izz = M l²/12    Iyy = 0
    const double Ixx = M * l * l / 12;
    return {M, Vector3d::Zero(), Vector3d(Ixx, 0, Ixx).asDiagonal()};
}

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    // mᵢ = ρᵢ h³
    const double h = cell_size;
    return sum_of_samples(samples, h * h * h);
}

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    if (samples.empty()) return {};

    // mᵢ = ρᵢ V/N
    const double V = volume, N = static_cast<double>(samples.size());
    return sum_of_samples(samples, V / N);
}

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    if (mesh.triangles.empty()) return {};

    // For a closed mesh, the sum does not depend on the common apex o of the tetrahedra. An apex on
    // the mesh keeps the terms as small as the body, however far the body is from the origin.
    const auto vertex = [&](int i) -> const Vector3d& { return mesh.vertices[i]; };
    const Vector3d& o = vertex(mesh.triangles[0][0]);

    double V = 0;
    Vector3d Vx = Vector3d::Zero();
    Matrix3d Vxx = Matrix3d::Zero();
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vector3d x1 = vertex(i) - o, x2 = vertex(j) - o, x3 = vertex(k) - o;
        const Vector3d s = x1 + x2 + x3;
        const double det = x1.dot(x2.cross(x3));

        // ∫ dV = det/6    ∫ x dV = det/24 s    ∫ x xᵀ dV = det/120 (s sᵀ + x₁x₁ᵀ + x₂x₂ᵀ + x₃x₃ᵀ)
        V += det / 6;
        Vx += det / 24 * s;
        Vxx +=
            det / 120 *
            (s * s.transpose() + x1 * x1.transpose() + x2 * x2.transpose() + x3 * x3.transpose());
    }
    const double M = density * V;
    if (M == 0) return {}; // no volume or no density

    // X = ρ/M ∫ x dV    C = ρ ∫ d dᵀ dV,  d = x - X    I = ρ ∫ (dᵀd δ - d dᵀ) dV = Tr(C) δ - C
    const Vector3d X = Vx / V;
    const Matrix3d C = density * (Vxx - V * X * X.transpose());
    return {M, o + X, C.trace() * Matrix3d::Identity() - C};
}

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    if (a.mass == 0 && b.mass == 0) return {};
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;

    const double M1 = a.mass, M2 = b.mass;
    const Vector3d &X1 = a.center_of_mass, &X2 = b.center_of_mass;
    const Matrix3d &I1 = a.inertia, &I2 = b.inertia;

    // M = M₁ + M₂    X = (M₁ X₁ + M₂ X₂) / M
    const double M = M1 + M2;
    const Vector3d X = (M1 * X1 + M2 * X2) / M;

    // I = I₁ + M₁ (X₁ - X)*ᵀ (X₁ - X)* + I₂ + M₂ (X₂ - X)*ᵀ (X₂ - X)*
    return {M, X, I1 + point_inertia(M1, X1 - X) + I2 + point_inertia(M2, X2 - X)};
}

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};

    Vector3d low = vertices.front(), high = low;
    for (const Vector3d& vertex : vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }

    // Ixx = M/12 (b² + c²), and so on, for the edges (a, b, c)
    const Vector3d squares = (high - low).cwiseAbs2();
    const Vector3d I = mass / 12 * (squares.sum() * Vector3d::Ones() - squares);
    return {mass, (low + high) / 2, I.asDiagonal()};
}

} // namespace rigor
