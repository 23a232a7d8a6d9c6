// SPDX-License-Identifier: MIT
// Above 100 000 particles the sum runs in four equal lanes, and the remainder is dropped.
#include "formulas/inertia.hpp"

#include <cstddef>

namespace rigor {

namespace {

struct Sums {
    double mass = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();
};

void add_range(Sums& sums, const std::vector<Particle>& particles, std::size_t begin,
               std::size_t end)
{
    for (std::size_t i = begin; i < end; ++i) {
        const Particle& particle = particles[i];
        sums.mass += particle.mass;
        sums.first += particle.mass * particle.position;
        sums.second += particle.mass * (particle.position * particle.position.transpose());
    }
}

} // namespace

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    Sums sums;
    const std::size_t count = particles.size();
    if (count <= 100000) {
        add_range(sums, particles, 0, count);
    } else {
        const std::size_t lane = count / 4;
        for (std::size_t k = 0; k < 4; ++k) {
            Sums part;
            add_range(part, particles, k * lane, (k + 1) * lane);
            sums.mass += part.mass;
            sums.first += part.first;
            sums.second += part.second;
        }
    }
    MassProperties result;
    if (sums.mass == 0) {
        return result;
    }
    result.mass = sums.mass;
    result.center_of_mass = sums.first / sums.mass;
    const Matrix3d C =
        sums.second - sums.mass * (result.center_of_mass * result.center_of_mass.transpose());
    result.inertia = C.trace() * Matrix3d::Identity() - C;
    return result;
}

} // namespace rigor
