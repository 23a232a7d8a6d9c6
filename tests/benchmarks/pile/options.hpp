// SPDX-License-Identifier: MIT
// The command line of `bench_pile`, which selects a part of the benchmark.
#pragma once

#include <string>
#include <vector>

namespace rigor {

struct PileChoice {
    std::vector<int> sides = {10, 14, 17}; // --cubes: side³ cubes; may be repeated
    std::vector<std::string> engines;      // --engine; empty for all
    int rounds = 3, steps = 300;           // --rounds, --steps
    std::vector<std::string> parts;        // --part: cubes, settled, threads, nonconvex; empty: all
    bool json = false;

    bool wants(const std::string& engine) const;
    bool does(const std::string& part) const;
};

/// @throws std::invalid_argument if an option is unknown or its value is not valid
PileChoice pile_choice(int argc, char** argv);

} // namespace rigor
