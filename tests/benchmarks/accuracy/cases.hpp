// SPDX-License-Identifier: MIT
// The cases of `bench accuracy`: a trial, its end time, and its error against the exact solution.
#pragma once

#include "benchmarks/engines/engine.hpp"

namespace rigor {

struct AccuracyCase {
    std::string name; // file name of the plot
    std::string title;
    std::string error; // description of the error, with its unit
    Trial trial;
    double end = 0;              // [s]
    std::vector<int> steps;      // number of steps of each run
    std::vector<int> peer_steps; // the same for other engines
    std::vector<Contestant> contestants;
    /// The error at the end.
    /// @param path  the first body's motion after every step, if `needs_path`
    std::function<double(const TrialEngine&, const std::vector<TrialMotion>& path)> error_of;
    bool needs_path = false;
};

/// The n numbers first, 2 first, 4 first, ….
std::vector<int> doubled(int first, int n);

AccuracyCase free_body_case();
AccuracyCase heavy_top_case();
AccuracyCase pendulum_case();
AccuracyCase bounce_case(double restitution);
AccuracyCase sliding_case();
AccuracyCase sticking_case();
AccuracyCase rolling_case();
AccuracyCase stack_case();

/// One run of a case by a contestant.
struct Point {
    int steps = 0;
    double seconds = 0; // median over the rounds
    double error = 0;
};
struct Curve {
    Contestant contestant;
    std::vector<Point> points;
};

/// Draws the curves of a case as FOLDER/<name>.svg.
/// @throws std::runtime_error if it cannot be written
void plot_case(const AccuracyCase& accuracy_case, const std::vector<Curve>& curves,
               const std::string& folder);

} // namespace rigor
