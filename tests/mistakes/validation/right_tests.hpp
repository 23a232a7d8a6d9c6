// SPDX-License-Identifier: MIT
// Right tests of A8 with a switch for each mistake. They compare with the formulas, written once
// more.
#pragma once

#include "formulas/validation.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace rigor::right_tests {

class Drawn {
public:
    double uniform(double low, double high)
    {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    double size() { return std::pow(10, uniform(-9, 9)); }
    Vector3d direction()
    {
        const double z = uniform(-1, 1), angle = uniform(-3.2, 3.2), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::mt19937_64 bits_{3};
};

/// The rules of `test_line_collision` (A8.1); each mistake changes one.
struct CollisionRules {
    double rounding = 1e-12;
    bool tries_ends = true;            // restitutions of exactly 0 and 1
    bool tries_equal = true;           // equal velocities
    bool is_exact_where_apart = false; // no rounding where the bodies do not approach
};

inline Judgement judged(const CollisionRules& rules, const LineCollision& collide)
{
    Drawn drawn;
    for (int i = 0; i < 450; ++i) {
        const bool is_still = i % 45 == 20; // the center of mass is at rest
        const double m1 = is_still ? 2 : drawn.size(), m2 = is_still ? 2 : drawn.size();
        const double v1 = (i % 4 < 2 ? 1 : -1) * drawn.size();
        double v2 = i % 2 == 0 ? v1 * drawn.uniform(-2, 2) : (i % 8 < 4 ? 1 : -1) * drawn.size();
        if (is_still) v2 = -v1;
        if (i % 45 == 21 && rules.tries_equal) v2 = v1;
        double e = i % 9 == 0 ? std::min(1.0, drawn.size()) / 2 : drawn.uniform(0.001, 0.999);
        if (i % 9 < 3 && i % 9 > 0 && rules.tries_ends) e = i % 9 - 1;

        const double V = (m1 * v1 + m2 * v2) / (m1 + m2), v = std::max(std::abs(v1), std::abs(v2));
        const bool is_apart = v1 <= v2;
        const double w1 = is_apart ? v1 : V - e * (v1 - V), w2 = is_apart ? v2 : V - e * (v2 - V);
        const double room = is_apart && rules.is_exact_where_apart ? 0 : rules.rounding * v;
        const auto [u1, u2] = collide(m1, m2, v1, v2, e);
        if (!(std::abs(u1 - w1) <= room && std::abs(u2 - w2) <= room)) return rejected();
    }
    return accepted();
}

/// The rules of `test_spring_force` (A8.2); each mistake changes one.
struct SpringRules {
    double farthest = 1e6;   // from the origin, in lengths of the spring
    bool tries_zeros = true; // k = 0 and L = 0
    bool room_grows = false; // whether the allowed error grows with the distance from the origin
};

inline Judgement judged(const SpringRules& rules, const SpringForce& force)
{
    Drawn drawn;
    for (int i = 0; i < 400; ++i) {
        const double length = std::pow(10, drawn.uniform(-9, 3));
        double k = drawn.size(), L = i % 3 == 0   ? length * drawn.uniform(0, 2)
                                     : i % 3 == 1 ? length * (1 + drawn.uniform(-1e-6, 1e-6))
                                                  : drawn.size();
        if (rules.tries_zeros && i % 20 == 0) k = 0;
        if (rules.tries_zeros && i % 20 == 1) L = 0;
        Vector3d along = drawn.direction();
        if (i % 5 < 2) along[i % 3] *= i % 5 == 0 ? 0 : std::min(1.0, drawn.size());
        const double away = std::pow(rules.farthest, drawn.uniform(0, 1));
        const Vector3d x1 = away * length * drawn.direction(), x2 = x1 + length * along;
        const Vector3d d = x2 - x1, expected = k * (d.norm() - L) * d.normalized();
        const double size = rules.room_grows ? x1.norm() + x2.norm() : 0;
        if (!((force(x1, x2, k, L) - expected).norm() <= 1e-12 * k * (d.norm() + L + size)))
            return rejected();
    }
    const Vector3d x(1, 2, 3);
    return force(x, x, 5, 0.5) == Vector3d::Zero() ? accepted() : rejected();
}

/// Tests a tangent (A8.3), with directions as near as `nearest` to the axes and diagonals.
inline Judgement judged(double nearest, const Tangent& tangent)
{
    Drawn drawn;
    const auto keeps_laws = [&](const Vector3d& n) {
        const Vector3d t = tangent(n);
        return std::abs(t.norm() - 1) <= 1e-12 && std::abs(t.dot(n)) <= 1e-12;
    };
    for (int i = 0; i < 100; ++i)
        if (!keeps_laws(drawn.direction())) return rejected();
    for (int place = 0; place < 27; ++place) {
        const Vector3d axis(place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1);
        if (axis.isZero(0)) continue;
        if (!keeps_laws(axis.normalized())) return rejected();
        for (double away = 0.1; away > 0.5 * nearest; away /= 10)
            for (int i = 0; i < 2; ++i)
                if (!keeps_laws((axis + away * drawn.direction()).normalized())) return rejected();
    }
    return accepted();
}

/// The rules of `test_oscillator_step` (A8.4); each mistake changes one.
struct StepRules {
    double position = 1, velocity = 1; // the bounds, as multiples of those of the contract
    bool draws_between = true;         // angles between 1/2, 1/4, 1/8 …
};

inline Judgement judged(const StepRules& rules, const OscillatorStep& step)
{
    Drawn drawn;
    for (int i = 0; i < 500; ++i) {
        const double w = drawn.size(), A = i == 0 ? 0 : std::pow(10, drawn.uniform(-9, 4));
        const double a = std::exp2(rules.draws_between ? drawn.uniform(-10, -1) : -1 - i % 10);
        const double phase = i % 8 == 1 ? 0 : i % 8 == 2 ? M_PI / 2 : drawn.uniform(-3.2, 3.2);
        const double x = i % 8 == 2 ? 0 : A * std::cos(phase), v = -A * w * std::sin(phase);
        const auto [x2, v2] = step({x, v}, w, a / w);
        const double off_x = std::abs(x2 - A * std::cos(phase + a)),
                     off_v = std::abs(v2 / w + A * std::sin(phase + a));
        if (!(off_x <= A * (rules.position * a * a * a + 1e-12))) return rejected();
        if (!(off_v <= A * (rules.velocity * a * a * a + 1e-12))) return rejected();
    }
    return accepted();
}

/// The rules of `test_units` (A8.5); each mistake changes one.
struct UnitRules {
    double rounding = 1e-12;
    int largest_power = 40;      // units by factors up to 2 to this power
    bool skips_zeros = false;    // does not compare a number that is 0 for the example
    bool beside_largest = false; // compares relative to the largest number of the result
};

inline Judgement judged(const UnitRules& rules, const UnknownFormula& formula,
                        const std::vector<double>& example, const std::vector<Dimension>& arguments,
                        const std::vector<Dimension>& result)
{
    const std::vector<double> before = formula(example);
    double largest = 0;
    for (const double number : before)
        largest = std::max(largest, std::abs(number));
    for (int unit = 0; unit < 3; ++unit)
        for (int power = -rules.largest_power; power <= rules.largest_power; ++power) {
            const auto grown = [&](double number, const Dimension& of, int sign) {
                const int exponents[] = {of.mass, of.length, of.time};
                return std::ldexp(number, sign * power * exponents[unit]);
            };
            std::vector<double> inputs;
            for (std::size_t i = 0; i < example.size(); ++i)
                inputs.push_back(grown(example[i], arguments[i], 1));
            const std::vector<double> after = formula(inputs);
            for (std::size_t i = 0; i < before.size(); ++i) {
                if (rules.skips_zeros && before[i] == 0) continue;
                const double scale = rules.beside_largest ? largest : std::abs(before[i]);
                if (!(std::abs(grown(after[i], result[i], -1) - before[i]) <=
                      rules.rounding * scale))
                    return rejected();
            }
        }
    return accepted();
}

} // namespace rigor::right_tests
