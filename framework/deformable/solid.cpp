// SPDX-License-Identifier: MIT
#include "deformable/element.hpp"
#include "deformable/lumped_mass.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <numeric>
#include <utility>

namespace rigor {

Deformable make_deformable(std::string name, TetrahedralMesh rest, const SolidMaterial& material,
                           const Matrix3d& rotation, const Vector3d& translation)
{
    Deformable solid;
    solid.name = std::move(name);
    solid.material = material;
    solid.rest = std::move(rest);
    for (const Vector3d& X : solid.rest.vertices)
        solid.positions.push_back(rotation * X + translation);
    solid.velocities.assign(solid.positions.size(), Vector3d::Zero());
    solid.plastic_strains.assign(solid.rest.tetrahedra.size(), Matrix3d::Zero());
    solid.masses = lumped_masses(solid);
    return solid;
}

std::vector<double> lumped_masses(const Deformable& solid)
{
    std::vector<double> masses(solid.rest.vertices.size(), 0.0);
    for (int e = 0; e < static_cast<int>(solid.rest.tetrahedra.size()); ++e)
        for (const int v : solid.rest.tetrahedra[e])
            masses[v] += solid.material.density * matter_volume(solid, e) / 4;
    return masses;
}

double matter_volume(const Deformable& solid, int element)
{
    const double V = tetrahedron_volume(solid.rest, element);
    return solid.embedded.fractions.empty() ? V : solid.embedded.fractions[element] * V;
}

std::vector<Matrix3d> element_stresses(const Deformable& solid)
{
    std::vector<Matrix3d> stresses;
    stresses.reserve(solid.rest.tetrahedra.size());
    for (int e = 0; e < static_cast<int>(solid.rest.tetrahedra.size()); ++e)
        stresses.push_back(stress_of(solid, e));
    return stresses;
}

std::vector<int> pieces(const Deformable& solid)
{
    std::vector<int> parent(solid.rest.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const auto& t : solid.rest.tetrahedra)
        for (int i = 1; i < 4; ++i)
            parent[root(t[i])] = root(t[0]);

    std::vector<int> number(parent.size(), -1), pieces;
    int count = 0;
    for (const auto& t : solid.rest.tetrahedra) {
        int& n = number[root(t[0])];
        if (n < 0) n = count++;
        pieces.push_back(n);
    }
    return pieces;
}

DeformableTotals totals(const Deformable& solid)
{
    DeformableTotals sum;
    Vector3d mx = Vector3d::Zero(); // Σ m x
    for (std::size_t i = 0; i < solid.masses.size(); ++i) {
        const double m = solid.masses[i];
        const Vector3d &x = solid.positions[i], &v = solid.velocities[i];
        sum.mass += m;
        sum.kinetic_energy += 0.5 * m * v.squaredNorm();
        sum.momentum += m * v;
        sum.angular_momentum += m * x.cross(v);
        mx += m * x;
    }
    if (sum.mass > 0) sum.center_of_mass = mx / sum.mass;
    for (int e = 0; e < static_cast<int>(solid.rest.tetrahedra.size()); ++e) {
        const double V = matter_volume(solid, e);
        sum.volume += V;
        sum.elastic_energy += V * energy_density(solid, e);
    }
    return sum;
}

} // namespace rigor
