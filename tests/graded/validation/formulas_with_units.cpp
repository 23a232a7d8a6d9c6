// SPDX-License-Identifier: MIT
#include "candidates.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::testing {

namespace {

using N = std::vector<double>;
using Formulas = std::vector<FormulaWithUnits>;

namespace dimensions {

constexpr Dimension number = {}, mass = {1, 0, 0}, length = {0, 1, 0}, time = {0, 0, 1},
                    speed = {0, 1, -1}, rate = {0, 0, -1}, acceleration = {0, 1, -2},
                    force = {1, 1, -2}, energy = {1, 2, -2}, momentum = {1, 1, -1},
                    stiffness = {1, 0, -2}, inertia = {1, 2, 0};

} // namespace dimensions

// A number whose root is taken ten times, and squared again. The squares make the rounding of the
// roots a thousand times larger, to about 1e-13 of the number.
double through_roots(double number)
{
    for (int i = 0; i < 10; ++i)
        number = std::sqrt(number);
    for (int i = 0; i < 10; ++i)
        number *= number;
    return number;
}

// Whether two numbers are equal up to 1e-9 of the larger one.
bool nearly_equal(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

} // namespace

const Formulas& right_units()
{
    using namespace dimensions;
    static const Formulas all = {
        {"", [](N a) { return N{a[0] * a[1] * a[1] / 2}; }, {2.5, -3}, {mass, speed}, {energy}},
        {"",
         [](N a) { return N{2 * M_PI * std::sqrt(a[0] / a[1])}; },
         {0.7, 9.81},
         {length, acceleration},
         {time}},
        {"",
         [](N a) { return N{std::pow(a[0] / a[1], 0.5)}; }, // rounds differently from std::sqrt
         {12, 0.3},
         {stiffness, mass},
         {rate}},
        {"",
         [](N a) {
             return N{a[1] * a[5] - a[2] * a[4], a[2] * a[3] - a[0] * a[5],
                      a[0] * a[4] - a[1] * a[3]};
         },
         {0.1, -0.4, 0.3, 5, 2, -7},
         {length, length, length, force, force, force},
         {energy, energy, energy}},
        {"",
         [](N a) { // a threshold relative to another number is right
             return N{nearly_equal(a[1], a[2]) ? 0 : a[0] * (a[1] - a[2]), a[3]};
         },
         {3, 2, 2.0000001, 0.25},
         {mass, speed, speed, number},
         {momentum, number}},
        {"",
         [](N a) {
             return N{std::cbrt(a[0] / a[1]), a[2] * std::cos(a[3])};
         },
         {6.5, 1.2, 0.8, 1.1},
         {mass, {1, -3, 0}, speed, number},
         {length, speed}},
        {"",
         [](N a) { // divides, unless that would be by zero
             const double K = 1 / a[0] + a[1] * a[1] / a[2];
             return N{K == 0 ? 0 : -a[3] / K};
         },
         {2, 0.6, 1.4, -3.5},
         {mass, length, inertia, speed},
         {momentum}},
        {"",
         [](N a) {
             return N{through_roots(a[0] / a[1]), through_roots(a[0]) * a[2]};
         },
         {3, 0.7, 5},
         {length, time, rate},
         {speed, speed}},
    };
    return all;
}

const Formulas& wrong_powers()
{
    using namespace dimensions;
    static const Formulas all = {
        {"misses a power of a speed",
         [](N a) { return N{a[0] * a[1] / 2}; },
         {2.5, 3},
         {mass, speed},
         {energy},
         [](N a) { return N{a[0] * a[1] * a[1] / 2}; }},
        {"has a constant inside, which has a unit",
         [](N a) { return N{9.81 * a[0]}; },
         {2.5, 4},
         {mass, acceleration},
         {force},
         [](N a) { return N{a[0] * a[1]}; }},
        {"is wrong only if the unit of time changes",
         [](N a) { return N{a[0] + a[1] * a[2] / 60}; },
         {1.5, 2, 60},
         {length, length, time},
         {length},
         [](N a) { return N{a[0] + a[1]}; }},
        {"is wrong only if the unit of mass changes",
         [](N a) { return N{a[0] * a[0] * a[1]}; },
         {3, 2},
         {mass, acceleration},
         {force},
         [](N a) { return N{a[0] * a[1]}; }},
        {"is right if mass and length grow by the same factor",
         [](N a) { return N{a[0] * a[0] / a[1] * a[2]}; },
         {3, 0.5, 2},
         {mass, length, speed},
         {momentum},
         [](N a) { return N{a[0] * a[2]}; }},
        {"adds numbers of different dimensions",
         [](N a) { return N{a[0] + a[1]}; },
         {0.3, 4},
         {length, speed},
         {length},
         [](N a) { return N{2 * a[0]}; }},
        {"is wrong in its last number only",
         [](N a) {
             return N{a[0] * a[1], a[0] * a[2], a[0] * a[0] * a[3]};
         },
         {0.5, 1, -2, 3},
         {mass, speed, speed, speed},
         {momentum, momentum, momentum},
         [](N a) {
             return N{a[0] * a[1], a[0] * a[2], a[0] * a[3]};
         }},
        {"takes a length for an angle",
         [](N a) { return N{a[0] * std::sin(a[1])}; },
         {3, 0.4},
         {speed, length},
         {speed},
         [](N a) { return N{-a[0]}; }},
        {"has a constant inside that does not matter to the example, where the result is 0",
         [](N a) { return N{std::max(0.0, a[0] - 9.81 * a[1])}; },
         {3, 0.5, 8},
         {speed, time, acceleration},
         {speed},
         [](N a) { return N{std::max(0.0, a[0] - a[2] * a[1])}; }},
    };
    return all;
}

const Formulas& wrong_thresholds()
{
    using namespace dimensions;
    static const Formulas all = {
        {"takes a small number for zero",
         [](N a) { return N{std::abs(a[1]) < 1e-6 ? 0 : a[0] * a[1]}; },
         {2, -3},
         {mass, speed},
         {momentum},
         [](N a) { return N{a[0] * a[1]}; }},
        {"adds a small number, so that it does not divide by zero",
         [](N a) { return N{a[0] / (a[1] + 1e-6)}; },
         {1.5, 0.7},
         {length, time},
         {speed},
         [](N a) { return N{a[0] / a[1]}; }},
        {"limits a number",
         [](N a) { return N{std::min(a[0] * a[1], 1000.0)}; },
         {2, 3},
         {mass, acceleration},
         {force},
         [](N a) { return N{a[0] * a[1]}; }},
        {"takes small masses for zero",
         [](N a) { return N{a[0] < 1e-3 ? 0 : a[0] * a[1] * a[1]}; },
         {2, 0.3},
         {mass, length},
         {inertia},
         [](N a) { return N{a[0] * a[1] * a[1]}; }},
        {"takes a long time for another one",
         [](N a) { return N{a[0] * std::min(a[1], 3600.0)}; },
         {2, 0.01},
         {speed, time},
         {length},
         [](N a) { return N{a[0] * a[1]}; }},
        {"rounds to a millionth of a unit",
         [](N a) { return N{std::round(a[0] * a[1] * 1e6) / 1e6}; },
         {0.75, 0.5},
         {speed, time},
         {length},
         [](N a) { return N{a[0] * a[1]}; }},
        {"stops its iteration at a difference that has a unit",
         [](N a) {
             double x = a[0] / 2 + 1e-9; // the square root, by Newton's method
             for (int i = 0; i < 200 && std::abs(x * x - a[0]) > 1e-8; ++i)
                 x = (x + a[0] / x) / 2;
             return N{x};
         },
         {1.7},
         {{0, 2, 0}},
         {length},
         [](N a) { return N{std::sqrt(a[0])}; }},
        {"limits a number of the result, which is small beside another one",
         [](N a) {
             return N{a[0] * a[1], std::min(a[2], 1e-3)};
         },
         {3e6, 0.5, 2e-7},
         {stiffness, length, length},
         {force, length},
         [](N a) {
             return N{a[0] * a[1], a[2]};
         }},
        {"takes a number for zero that is 2^38 times as small as the example",
         [](N a) { return N{a[1] < 8e-12 ? 0 : a[0] * a[1]}; },
         {2, 2},
         {acceleration, time},
         {speed},
         [](N a) { return N{a[0] * a[1]}; }},
        {"has a limit that is 2^38 times as large as the example",
         [](N a) { return N{a[0] * std::min(a[1], 1e12)}; },
         {3, 2},
         {speed, mass},
         {momentum},
         [](N a) { return N{a[0] * a[1]}; }},
        {"changes its sign for large numbers",
         [](N a) { return N{a[1] > 1e6 ? -a[0] * a[1] : a[0] * a[1]}; },
         {2, 3},
         {mass, acceleration},
         {force},
         [](N a) { return N{a[0] * a[1]}; }},
        {"is off by a ten-millionth for slow bodies",
         [](N a) { return N{a[0] * a[1] * (1 + 1e-7 * std::tanh(a[1] * a[1]))}; },
         {2, 3},
         {mass, speed},
         {momentum},
         [](N a) { return N{a[0] * a[1]}; }},
        {"is no number for small arguments",
         [](N a) { return N{a[1] < 1e-6 ? std::nan("") : a[0] / a[1]}; },
         {2, 3},
         {length, time},
         {speed},
         [](N a) { return N{a[0] / a[1]}; }},
    };
    return all;
}

} // namespace rigor::testing
