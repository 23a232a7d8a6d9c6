// SPDX-License-Identifier: MIT
// Cases that break engines, each with stated limits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rigor::stress {

/// A figure and the most it may be. Classes: R rounding, O order, I invariant, B bracket.
struct Check {
    std::string what;
    double figure = 0, limit = 0;
    char tolerance_class = 'I';

    bool met() const { return figure <= limit; } // a figure that is not a number keeps no limit
};

/// What every case records, and what it asks for.
struct Record {
    double penetration = 0; // the largest [m]
    double energy_gain = 0; // over the start, in units of the case's energy scale
    double drift = 0;       // of what should have stayed, in the units of its check
    int not_finite = 0;     // states that were not numbers
    std::int64_t steps = 0;
    double seconds = 0; // of the steps alone
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
    std::string line; // what it stresses: cases of one line print together
    std::string name;
    bool is_quick = false; // also run by the tests of every build
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

/// How much two bodies may overlap while they rest or slide, as a share of the smaller one's edge;
/// class I. It is also the energy that a scene may gain, as the weight lifted by it.
inline constexpr double allowed_depth = 0.01;

/// The same while they hit each other, many at once.
inline constexpr double allowed_impact_depth = 0.1;

/// Something stands if nothing of it is farther from its place than this share of its edge; class B.
inline constexpr double standing = 0.5;

} // namespace rigor::stress
