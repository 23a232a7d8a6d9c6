// SPDX-License-Identifier: MIT
// Other tests: they compare with the formulas written once more, and with the exact oscillation.
#include "formulas/validation.hpp"

#include <cmath>
#include <random>

namespace rigor {

namespace {

double drawn(std::mt19937_64& bits, double low, double high)
{
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
}

double of_any_size(std::mt19937_64& bits)
{
    return std::exp2(drawn(bits, -29, 29)); // 2e-9 to 5e8
}

Vector3d direction(std::mt19937_64& bits)
{
    const double z = drawn(bits, -1, 1), angle = drawn(bits, -3.2, 3.2), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

} // namespace

Judgement test_line_collision(const LineCollision& collide)
{
    std::mt19937_64 bits(7);
    for (int i = 0; i < 500; ++i) {
        const double m1 = i % 50 == 20 ? 1 : of_any_size(bits);
        const double m2 = i % 50 == 20 ? 1 : of_any_size(bits);
        const double v1 = (i % 4 < 2 ? 1 : -1) * of_any_size(bits);
        double v2 = i % 2 == 0 ? v1 * drawn(bits, -2, 2) : (i % 8 < 4 ? 1 : -1) * of_any_size(bits);
        if (i % 10 == 0) v2 = i % 50 == 20 ? -std::abs(v1) : v1;
        const double e = i % 7 == 0   ? std::exp2(drawn(bits, -20, 0))
                         : i % 7 == 1 ? 0
                         : i % 7 == 2 ? 1
                                      : drawn(bits, 0, 1);
        const double V = (m1 * v1 + m2 * v2) / (m1 + m2), v = std::max(std::abs(v1), std::abs(v2));
        const double w1 = v1 > v2 ? V - e * (v1 - V) : v1, w2 = v1 > v2 ? V - e * (v2 - V) : v2;
        const auto [u1, u2] = collide(m1, m2, v1, v2, e);
        if (!(std::abs(u1 - w1) <= 1e-12 * v && std::abs(u2 - w2) <= 1e-12 * v)) return rejected();
    }
    return accepted();
}

Judgement test_spring_force(const SpringForce& force)
{
    std::mt19937_64 bits(8);
    for (int i = 0; i < 400; ++i) {
        const double r = std::exp2(drawn(bits, -29, 9)), k = i % 30 == 0 ? 0 : of_any_size(bits);
        const double L = i % 30 == 1  ? 0
                         : i % 3 == 0 ? r * drawn(bits, 0, 2)
                         : i % 3 == 1 ? r * (1 + drawn(bits, -1e-6, 1e-6))
                                      : of_any_size(bits);
        Vector3d along = direction(bits);
        along[i % 3] *= i % 5 == 0 ? 0 : i % 5 == 1 ? std::exp2(drawn(bits, -29, 0)) : 1;
        const double away = std::exp2(drawn(bits, 0, 20)) * r;
        const Vector3d x1 = away * direction(bits), x2 = x1 + r * along, d = x2 - x1;
        const Vector3d expected = k * (d.norm() - L) * d.normalized();
        if (!((force(x1, x2, k, L) - expected).norm() <= 1e-12 * k * (d.norm() + L)))
            return rejected();
    }
    return force({1, 2, 3}, {1, 2, 3}, 5, 0.5).norm() == 0 ? accepted() : rejected();
}

Judgement test_tangent(const Tangent& tangent)
{
    std::mt19937_64 bits(9);
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z)
                for (const double away : {0.0, 1e-10, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3}) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    const Vector3d n = (Vector3d(x, y, z) + away * direction(bits)).normalized();
                    const Vector3d t = tangent(n), b = n.cross(t);
                    // n, t and n × t are a frame: its matrix is a rotation.
                    Matrix3d R;
                    R << n, t, b;
                    if (!((R.transpose() * R - Matrix3d::Identity()).norm() <= 1e-11))
                        return rejected();
                    if (!(std::abs(t.norm() - 1) <= 1e-12 && std::abs(t.dot(n)) <= 1e-12))
                        return rejected();
                }
    for (int i = 0; i < 100; ++i) {
        const Vector3d n = direction(bits).normalized(), t = tangent(n);
        if (!(std::abs(t.squaredNorm() - 1) + std::abs(t.dot(n)) <= 1e-12)) return rejected();
    }
    return accepted();
}

Judgement test_oscillator_step(const OscillatorStep& step)
{
    std::mt19937_64 bits(10);
    for (int i = 0; i < 400; ++i) {
        const double w = of_any_size(bits), A = of_any_size(bits),
                     a = std::exp2(drawn(bits, -12, -1));
        const double phase = i % 8 == 0 ? 0 : i % 8 == 1 ? M_PI / 2 : drawn(bits, -3.2, 3.2);
        const double x = i % 8 == 1 ? 0 : A * std::cos(phase), v = -A * w * std::sin(phase);
        const auto [x2, v2] = step({x, v}, w, a / w);
        const double off = std::max(std::abs(x2 - A * std::cos(phase + a)),
                                    std::abs(v2 / w + A * std::sin(phase + a)));
        if (!(off <= A * (a * a * a + 1e-12))) return rejected();
    }
    const auto [x, v] = step({0, 0}, 1, 0.25);
    return x == 0 && v == 0 ? accepted() : rejected();
}

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    const std::vector<double> before = formula(example);
    std::mt19937_64 bits(11);
    for (int i = 0; i < 150; ++i) {
        // One unit alone, by 2^±40 and by any power of two between.
        int power[3] = {0, 0, 0};
        power[i % 3] = i < 3 ? -40 : i < 6 ? 40 : static_cast<int>(bits() % 81) - 40;
        const auto grown = [&](double number, const Dimension& of, int sign) {
            const int n = power[0] * of.mass + power[1] * of.length + power[2] * of.time;
            return std::ldexp(number, sign * n);
        };
        std::vector<double> inputs;
        for (std::size_t k = 0; k < example.size(); ++k)
            inputs.push_back(grown(example[k], arguments[k], 1));
        const std::vector<double> after = formula(inputs);
        for (std::size_t k = 0; k < before.size(); ++k)
            if (!(std::abs(grown(after[k], result[k], -1) - before[k]) <=
                  1e-12 * std::abs(before[k])))
                return rejected();
    }
    return accepted();
}

} // namespace rigor
