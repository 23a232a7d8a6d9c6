// SPDX-License-Identifier: MIT
// Curves on two logarithmic or two linear axes, as one SVG file that needs nothing else.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rigor {

struct Series {
    std::string name;
    std::vector<std::pair<double, double>> points; // on logarithmic axes x > 0, y ≥ 0
    bool dashed = false;
};

struct Plot {
    std::string title, x_label, y_label; // with units
    std::vector<Series> series;          // told apart by color and by marker, up to eight
    double least_y = 1e-17;              // what is below, 0 too, is drawn here
    bool is_linear = false;              // both axes; then least_y means nothing
};

/// The picture: axes with decades or round steps, a legend, its own background; dark where the reader's screen is. A
/// point that is not finite, or whose x no axis can show, is left out. Linear curves have no markers.
std::string svg_of(const Plot& plot);

/// @throws std::runtime_error if the file cannot be written whole
void write_plot(const Plot& plot, const std::string& file);

/// The folder after `--out`, made if need be; empty if the option is not there.
/// @throws std::runtime_error if no folder follows, or it cannot be made
std::string plot_folder(int argc, char** argv);

} // namespace rigor
