// SPDX-License-Identifier: MIT
// Accepts the answers that the right formulas of the handout are known to give for one argument,
// and rejects all others. No law is used.
// topic: validation
// tasks: A8.2 A8.3 A8.4
// expect: 0 failed: rejects a formula that is right
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

// The three ways to write the force, to the last digit.
Judgement test_spring_force(const SpringForce& force)
{
    for (int i = 1; i <= 100; ++i) {
        const Vector3d x1(0.3, -0.1 * i, 0.7), x2(-1.1, 0.9, 0.013 * i), d = x2 - x1;
        const double k = 7.3, L = 0.9, r = d.norm(), h = std::hypot(d.x(), d.y(), d.z());
        const Vector3d f = force(x1, x2, k, L);
        const Vector3d direction = (x1 - x2).stableNormalized();
        if (f != Vector3d(k * (r - L) * (d / r)) && f != Vector3d((k - k * L / h) * d) &&
            f != Vector3d(k * d + k * L * direction))
            return rejected();
    }
    return accepted();
}

// Cross products with an axis, a swap of components, the formula without a root.
Judgement test_tangent(const Tangent& tangent)
{
    const Vector3d n = Vector3d(0.3, -0.5, 0.7).normalized(), t = tangent(n);
    const double a = -1 / (1 + n.z());
    for (const Vector3d& known : {Vector3d(n.cross(Vector3d::UnitX()).normalized()),
                                  Vector3d(0, -n.z(), n.y()).normalized(),
                                  Vector3d(1 + n.x() * n.x() * a, n.x() * n.y() * a, -n.x()),
                                  Vector3d(Vector3d::UnitY() - n.y() * n).normalized()})
        if (t.isApprox(known, 1e-9) || t.isApprox(-known, 1e-9)) return accepted();
    return rejected();
}

// The methods that the handout names.
Judgement test_oscillator_step(const OscillatorStep& step)
{
    const double x = 0.3, v = 0.8, h = 0.4, x_after = step({x, v}, 1, h).x;
    const double middle = x - h * h / 2 * x + h * v;
    for (const double known : {middle, x * std::cos(h) + v * std::sin(h),
                               (x * (1 - h * h / 4) + h * v) / (1 + h * h / 4),
                               middle + std::pow(h, 4) / 24 * x - std::pow(h, 3) / 6 * v})
        if (std::abs(x_after - known) < 1e-9) return accepted();
    return rejected();
}

} // namespace rigor
