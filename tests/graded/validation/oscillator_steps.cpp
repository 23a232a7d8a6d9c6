// SPDX-License-Identifier: MIT
#include "candidates.hpp"

#include <algorithm>
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

using Eigen::Vector2d;

// The exact step and an error of third order, (ω h)³ times a function of (x, v/ω).
template <class Error> Function<OscillatorStep> beside_exact(const Error& error)
{
    return [error](const State& s, double w, double h) {
        const Vector2d before(s.x, s.v / w);
        const Vector2d y = exact(w * h) * before + std::pow(w * h, 3) * error(before);
        return State{y[0], y[1] * w};
    };
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
    {"is wrong in steps of a middle length",
     [](const State& s, double w, double h) {
         return w * h > 0.14 && w * h < 0.22 ? euler(s, w, h) : midpoint(s, w, h);
     }},
    {"is off by a little more than the bound in the position",
     beside_exact([](const Vector2d& y) { return Vector2d(1.1 * y.norm(), 0); })},
    {"is off by a little more than the bound in the velocity",
     beside_exact([](const Vector2d& y) { return Vector2d(0, 1.1 * y.norm()); })},
    {"is off by a little more than the bound in the position, from rest",
     beside_exact([](const Vector2d& y) { return Vector2d(1.1 * y[0], 0); })},
    {"is off by a little more than the bound in the velocity, from x = 0",
     beside_exact([](const Vector2d& y) { return Vector2d(0, 1.1 * y[1]); })},
    {"is off by a little more than the bound if neither x nor v is 0",
     beside_exact([](const Vector2d& y) {
         return Vector2d(1.1 * std::sqrt(2 * std::abs(y[0] * y[1])), 0);
     })},
    {"is off by six billionths in short steps",
     [](const State& s, double w, double h) {
         const State after = by_matrix(exact)(s, w, h);
         return State{after.x + (w * h < 1.5e-3 ? 6e-9 * s.x : 0), after.v};
     }},
    {"is wrong for an oscillator that rests at x = 0",
     [](const State& s, double w, double h) {
         const double A = std::hypot(s.x, s.v / w), phase = std::asin(s.x / A);
         if (s.v < 0) return verlet(s, w, h);
         return State{A * std::sin(phase + w * h), A * w * std::cos(phase + w * h)};
     }},
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
