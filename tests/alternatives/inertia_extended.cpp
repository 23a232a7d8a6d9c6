// SPDX-License-Identifier: MIT
// All sums about the origin, as the lecture writes them, in extended precision. What cancels there
// keeps more digits than in double precision.
#include "formulas/inertia.hpp"

namespace rigor {

namespace {

using Number = long double;
using Vector = Eigen::Matrix<Number, 3, 1>;
using Matrix = Eigen::Matrix<Number, 3, 3>;

// The moments ∫ dm, ∫ x dm and ∫ x xᵀ dm about the origin.
struct Moments {
    Number M = 0;
    Vector first = Vector::Zero();
    Matrix second = Matrix::Zero();

    void add(Number m, const Vector& x)
    {
        M += m;
        first += m * x;
        second += m * x * x.transpose();
    }
    MassProperties result() const
    {
        if (M == 0) return {};
        const Vector X = first / M;
        const Matrix C = second - M * X * X.transpose(), I = C.trace() * Matrix::Identity() - C;
        return {static_cast<double>(M), X.cast<double>(), I.cast<double>()};
    }
};

// The moments of samples that stand for one volume each [m³].
MassProperties of_samples(const std::vector<DensitySample>& samples, Number volume)
{
    Moments moments;
    for (const auto& [x, density] : samples)
        moments.add(density * volume, x.cast<Number>());
    return moments.result();
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    Moments moments;
    for (const auto& [m, x] : particles)
        moments.add(m, x.cast<Number>());
    return moments.result();
}

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    return (R.cast<Number>() * I_body.cast<Number>() * R.cast<Number>().transpose()).cast<double>();
}

Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    return world_inertia(R, I_body_inverse);
}

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    const Number h = cell_size;
    return of_samples(samples, h * h * h);
}

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    if (samples.empty()) return {};
    return of_samples(samples, Number(volume) / static_cast<Number>(samples.size()));
}

MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    // ∫ x xᵀ dV of a tetrahedron with one corner in the origin is V/20 (s sᵀ + a aᵀ + b bᵀ + c cᵀ),
    // with s = a + b + c
    Moments moments;
    for (const auto& triangle : mesh.triangles) {
        Matrix x;
        for (int i = 0; i < 3; ++i)
            x.col(i) = mesh.vertices[triangle[i]].cast<Number>();
        const Number m = density * x.determinant() / 6;
        moments.M += m;
        const Vector s = x.rowwise().sum();
        moments.first += m / 4 * s;
        moments.second += m / 20 * (s * s.transpose() + x * x.transpose());
    }
    return moments.result();
}

MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    const Number M = Number(a.mass) + b.mass;
    if (M == 0) return {};
    const Vector X =
        (a.mass * a.center_of_mass.cast<Number>() + b.mass * b.center_of_mass.cast<Number>()) / M;
    Matrix I = Matrix::Zero();
    for (const MassProperties& part : {a, b}) {
        if (part.mass == 0) continue;
        const Vector d = part.center_of_mass.cast<Number>() - X;
        I += part.inertia.cast<Number>() +
             part.mass * (d.squaredNorm() * Matrix::Identity() - d * d.transpose());
    }
    return {static_cast<double>(M), X.cast<double>(), I.cast<double>()};
}

} // namespace rigor
