// SPDX-License-Identifier: MIT
// `bench_pile`'s own command line: a part of the benchmark, for whoever works on the engine.
#pragma once

#include <string>
#include <vector>

namespace rigor {

struct PileChoice {
    std::vector<int> sides = {10, 14, 17}; // --cubes: side³ cubes, may be repeated
    std::vector<std::string> engines;      // --engine: empty for all
    int rounds = 3, steps = 300;           // --rounds, --steps
    std::vector<std::string> parts;        // --part: cubes, settled, threads, nonconvex; or all
    bool json = false;

    bool wants(const std::string& engine) const;
    bool does(const std::string& part) const;
};

/// @throws std::invalid_argument what was expected and what was found
PileChoice pile_choice(int argc, char** argv);

} // namespace rigor
