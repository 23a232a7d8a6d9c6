// SPDX-License-Identifier: MIT
// Makes a frame of a deformable solid: its mesh if that has changed, its totals, the state of its
// nodes, and stress and plastic strain of its elements. Last, all numbers are checked to be finite.
#include "scene/run/record_solid.hpp"

#include "deformable/elasticity/element.hpp"
#include "deformable/elasticity/totals.hpp"
#include "deformable/solid/pieces.hpp"
#include "rigid/bodies/non_finite.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

std::shared_ptr<const SolidTopology> topology_of(const Deformable& solid)
{
    const auto topology = std::make_shared<SolidTopology>();
    topology->nodes = solid.positions.size();
    topology->elements = solid.rest.tetrahedra;
    topology->surface = drawn_surface(solid);
    const std::vector<int> numbers = pieces(solid);
    const auto last = std::max_element(numbers.begin(), numbers.end());
    topology->pieces = last == numbers.end() ? 0 : static_cast<std::size_t>(*last) + 1;
    return topology;
}

// The von Mises stress of a stress tensor [Pa], without formulas of the assignments. The tensor
// comes from the formula `isotropic_stress`, so an error of that formula stays visible.
double von_mises_stress(const Matrix3d& stress)
{
    // √(3/2) ‖dev σ‖
    return std::sqrt(1.5) * (stress - stress.trace() / 3 * Matrix3d::Identity()).norm();
}

double equivalent_strain(const Matrix3d& plastic_strain)
{
    // √(2/3) ‖ε_p‖. For a bar that was pulled, it is the permanent relative elongation.
    return std::sqrt(2.0 / 3) * plastic_strain.norm();
}

void check_finite(const SolidFrame& frame, const std::string& name, double time)
{
    const auto all = [](const auto& values, auto is_finite) {
        return std::all_of(values.begin(), values.end(), is_finite);
    };
    const auto vector = [](const Vector3d& v) { return v.allFinite(); };
    const auto number = [](float x) { return std::isfinite(x); };
    const DeformableTotals& totals = frame.totals;
    if (!all(frame.positions, vector)) throw NonFiniteState(name, "x", time);
    if (!all(frame.velocities, vector)) throw NonFiniteState(name, "v", time);
    if (!all(frame.stresses, number)) throw NonFiniteState(name, "stress", time);
    if (!all(frame.plastic_strains, number)) throw NonFiniteState(name, "plastic strain", time);
    if (!std::isfinite(totals.kinetic_energy + totals.elastic_energy + totals.mass + totals.volume +
                       totals.center_of_mass.sum() + totals.momentum.sum() +
                       totals.angular_momentum.sum()))
        throw NonFiniteState(name, "energy", time);
}

} // namespace

SolidFrame SolidRecorder::frame(const Deformable& solid, double time)
{
    SolidFrame frame;
    frame.is_new_topology = !topology_ || solid.topology != change_;
    if (frame.is_new_topology) topology_ = topology_of(solid);
    change_ = solid.topology;
    frame.topology = topology_;
    frame.totals = totals(solid);
    frame.positions = solid.positions;
    frame.velocities = solid.velocities;
    if (is_rigid(solid))
        frame.stresses.assign(solid.rest.tetrahedra.size(), 0);
    else
        for (const Matrix3d& stress : element_stresses(solid))
            frame.stresses.push_back(static_cast<float>(von_mises_stress(stress)));
    for (const Matrix3d& strain : solid.plastic_strains)
        frame.plastic_strains.push_back(static_cast<float>(equivalent_strain(strain)));
    check_finite(frame, solid.name, time);
    return frame;
}

} // namespace rigor
