// SPDX-License-Identifier: MIT
#include "candidates.hpp"

#include <cmath>

namespace rigor::testing {

namespace {

using State = OscillatorState;

// A method that is a matrix M: (x, v/ω) → M (x, v/ω) for the angle ω h of the step.
template <class Matrix> Function<OscillatorStep> by_matrix(const Matrix& matrix)
{
    return [matrix](const State& s, double w, double h) {
        const Eigen::Vector2d y = matrix(w * h) * Eigen::Vector2d(s.x, s.v / w);
        return State{y[0], y[1] * w};
    };
}

Eigen::Matrix2d rows(double a, double b, double c, double d)
{
    return (Eigen::Matrix2d() << a, b, c, d).finished();
}

State midpoint(State s, double w, double h)
{
    const double x = s.x + h / 2 * s.v, v = s.v - h / 2 * w * w * s.x;
    return {s.x + h * v, s.v - h * w * w * x};
}

State verlet(State s, double w, double h)
{
    const double v_half = s.v - h / 2 * w * w * s.x;
    const double x = s.x + h * v_half;
    return {x, v_half - h / 2 * w * w * x};
}

Eigen::Matrix2d exact(double a)
{
    return rows(std::cos(a), std::sin(a), -std::sin(a), std::cos(a));
}

Eigen::Matrix2d trapezoid(double a)
{
    const double q = a * a / 4;
    return rows(1 - q, a, -a, 1 - q) / (1 + q);
}

// Runge and Kutta's method of fourth order.
Eigen::Matrix2d fourth_order(double a)
{
    const double even = 1 - a * a / 2 + a * a * a * a / 24, odd = a - a * a * a / 6;
    return rows(even, odd, -odd, even);
}

State euler(State s, double w, double h)
{
    return {s.x + h * s.v, s.v - h * w * w * s.x};
}

const Candidates<OscillatorStep>::Wrong ordinary_steps = {
    {"is of first order only", euler},
    {"is of first order only",
     [](const State& s, double w, double h) {
         const double v = s.v - h * w * w * s.x;
         return State{s.x + h * v, v};
     }},
    {"is of first order only",
     [](const State& s, double w, double h) {
         const double v = (s.v - h * w * w * s.x) / (1 + h * h * w * w);
         return State{s.x + h * v, v};
     }},
    {"is of first order in the velocity",
     [](const State& s, double w, double h) {
         return State{midpoint(s, w, h).x, euler(s, w, h).v};
     }},
    {"is wrong unless the frequency is 1 rad/s",
     [](const State& s, double w, double h) {
         State after = midpoint(s, std::sqrt(w), h);
         return after;
     }},
    {"goes backwards", [](const State& s, double w, double h) { return midpoint(s, w, -h); }},
    {"is wrong unless the oscillator begins at rest",
     [](const State& s, double w, double h) {
         return verlet({s.x, 0}, w, h);
     }},
    {"does not move", [](const State& s, double, double) { return s; }},
};

const Candidates<OscillatorStep>::Wrong special_steps = {
    {"loses a little energy",
     [](const State& s, double w, double h) {
         const State after = midpoint(s, w, h);
         return State{after.x, after.v * (1 - 0.01 * w * h)};
     }},
    {"is wrong in long steps",
     [](const State& s, double w, double h) {
         return w * h > 0.3 ? euler(s, w, h) : midpoint(s, w, h);
     }},
    {"is wrong in short steps",
     [](const State& s, double w, double h) {
         return w * h < 0.01 ? euler(s, w, h) : midpoint(s, w, h);
     }},
    {"is wrong on one side of x = 0",
     [](const State& s, double w, double h) {
         return s.x < 0 ? euler(s, w, h) : midpoint(s, w, h);
     }},
    {"is wrong for large amplitudes",
     [](const State& s, double w, double h) {
         State after = verlet(s, w, h);
         after.x = std::clamp(after.x, -20.0, 20.0);
         return after;
     }},
    {"is wrong for a high frequency",
     [](const State& s, double w, double h) { return midpoint(s, std::min(w, 50.0), h); }},
};

} // namespace

const Candidates<OscillatorStep>& oscillator_steps()
{
    static const Candidates<OscillatorStep> all = {
        {midpoint, verlet, by_matrix(exact), by_matrix(trapezoid), by_matrix(fourth_order)},
        ordinary_steps,
        special_steps};
    return all;
}

} // namespace rigor::testing
