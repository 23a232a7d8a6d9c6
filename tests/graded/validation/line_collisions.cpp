// SPDX-License-Identifier: MIT
#include "candidates.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::testing {

namespace {

LineVelocities by_impulse(double m1, double m2, double v1, double v2, double e)
{
    if (v1 <= v2) return {v1, v2};
    const double j = -(1 + e) * (v1 - v2) / (1 / m1 + 1 / m2);
    return {v1 + j / m1, v2 - j / m2};
}

LineVelocities about_the_center(double m1, double m2, double v1, double v2, double e)
{
    if (v1 - v2 <= 0) return {v1, v2};
    const double V = (m1 * v1 + m2 * v2) / (m1 + m2);
    return {V - e * (v1 - V), V - e * (v2 - V)};
}

LineVelocities by_the_masses(double m1, double m2, double v1, double v2, double e)
{
    if (!(v1 > v2)) return {v1, v2};
    return {((m1 - e * m2) * v1 + (1 + e) * m2 * v2) / (m1 + m2),
            ((m2 - e * m1) * v2 + (1 + e) * m1 * v1) / (m1 + m2)};
}

// Rounds also where the bodies do not approach.
LineVelocities by_a_factor(double m1, double m2, double v1, double v2, double e)
{
    const double V = (m1 * v1 + m2 * v2) / (m1 + m2), factor = v1 > v2 ? -e : 1;
    return {V + factor * (v1 - V), V + factor * (v2 - V)};
}

LineVelocities with_impulse(double j, double m1, double m2, double v1, double v2)
{
    return {v1 - j / m1, v2 + j / m2};
}

double reduced(double m1, double m2)
{
    return m1 * m2 / (m1 + m2);
}

const Candidates<LineCollision>::Wrong ordinary_collisions = {
    {"is wrong unless the bodies stick together",
     [](double m1, double m2, double v1, double v2, double e) {
         const LineVelocities stuck = by_impulse(m1, m2, v1, v2, 0);
         return v1 > v2 ? LineVelocities{stuck.v1 - e * v1, stuck.v2 - e * v2} : stuck;
     }},
    {"is wrong unless both bodies have the same mass",
     [](double m1, double m2, double v1, double v2, double e) {
         return v1 > v2 ? with_impulse((1 + e) * (v1 - v2) * reduced(m1, m2), m2, m1, v1, v2)
                        : LineVelocities{v1, v2};
     }},
    {"is wrong unless the restitution is 1", [](double m1, double m2, double v1, double v2,
                                                double) { return by_impulse(m1, m2, v1, v2, 1); }},
    {"is wrong unless the restitution is 0 or 1",
     [](double m1, double m2, double v1, double v2, double e) {
         return by_impulse(m1, m2, v1, v2, e * e);
     }},
    {"is wrong unless body 2 is at rest",
     [](double m1, double m2, double v1, double v2, double e) {
         const LineVelocities after = by_impulse(m1, m2, v1, 0, e);
         return v1 > v2 ? LineVelocities{after.v1, v2 + after.v2} : LineVelocities{v1, v2};
     }},
    {"gives one body the impulse and not the other",
     [](double m1, double m2, double v1, double v2, double e) {
         return LineVelocities{v1, by_impulse(m1, m2, v1, v2, e).v2};
     }},
    {"is wrong for bodies of another mass than 1 kg",
     [](double, double, double v1, double v2, double e) { return by_impulse(1, 1, v1, v2, e); }},
    {"takes the bodies for each other in its result",
     [](double m1, double m2, double v1, double v2, double e) {
         const LineVelocities after = by_impulse(m1, m2, v1, v2, e);
         return v1 > v2 ? LineVelocities{after.v2, after.v1} : after;
     }},
};

const Candidates<LineCollision>::Wrong special_collisions = {
    {"is wrong where the bodies do not approach",
     [](double m1, double m2, double v1, double v2, double e) {
         return with_impulse((1 + e) * (v1 - v2) * reduced(m1, m2), m1, m2, v1, v2);
     }},
    {"is wrong where body 1 does not move to the right",
     [](double m1, double m2, double v1, double v2, double e) {
         return v1 > 0 ? by_impulse(m1, m2, v1, v2, e) : LineVelocities{v1, v2};
     }},
    {"is wrong where a body is much heavier than the other",
     [](double m1, double m2, double v1, double v2, double e) {
         return by_impulse(m1, m1 < 0.01 * m2 ? 1e9 * m2 : m2, v1, v2, e);
     }},
    {"is wrong for slow bodies",
     [](double m1, double m2, double v1, double v2, double e) {
         return by_impulse(m1, m2, v1, v2, v1 - v2 < 1e-3 ? 0 : e);
     }},
    {"is wrong for a small restitution",
     [](double m1, double m2, double v1, double v2, double e) {
         return by_impulse(m1, m2, v1, v2, e < 0.1 ? 0 : e);
     }},
    {"is wrong for fast bodies",
     [](double m1, double m2, double v1, double v2, double e) {
         return by_impulse(m1, m2, v1, std::max(v2, v1 - 100), e);
     }},
    {"is wrong for a restitution of exactly 1",
     [](double m1, double m2, double v1, double v2, double e) {
         if (v1 > v2 && e == 1) return LineVelocities{v2, v1};
         return by_impulse(m1, m2, v1, v2, e);
     }},
    {"is wrong for a restitution of exactly 0",
     [](double m1, double m2, double v1, double v2, double e) {
         if (v1 > v2 && e == 0) return LineVelocities{(v1 + v2) / 2, (v1 + v2) / 2};
         return by_impulse(m1, m2, v1, v2, e);
     }},
    {"is wrong where the bodies have the same velocity",
     [](double m1, double m2, double v1, double v2, double e) {
         const double d = v1 - v2, switched = (1 + d / std::abs(d)) / 2; // 0 / 0
         return with_impulse((1 + e) * d * switched * reduced(m1, m2), m1, m2, v1, v2);
     }},
    {"is wrong where the center of mass is at rest",
     [](double m1, double m2, double v1, double v2, double e) {
         if (v1 <= v2) return LineVelocities{v1, v2};
         const double V = (m1 * v1 + m2 * v2) / (m1 + m2);
         return LineVelocities{V * (1 + e * (1 - v1 / V)), V * (1 + e * (1 - v2 / V))};
     }},
    {"is wrong where a body is much slower than the other",
     [](double m1, double m2, double v1, double v2, double e) {
         if (v1 > v2 && std::abs(v2) < 1e-6 * std::abs(v1)) v2 = 0;
         return by_impulse(m1, m2, v1, v2, e);
     }},
    {"is wrong for very slow bodies",
     [](double m1, double m2, double v1, double v2, double e) {
         return by_impulse(m1, m2, v1, v2, v1 - v2 < 1e-7 ? 0 : e);
     }},
    {"is wrong for very heavy bodies",
     [](double m1, double m2, double v1, double v2, double e) {
         return by_impulse(std::min(m1, 1e7), m2, v1, v2, e);
     }},
    {"is off by a ten-billionth for a body that is much lighter than the other",
     [](double m1, double m2, double v1, double v2, double e) {
         const LineVelocities after = by_impulse(m1, m2, v1, v2, e);
         return LineVelocities{m1 < 1e-4 * m2 ? after.v1 * (1 + 1e-10) : after.v1, after.v2};
     }},
    {"is off by a ten-millionth",
     [](double m1, double m2, double v1, double v2, double e) {
         const LineVelocities after = by_impulse(m1, m2, v1, v2, e);
         return LineVelocities{after.v1, after.v2 * (1 + 1e-7)};
     }},
};

} // namespace

const Candidates<LineCollision>& line_collisions()
{
    static const Candidates<LineCollision> all = {
        {by_impulse, about_the_center, by_the_masses, by_a_factor},
        ordinary_collisions,
        special_collisions};
    return all;
}

} // namespace rigor::testing
