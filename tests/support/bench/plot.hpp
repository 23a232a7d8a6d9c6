// SPDX-License-Identifier: MIT
// Curves on two logarithmic or two linear axes, as one SVG file without references to other files.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rigor {

struct Series {
    std::string name;
    std::vector<std::pair<double, double>> points; // x > 0 and y ≥ 0 on logarithmic axes
    bool dashed = false;
};

struct Plot {
    std::string title, x_label, y_label; // with units
    std::vector<Series> series;          // color and marker tell up to eight apart
    double least_y = 1e-17;              // lower values, and 0, are drawn here
    bool is_linear = false;              // for both axes; then least_y has no effect
};

/// The picture, with decades or round steps on its axes, a legend and a background of its own,
/// which is dark on dark screens. A point is left out if it is not finite, or if the axis cannot
/// show its x. Linear curves have no markers.
std::string svg_of(const Plot& plot);

/// @throws std::runtime_error if the file cannot be written completely
void write_plot(const Plot& plot, const std::string& file);

/// The folder after the option `--out`, made if needed; empty if the option is not there.
/// @throws std::runtime_error if no folder follows or if it cannot be made
std::string plot_folder(int argc, char** argv);

} // namespace rigor
