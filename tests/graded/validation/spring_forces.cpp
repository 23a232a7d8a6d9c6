// SPDX-License-Identifier: MIT
#include "candidates.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::testing {

namespace {

Vector3d along_the_unit_vector(Vector3d x1, Vector3d x2, double k, double L)
{
    const Vector3d d = x2 - x1;
    const double length = d.norm();
    if (length == 0) return Vector3d::Zero();
    return k * (length - L) * (d / length);
}

Vector3d by_the_ratio(Vector3d x1, Vector3d x2, double k, double L)
{
    const double r = std::hypot(x2.x() - x1.x(), x2.y() - x1.y(), x2.z() - x1.z());
    if (!(r > 0)) return Vector3d::Zero();
    return (k - k * L / r) * (x2 - x1);
}

Vector3d as_a_difference(Vector3d x1, Vector3d x2, double k, double L)
{
    if (x1 == x2) return Vector3d::Zero();
    const Vector3d direction = (x1 - x2).stableNormalized();
    return k * (x2 - x1) + k * L * direction;
}

// The force of a spring from its extension, a function of the length and the rest length.
template <class Extension> Function<SpringForce> spring(const Extension& extension)
{
    return [extension](const Vector3d& x1, const Vector3d& x2, double k, double L) {
        const Vector3d d = x2 - x1;
        const double length = d.norm();
        if (length == 0) return Vector3d(Vector3d::Zero());
        return Vector3d(k * extension(length, L) * d / length);
    };
}

const Candidates<SpringForce>::Wrong ordinary_springs = {
    {"has the wrong sign", spring([](double r, double L) { return L - r; })},
    {"is wrong unless the rest length is 0", spring([](double r, double) { return r; })},
    {"is wrong unless the spring is 1 m long",
     spring([](double r, double L) { return (r - L) * r; })},
    {"is wrong unless the rest length is 0 or 1 m",
     spring([](double r, double L) { return r - L * L; })},
    {"is wrong unless the stiffness is 0 or 1 N/m",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         return Vector3d(k * along_the_unit_vector(x1, x2, k, L));
     }},
    {"is wrong unless the spring lies along an axis",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         const Vector3d d = x2 - x1;
         Vector3d f = Vector3d::Zero();
         for (int i = 0; i < 3; ++i)
             if (d[i] != 0) f[i] = k * (std::abs(d[i]) - L) * (d[i] > 0 ? 1 : -1);
         return f;
     }},
    {"is wrong unless the spring lies in the plane z = 0",
     [](Vector3d x1, Vector3d x2, double k, double L) {
         x1.z() = x2.z() = 0;
         return along_the_unit_vector(x1, x2, k, L);
     }},
    {"is wrong unless x1 = 0",
     [](const Vector3d&, const Vector3d& x2, double k, double L) {
         return along_the_unit_vector(Vector3d::Zero(), x2, k, L);
     }},
};

const Candidates<SpringForce>::Wrong special_springs = {
    {"is wrong for a spring that is shorter than its rest length",
     spring([](double r, double L) { return std::max(r - L, 0.0); })},
    {"is wrong where both ends are at one place",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         const Vector3d d = x2 - x1;
         return Vector3d(k * (1 - L / d.norm()) * d);
     }},
    {"is wrong where both ends are at one place",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         if (x1 == x2) return Vector3d(k * L, 0, 0);
         return along_the_unit_vector(x1, x2, k, L);
     }},
    {"is wrong for a long spring",
     spring([](double r, double L) { return std::min(r - L, 10.0); })},
    {"is wrong near the rest length",
     spring([](double r, double L) { return std::abs(r - L) < 1e-3 * L ? 0 : r - L; })},
    {"is wrong for a spring that is pulled to more than twice its rest length",
     spring([](double r, double L) { return r > 2 * L ? 2 * (r - L) : r - L; })},
    {"is wrong where the ends are close together",
     spring([](double r, double L) { return r < 1e-4 ? 0 : r - L; })},
    {"is wrong for a rest length of 0", spring([](double r, double L) { return L * (r / L - 1); })},
    {"is wrong for a stiffness of 0",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         const double r = (x2 - x1).norm();
         if (r == 0) return Vector3d(Vector3d::Zero());
         return Vector3d(k * (1 - k * L / (k * r)) * (x2 - x1));
     }},
    {"is wrong far from the origin",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         const double r2 = x1.squaredNorm() + x2.squaredNorm() - 2 * x1.dot(x2);
         if (x1 == x2 || r2 <= 0) return Vector3d(Vector3d::Zero());
         return Vector3d(k * (1 - L / std::sqrt(r2)) * (x2 - x1));
     }},
    {"is off by a millionth at a million lengths from the origin",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         const double lost = 4e-13 * k * (x1.norm() + x2.norm());
         const Vector3d direction = (x2 - x1).stableNormalized();
         return Vector3d(along_the_unit_vector(x1, x2, k, L) + lost * direction);
     }},
    {"is wrong for a spring that is perpendicular to an axis",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         const Vector3d d = x2 - x1;
         if (d.isZero(0)) return d;
         const Vector3d direction = Vector3d(1, d.y() / d.x(), d.z() / d.x()).normalized();
         return Vector3d(std::copysign(k * (d.norm() - L), d.x()) * direction);
     }},
    {"is wrong for a spring that is nearly perpendicular to an axis",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         Vector3d d = x2 - x1;
         for (double& component : d)
             if (std::abs(component) < 1e-6 * (x2 - x1).norm()) component = 0;
         return along_the_unit_vector(Vector3d::Zero(), d, k, L);
     }},
    {"is wrong for a very soft spring",
     [](const Vector3d& x1, const Vector3d& x2, double k, double L) {
         return along_the_unit_vector(x1, x2, k < 1e-7 ? 0 : k, L);
     }},
    {"is off by a ten-millionth", spring([](double r, double L) { return (r - L) * (1 + 1e-7); })},
};

} // namespace

const Candidates<SpringForce>& spring_forces()
{
    static const Candidates<SpringForce> all = {
        {along_the_unit_vector, by_the_ratio, as_a_difference}, ordinary_springs, special_springs};
    return all;
}

} // namespace rigor::testing
