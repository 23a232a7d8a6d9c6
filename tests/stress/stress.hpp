// SPDX-License-Identifier: MIT
// Cases that are difficult for physics engines, each with stated limits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rigor::stress {

/// A measured value and its upper limit. Classes: R rounding, O order, I invariant, B bracket.
struct Check {
    std::string what;
    double figure = 0, limit = 0;
    char tolerance_class = 'I';

    bool met() const { return figure <= limit; } // false for a value that is not a number
};

/// The values that every case records, and its limits.
struct Record {
    double penetration = 0; // the largest one [m]
    double energy_gain = 0; // since the start, in units of the case's energy scale
    double drift = 0;       // change of what must stay constant, in the units of its check
    int not_finite = 0;     // number of states that were not finite
    std::int64_t steps = 0;
    double seconds = 0; // time of the steps alone
    std::vector<Check> checks;

    void limit(const std::string& what, double figure, double most, char tolerance_class)
    {
        checks.push_back({what, figure, most, tolerance_class});
    }
    void limit_drift(const std::string& what, double figure, double most, char tolerance_class)
    {
        drift = figure;
        limit(what, figure, most, tolerance_class);
    }
    bool met() const;
};

struct Case {
    std::string line; // the topic; cases with the same one are printed together
    std::string name;
    bool is_quick = false; // whether the tests of every build run it too
    std::function<void(Record&)> run;
};

using Suite = std::vector<Case>;

void add_spinning(Suite& suite);
void add_resting(Suite& suite);
void add_seesaw(Suite& suite);
void add_overlap(Suite& suite);
void add_fast(Suite& suite);
void add_touching(Suite& suite);
void add_material(Suite& suite);
void add_scale(Suite& suite);
void add_weightless(Suite& suite);

/// Largest overlap of two bodies that rest or slide, as a fraction of the smaller one's edge; class
/// I. It is also the energy that a scene may gain, as the energy of lifting the bodies by this
/// height.
inline constexpr double allowed_depth = 0.01;

/// The same limit while many bodies hit each other at once.
inline constexpr double allowed_impact_depth = 0.1;

/// A scene counts as standing if no body is farther from its place than this fraction of its edge;
/// class B.
inline constexpr double standing = 0.5;

} // namespace rigor::stress
