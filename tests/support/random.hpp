// SPDX-License-Identifier: MIT
// Seeded random cases. They have the same bits on every platform, while the distributions of the
// standard library may differ.
#pragma once

#include "formulas/types.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor::testing {

class Random {
public:
    Random(unsigned seed); // implicit, for `for (Random random : seeds(100))`

    std::uint64_t bits();                    // SplitMix64
    double uniform(double low, double high); // in [low, high)
    Vector3d vector();                       // components in [-1, 1)
    Vector3d unit_vector();                  // uniform on the sphere
    Eigen::Quaterniond eigen_quaternion();   // unit, uniform over the rotations
    Quaternion quaternion();                 // the same in the type of the formulas
    Matrix3d rotation();                     // uniform over the rotations
    double mass();                           // 0.1 … 10 kg, log-uniform
    // inertia of a real body: each moment is at most the sum of the other two
    Matrix3d inertia();
    Matrix3d positive_definite(); // symmetric, eigenvalues 0.1 … 10
    std::vector<Particle> particles(int n);
    Body body(); // L = I ω holds

private:
    std::uint64_t state_;
};

/// A number from 0 to size - 1.
inline int random_index(Random& random, std::size_t size)
{
    return static_cast<int>(random.bits() % size);
}

} // namespace rigor::testing
