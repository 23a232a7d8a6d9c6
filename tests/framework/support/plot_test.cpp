// SPDX-License-Identifier: MIT
#include "support/bench/plot.hpp"

#include "support/catch.hpp"

#include <limits>

using namespace rigor;

namespace {

int count(const std::string& text, const std::string& words)
{
    int n = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
        ++n;
    return n;
}

Plot one_curve(std::vector<std::pair<double, double>> points)
{
    Plot plot;
    plot.title = "a < b & c";
    plot.series = {{"ours", std::move(points)}};
    return plot;
}

} // namespace

TEST_CASE("plot: a decade is as wide as the next", "[plot]")
{
    // x from 1 to 100 takes the pixels 84 to 620, so 10 is in the middle; y goes from 10 at the top
    // to 1 at the bottom.
    const std::string svg = svg_of(one_curve({{1, 10}, {10, 10}, {100, 1}}));
    REQUIRE(count(svg, "M84.0 52.0L352.0 52.0L620.0 404.0") == 1);
}

TEST_CASE("plot: linear axes begin and end with a round value", "[plot]")
{
    // x goes from -1 to 1 in steps of 0.5, with 0 in the middle; y goes from 0 to 300.
    Plot plot = one_curve({{-0.9, 1}, {0, 150}, {1, 300}});
    plot.is_linear = true;
    const std::string svg = svg_of(plot);
    REQUIRE(count(svg, "L352.0 228.0L620.0 52.0") == 1);
    REQUIRE(count(svg, ">−0.5</text>") == 1);
    REQUIRE(count(svg, ">300</text>") == 1);
    INFO("no marker turns a curve of a thousand points into a caterpillar");
    REQUIRE(count(svg, "translate(") == 1); // the label of y
}

TEST_CASE("plot: every point has its marker and the legend one more", "[plot]")
{
    // Three markers, one in the legend, and the label of y.
    REQUIRE(count(svg_of(one_curve({{1, 1}, {2, 1}, {3, 1}})), "translate(") == 3 + 1 + 1);
}

TEST_CASE("plot: an error of zero is drawn at the floor", "[plot]")
{
    Plot plot = one_curve({{1, 1}, {10, 0}});
    plot.least_y = 1e-4;
    REQUIRE(count(svg_of(plot), "M84.0 52.0L620.0 404.0") == 1);
}

TEST_CASE("plot: what is not a number is left out", "[plot]")
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::string all = svg_of(one_curve({{1, 1}, {nan, 1}, {2, infinity}, {0, 1}, {10, 10}}));
    REQUIRE(all == svg_of(one_curve({{1, 1}, {10, 10}})));
    REQUIRE(count(svg_of(one_curve({{nan, nan}})), "nan") == 0);
}

TEST_CASE("plot: text is no markup", "[plot]")
{
    REQUIRE(count(svg_of(one_curve({{1, 1}})), ">a &lt; b &amp; c</text>") == 1);
}

TEST_CASE("plot: a file that cannot be written is an error", "[plot]")
{
    REQUIRE_THROWS_AS(write_plot(one_curve({{1, 1}}), "/dev/null/plot.svg"), std::runtime_error);
}
