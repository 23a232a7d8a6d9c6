// SPDX-License-Identifier: MIT
// The figures of assignment A8, about tests: which law catches which wrong kinetic energy, and how
// the errors of two methods for an oscillator fall with the time step. Each mark in the table of
// laws is found by trying the law on the formula.
#include "figures/validation_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace rigor::figures {

namespace {

using Energy = double (*)(double mass, const Vector3d& v);

bool equal(double a, double b)
{
    return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

// A law that E has to keep, a case computed by hand: 1 kg at 2 m/s has 2 J.
bool keeps_case_by_hand(Energy E)
{
    return equal(E(1, {2, 0, 0}), 2);
}

// The law that a rotation Q of the velocity does not change the energy: E(m, Q v) = E(m, v).
bool keeps_turning(Energy E)
{
    const Vector3d v(0.3, -1.2, 0.5);
    const Eigen::AngleAxisd Q(0.7, Vector3d(1, 2, -2).normalized());
    return equal(E(3, Q * v), E(3, v));
}

// The law that the energies of two masses add up: E(m₁ + m₂, v) = E(m₁, v) + E(m₂, v).
bool keeps_sum(Energy E)
{
    const Vector3d v(0.3, -1.2, 0.5);
    return equal(E(5, v), E(2, v) + E(3, v));
}

// The law of units: if the unit of mass or of speed changes, E changes as its unit kg m²/s² does.
bool keeps_units(Energy E)
{
    const Vector3d v(0.3, -1.2, 0.5);
    for (const int power : {-40, -1, 1, 40}) {
        const double s = std::ldexp(1.0, power), e = E(3, v);
        if (!equal(E(3 * s, v), s * e)) return false;
        if (!equal(E(3, s * v), s * s * e)) return false;
        if (!equal(E(3, v / s), e / (s * s))) return false;
    }
    return true;
}

struct Law {
    const char* name;
    bool (*is_kept)(Energy E);
};

constexpr std::array<Law, 4> laws = {{{"by hand", keeps_case_by_hand},
                                      {"turned", keeps_turning},
                                      {"m₁ + m₂", keeps_sum},
                                      {"units", keeps_units}}};

struct Formula {
    const char* name;
    Energy energy;
};

constexpr std::array<Formula, 7> formulas = {
    {{"½ m |v|²", [](double m, const Vector3d& v) { return m * v.squaredNorm() / 2; }},
     {"m |v|²", [](double m, const Vector3d& v) { return m * v.squaredNorm(); }},
     {"½ m |v|", [](double m, const Vector3d& v) { return m * v.norm() / 2; }},
     {"½ m² |v|²", [](double m, const Vector3d& v) { return m * m * v.squaredNorm() / 2; }},
     {"½ m vₓ²", [](double m, const Vector3d& v) { return m * v.x() * v.x() / 2; }},
     {"½ m (|vₓ| + |v_{y}| + |v_{z}|)²",
      [](double m, const Vector3d& v) { return m * std::pow(v.lpNorm<1>(), 2) / 2; }},
     {"0 if |v| < 1e-6 m/s",
      [](double m, const Vector3d& v) { return v.norm() < 1e-6 ? 0 : m * v.squaredNorm() / 2; }}}};

Drawing laws_and_mistakes()
{
    Drawing drawing("Kinetic energies, the first of them right, and the laws that reject them: a "
                    "mark where a law is broken.",
                    660, 380);
    drawing.place({250, 70}, 1);
    constexpr double column = 100, row = 42;
    for (std::size_t l = 0; l < laws.size(); ++l)
        drawing.label({column * (static_cast<double>(l) + 0.5), 8}, laws[l].name, Side::above);
    for (std::size_t f = 0; f < formulas.size(); ++f) {
        const double y = -row * (static_cast<double>(f) + 0.5);
        drawing.label({0, y}, formulas[f].name, Side::left, f == 0 ? "green" : "ink");
        for (std::size_t l = 0; l < laws.size(); ++l) {
            const double x = column * static_cast<double>(l);
            const bool kept = laws[l].is_kept(formulas[f].energy);
            const Points cell = {{x + 3, y - row / 2 + 3},
                                 {x + column - 3, y - row / 2 + 3},
                                 {x + column - 3, y + row / 2 - 3},
                                 {x + 3, y + row / 2 - 3}};
            drawing.polygon(cell, kept ? "grey thin" : "red filled");
            if (!kept) drawing.label({x + column / 2, y}, "broken", Side::middle, "red");
        }
    }
    return drawing;
}

// The position and the velocity of an oscillator with ω = 1.
using State = Vector2d;

State exact(const State& s, double h)
{
    return {s.x() * std::cos(h) + s.y() * std::sin(h), s.y() * std::cos(h) - s.x() * std::sin(h)};
}

// Euler's method: the slope x' = v, v' = -x at the start of the step.
State euler(const State& s, double h)
{
    return s + h * State(s.y(), -s.x());
}

// The midpoint method: the slope in the middle of the step.
State midpoint(const State& s, double h)
{
    const State middle = euler(s, h / 2);
    return s + h * State(middle.y(), -middle.x());
}

Drawing order()
{
    Drawing drawing("The error of one step over its length, both on logarithmic scales: Euler's "
                    "step falls by two decades for one of the step, the midpoint method by three.",
                    660, 380);
    const State start(0.6, 0.8); // the amplitude is 1
    drawing.place({400, 45}, 1);
    constexpr double across = 110, down = 28; // lengths of a power of ten on the two axes
    const auto at = [&](double h, double error) {
        return Vector2d(across * std::log10(h), down * std::log10(error));
    };
    for (const int power : {0, -2, -4, -6, -8, -10}) {
        drawing.line(at(1e-3, std::pow(10, power)), at(1, std::pow(10, power)), "grey thin");
        drawing.label(at(1e-3, std::pow(10, power)), power == 0 ? "1" : fmt::format("1e{}", power),
                      Side::left, "grey");
    }
    for (const int power : {-3, -2, -1, 0})
        drawing.label(at(std::pow(10, power), 1e-10) - Vector2d(0, 5),
                      fmt::format("{:g}", std::pow(10, power)), Side::below, "grey");
    drawing.label(at(0.0316, 1e-10) - Vector2d(0, 24), "ω h", Side::below);
    drawing.label(at(1e-3, 1) + Vector2d(-40, 18), "error of one step, in amplitudes A",
                  Side::right);
    const auto errors = [&](State (*step)(const State&, double)) {
        return Drawing::sampled(-3, 0, 30, [&](double power) {
            const double h = std::pow(10, power);
            return at(h, (step(start, h) - exact(start, h)).norm());
        });
    };
    drawing.line(at(1e-3, 1e-9), at(1, 1), "ink dashed");
    drawing.curve(errors(euler), "red");
    drawing.curve(errors(midpoint), "blue");
    const auto ratio = [&](State (*step)(const State&, double)) {
        const auto error = [&](double h) { return (step(start, h) - exact(start, h)).norm(); };
        return error(0.02) / error(0.01);
    };
    drawing.place({0, 0}, 1);
    drawing.label({420, -60}, "bound (ω h)³ A", Side::right);
    drawing.label({420, -95}, "Euler, first order", Side::right, "red");
    std::string text = fmt::format("half the step: 1/{:.1f}", ratio(euler));
    drawing.label({420, -117}, text, Side::right, "red");
    drawing.label({420, -152}, "midpoint, second order", Side::right, "blue");
    text = fmt::format("half the step: 1/{:.1f}", ratio(midpoint));
    drawing.label({420, -174}, text, Side::right, "blue");
    return drawing;
}

} // namespace

std::span<const Figure> validation_figures()
{
    static constexpr Figure all[] = {{"a8-validation", "laws", laws_and_mistakes},
                                     {"a8-validation", "order", order}};
    return all;
}

} // namespace rigor::figures
