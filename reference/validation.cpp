// SPDX-License-Identifier: MIT
// Solution of assignment A8: tests by laws. A test begins with a case by hand where there is one,
// goes on with laws for many arguments of every size, and ends with the special cases.
#include "formulas/validation.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace rigor {

namespace {

// A larger error than this is no rounding error. It is relative to the largest term, and a few
// thousand times the machine epsilon.
constexpr double rounding = 1e-12;

// Whether a and b are equal up to rounding; false also if one of them is not finite.
bool is_close(double a, double b, double scale)
{
    return std::abs(a - b) <= rounding * scale;
}

class Numbers {
public:
    double uniform(double low, double high)
    {
        return low + (high - low) * static_cast<double>(bits_()) * 0x1p-32;
    }
    // A number of any size between 1e-9 and 1e9.
    double magnitude() { return std::pow(10, uniform(-9, 9)); }
    double either_sign() { return uniform(-1, 1) < 0 ? -magnitude() : magnitude(); }
    Vector3d vector()
    {
        const double x = uniform(-1, 1), y = uniform(-1, 1);
        return {x, y, uniform(-1, 1)};
    }
    // A vector of which some components may be very small.
    Vector3d uneven_vector()
    {
        Vector3d v = vector();
        for (double& component : v)
            component *= std::min(1.0, magnitude());
        return v;
    }

private:
    std::mt19937 bits_{1};
};

bool collision_keeps_laws(const LineCollision& collide, double m1, double m2, double v1, double v2,
                          double e)
{
    const auto [u1, u2] = collide(m1, m2, v1, v2, e);
    // Errors are relative to the larger speed before the collision, because both velocities after
    // it are sums of terms as large as this speed.
    const double v = std::max(std::abs(v1), std::abs(v2)), P = (m1 + m2) * v;
    if (v1 <= v2) return is_close(u1, v1, v) && is_close(u2, v2, v);
    return is_close(m1 * u1 + m2 * u2, m1 * v1 + m2 * v2, P) &&
           is_close(u1 - u2, -e * (v1 - v2), v);
}

} // namespace

Judgement test_line_collision(const LineCollision& collide)
{
    // By hand: 1 kg at 3 m/s meets 2 kg at rest, with the restitution ε = ½.
    const auto [u1, u2] = collide(1, 2, 3, 0, 0.5);
    if (!is_close(u1, 0, 3) || !is_close(u2, 1.5, 3)) return rejected();

    Numbers random;
    for (int i = 0; i < 200; ++i) {
        const double m1 = random.magnitude(), m2 = i % 3 == 0 ? m1 : random.magnitude();
        const double v1 = random.either_sign();
        const double v2 = i % 2 == 0 ? v1 * random.uniform(-2, 2) : random.either_sign();
        const double e = i % 5 == 0 ? 0 : i % 5 == 1 ? 1 : std::pow(random.uniform(0, 1), 3);
        if (!collision_keeps_laws(collide, m1, m2, v1, v2, e)) return rejected();
        if (!collision_keeps_laws(collide, m1, m2, v2, v1, e)) return rejected();
    }
    // The bodies move together, or both are at rest, or the center of mass is.
    for (const double e : {0.0, 0.5, 1.0})
        for (const auto& [v1, v2] :
             {std::pair(3.0, 3.0), std::pair(0.0, 0.0), std::pair(2.0, -1.0)})
            if (!collision_keeps_laws(collide, 1, 2, v1, v2, e)) return rejected();
    return accepted();
}

namespace {

bool force_keeps_laws(const SpringForce& force, const Vector3d& x1, const Vector3d& x2, double k,
                      double L)
{
    const Vector3d d = x2 - x1, f = force(x1, x2, k, L), f2 = force(x2, x1, k, L);
    const double r = d.norm(), scale = k * (r + L);
    // The force is along the spring and proportional to its extension, and the force on the other
    // end is opposite.
    return is_close(f.dot(d) / r, k * (r - L), scale) &&
           is_close(f.cross(d).norm() / r, 0, scale) && is_close((f + f2).norm(), 0, scale);
}

} // namespace

Judgement test_spring_force(const SpringForce& force)
{
    Numbers random;
    for (int i = 0; i < 240; ++i) {
        // The spring is near the origin, or up to a million lengths away from it.
        const double size = i % 2 == 0 ? 1 : std::pow(10, random.uniform(-9, 3));
        const double away = i % 4 < 2 ? 1 : std::pow(10, random.uniform(0, 6));
        const Vector3d x1 = random.vector() * size * away;
        const Vector3d x2 = x1 + random.uneven_vector() * size;
        const double r = (x2 - x1).norm(), k = i % 20 == 0 ? 0 : random.magnitude();
        if (r == 0) continue;
        // It is much shorter or much longer than its rest length L, or has nearly this length.
        const double L = i % 10 == 1  ? 0
                         : i % 3 == 0 ? r * (1 + random.uniform(-1, 1) / random.magnitude())
                                      : r * std::pow(10, random.uniform(-2, 2));
        if (L >= 0 && !force_keeps_laws(force, x1, x2, k, L)) return rejected();
    }
    // Springs along an axis, or perpendicular to one; the last ones have their rest length.
    const Vector3d x = {0.5, -1, 2};
    for (int axis = 0; axis < 3; ++axis)
        for (const Vector3d& d : {Vector3d(Vector3d::Unit(axis)), Vector3d(-Vector3d::Unit(axis)),
                                  Vector3d(Vector3d::Ones() - Vector3d::Unit(axis))})
            for (const double L : {0.0, 0.3, 1.0})
                if (!force_keeps_laws(force, x, x + d, 3, L)) return rejected();
    // There is no force if both ends are at one point.
    for (const double k : {0.0, 3.0})
        for (const double L : {0.0, 1.0})
            if (force(x, x, k, L) != Vector3d::Zero()) return rejected();
    return accepted();
}

Judgement test_tangent(const Tangent& tangent)
{
    const auto keeps_laws = [&](const Vector3d& n) {
        const Vector3d t = tangent(n);
        return is_close(t.norm(), 1, 1) && is_close(t.dot(n), 0, 1);
    };
    Numbers random;
    for (int i = 0; i < 60; ++i)
        if (!keeps_laws(random.vector().normalized())) return rejected();
    // Directions along each axis and each diagonal, both ways, and directions near them.
    for (const double near : {0.0, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3, 0.03, 0.1})
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (x != 0 || y != 0 || z != 0)
                        if (!keeps_laws((Vector3d(x, y, z) + near * random.vector()).normalized()))
                            return rejected();
    return accepted();
}

Judgement test_oscillator_step(const OscillatorStep& step)
{
    Numbers random;
    // An oscillator that rests at x = 0 stays there.
    const OscillatorState rest = step({0, 0}, 2, 0.1);
    if (!(rest.x == 0 && rest.v == 0)) return rejected();
    for (int i = 0; i < 500; ++i) {
        const double w = i % 2 == 0 ? random.uniform(0.5, 2) : random.magnitude();
        const double size = i % 4 < 2 ? 1 : random.magnitude();
        const double a = std::pow(0.5, random.uniform(1, 10)); // the angle ω h, ½ to 1/1024
        const double x = i % 5 == 0 ? 0 : random.uniform(-1, 1) * size;
        const double v = i % 5 == 1 ? 0 : random.uniform(-1, 1) * size * w;

        // The exact result is x(h) = x cos ωh + v/ω sin ωh and its derivative; the contract allows
        // an error of (ω h)³ A in x(h) and in v(h)/ω, with the amplitude A.
        const OscillatorState after = step({x, v}, w, a / w);
        const double A = std::hypot(x, v / w), bound = (a * a * a + rounding) * A;
        if (!(std::abs(after.x - (x * std::cos(a) + v / w * std::sin(a))) <= bound))
            return rejected();
        if (!(std::abs(after.v / w - (v / w * std::cos(a) - x * std::sin(a))) <= bound))
            return rejected();
    }
    return accepted();
}

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    const std::vector<double> expected = formula(example);
    if (expected.size() != result.size()) return rejected();

    for (const Dimension unit : {Dimension{1, 0, 0}, Dimension{0, 1, 0}, Dimension{0, 0, 1}})
        for (int exponent = -40; exponent <= 40; exponent += 8) {
            // The factors are powers of two, so multiplying by them rounds nothing.
            const auto factor = [&](const Dimension& of) {
                return std::ldexp(1, exponent * (unit.mass * of.mass + unit.length * of.length +
                                                 unit.time * of.time));
            };
            std::vector<double> others = example;
            for (std::size_t i = 0; i < others.size(); ++i)
                others[i] *= factor(arguments[i]);
            const std::vector<double> found = formula(others);
            if (found.size() != expected.size()) return rejected();
            for (std::size_t i = 0; i < found.size(); ++i)
                if (!is_close(found[i] / factor(result[i]), expected[i], std::abs(expected[i])))
                    return rejected();
        }
    return accepted();
}

} // namespace rigor
