// SPDX-License-Identifier: MIT
// Random cases from the bits of SplitMix64 (Steele, Lea & Flood 2014). The bits give uniform
// numbers, these give directions and rotations by rejection, and bodies are made of all of them.
#include "support/random.hpp"

#include <cmath>
#include <numbers>

namespace rigor::testing {

Random::Random(unsigned seed) : state_(seed)
{
    bits(); // separates neighboring seeds
}

// Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators".
std::uint64_t Random::bits()
{
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

double Random::uniform(double low, double high)
{
    const double unit = static_cast<double>(bits() >> 11) * 0x1p-53;
    return low + (high - low) * unit;
}

Vector3d Random::vector()
{
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return {x, y, z};
}

Vector3d Random::unit_vector()
{
    for (;;) {
        const Vector3d v = vector();
        const double length = v.norm();
        if (length > 0.1 && length <= 1) return v / length;
    }
}

Eigen::Quaterniond Random::eigen_quaternion()
{
    for (;;) {
        const double w = uniform(-1, 1);
        const Vector3d v = vector();
        const double length = std::sqrt(w * w + v.squaredNorm());
        if (length > 0.1 && length <= 1)
            return {w / length, v.x() / length, v.y() / length, v.z() / length};
    }
}

Quaternion Random::quaternion()
{
    const Eigen::Quaterniond q = eigen_quaternion();
    return {q.w(), q.vec()};
}

Matrix3d Random::rotation()
{
    return eigen_quaternion().toRotationMatrix();
}

double Random::mass()
{
    return std::pow(10.0, uniform(-1, 1));
}

Matrix3d Random::inertia()
{
    // positive second moments s along three axes give the moments of a body that could exist
    const Vector3d s(uniform(0.1, 1), uniform(0.1, 1), uniform(0.1, 1));
    const Vector3d moments = mass() * Vector3d(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
    const Matrix3d R = rotation();
    const Matrix3d I = R * moments.asDiagonal() * R.transpose();
    return (I + I.transpose()) / 2;
}

Matrix3d Random::positive_definite()
{
    const Vector3d values(mass(), mass(), mass());
    const Matrix3d R = rotation();
    const Matrix3d A = R * values.asDiagonal() * R.transpose();
    return (A + A.transpose()) / 2;
}

std::vector<Particle> Random::particles(int n)
{
    std::vector<Particle> result;
    for (int i = 0; i < n; ++i) {
        const double m = mass();
        result.push_back({m, vector()});
    }
    return result;
}

Body Random::body()
{
    Body result;
    const double m = mass();
    const Matrix3d I = inertia();
    result.inverse_mass = 1 / m;
    result.inverse_inertia = I.inverse();
    result.position = vector();
    result.velocity = vector();
    result.angular_velocity = vector();
    result.angular_momentum = I * result.angular_velocity;
    return result;
}

} // namespace rigor::testing
