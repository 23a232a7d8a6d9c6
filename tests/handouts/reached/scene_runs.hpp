// SPDX-License-Identifier: MIT
// Runs of shipped scenes with changed keys, as a student makes them.
#pragma once

#include "scene/trajectory/statistics.hpp"

#include <string>
#include <vector>

namespace rigor::handouts {

/// What `simulate --stats` prints of a run.
struct Run {
    FrameStatistics first, last;
    double deepest = 0; // penetration [m]
};

/// A change of a scene file: the value of a key that stands in it once.
struct Change {
    std::string key, value;
};

/// Runs a scene such as "a5-contact/stack" with these changes of its file.
Run run(const std::string& name, const std::vector<Change>& changes);

/// A number in a format of printf.
std::string number(double value, const char* format);

/// Checks that the handout of an assignment has these words, whatever the ends of its lines.
void check_says(const std::string& name, const std::string& words);

} // namespace rigor::handouts
