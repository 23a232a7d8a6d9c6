// SPDX-License-Identifier: MIT
// Plots as SVG. The axes are chosen first, from the data that can be drawn. Then come the grid with
// its labels, the curves with their markers, and the legend.
#include "support/bench/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace rigor {

namespace {

// Size of the picture, and the borders of the plot in it [px].
constexpr double width = 860, height = 470;
constexpr double left = 84, right = 620, top = 52, bottom = 404;

// Colors that color-blind readers can tell apart (after Okabe & Ito 2008), on white and on near
// black.
struct Ink {
    const char *light, *dark;
};
constexpr std::array<Ink, 8> inks = {{{"#0072b2", "#4fb0e8"},
                                      {"#d55e00", "#ff8a3d"},
                                      {"#007a5a", "#2fc79b"},
                                      {"#b0508a", "#e78fc0"},
                                      {"#8a6d00", "#f0d24a"},
                                      {"#444444", "#d0d0d0"},
                                      {"#7a4fbf", "#b79cf0"},
                                      {"#a01515", "#ff7a7a"}}};

std::string format(const char* pattern, ...)
{
    char buffer[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
    va_end(arguments);
    return buffer;
}

std::string escaped(const std::string& text)
{
    std::string result;
    for (char c : text)
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
}

// @param inner  SVG; plain text must be escaped before
std::string text_at(double x, double y, const std::string& style, const std::string& inner)
{
    return format("<text x='%.1f' y='%.1f' %s>", x, y, style.c_str()) + inner + "</text>\n";
}

// A power of ten as SVG, with a small and raised exponent.
std::string power_of_ten(int exponent)
{
    return format("10<tspan dy='-5' font-size='10'>%s%d</tspan>", exponent < 0 ? "−" : "",
                  std::abs(exponent));
}

std::string number(double value)
{
    return (value < 0 ? "−" : "") + format("%g", std::abs(value));
}

// An axis with whole decades or round steps around the data, and its place in the picture.
struct Axis {
    bool is_linear = false;
    double first = 0, last = 1, step = 1; // exponents of ten, or values if the axis is linear
    double begin = 0, end = 1;            // [px]

    double at(double value) const { return place(is_linear ? value : std::log10(value)); }
    int lines() const { return static_cast<int>(std::lround((last - first) / step)); }
    double line(int i) const { return place(first + i * step); }
    bool has_label(int i) const { return is_linear || i % (lines() / 9 + 1) == 0; }
    std::string label(int i) const
    {
        const double value = first + i * step;
        return is_linear ? number(std::abs(value) < step / 2 ? 0 : value)
                         : power_of_ten(static_cast<int>(value));
    }

private:
    double place(double position) const
    {
        return begin + (end - begin) * (position - first) / (last - first);
    }
};

// A step of 1, 2 or 5 times a power of ten, so that three to eight steps cover the range.
double round_step(double range)
{
    const double decade = std::pow(10, std::floor(std::log10(range / 4)));
    return decade * (range >= 16 * decade ? 5 : range >= 8 * decade ? 2 : 1);
}

Axis axis_about(const std::vector<double>& values, double begin, double end, bool is_linear)
{
    Axis axis;
    axis.is_linear = is_linear;
    axis.begin = begin;
    axis.end = end;
    if (values.empty()) return axis;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (is_linear) {
        axis.step = *high > *low ? round_step(*high - *low) : 1;
        const double slack = 1e-9; // keeps rounding from adding a step
        axis.first = std::floor(*low / axis.step + slack) * axis.step;
        axis.last =
            std::max(axis.first + axis.step, std::ceil(*high / axis.step - slack) * axis.step);
    } else {
        axis.first = std::floor(std::log10(*low));
        axis.last = std::max(axis.first + 1, std::ceil(std::log10(*high)));
    }
    return axis;
}

std::vector<std::pair<double, double>> drawable(const Series& series, const Plot& plot)
{
    std::vector<std::pair<double, double>> points;
    for (const auto& [x, y] : series.points)
        if (std::isfinite(x) && std::isfinite(y) && (plot.is_linear || x > 0))
            points.emplace_back(x, plot.is_linear ? y : std::max(y, plot.least_y));
    return points;
}

std::string marker(std::size_t kind, double x, double y)
{
    static constexpr std::array<const char*, 8> shapes = {
        "M-4.5 0A4.5 4.5 0 1 0 4.5 0A4.5 4.5 0 1 0 -4.5 0Z",           // disc
        "M-4 -4H4V4H-4Z",                                              // square
        "M0 -5.5L5 4H-5Z",                                             // triangle
        "M0 -5.8L5.2 0L0 5.8L-5.2 0Z",                                 // diamond
        "M0 5.5L5 -4H-5Z",                                             // triangle, down
        "M-5 -1.5H-1.5V-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5Z",          // plus
        "M-5 -3L-3 -5L0 -2L3 -5L5 -3L2 0L5 3L3 5L0 2L-3 5L-5 3L-2 0Z", // cross
        "M0 -6L1.6 -1.9L6 -1.7L2.6 1L3.7 5.3L0 2.9L-3.7 5.3L-2.6 1L-6 -1.7L-1.6 -1.9Z"}; // star
    return format("<path transform='translate(%.1f %.1f)' d='%s'/>\n", x, y, shapes[kind]);
}

// Colors for a light screen are attributes, which every viewer knows. A style for dark screens
// overrides them.
struct Tone {
    const char *name, *paint, *light, *dark;
};
constexpr Tone paper = {"paper", "fill", "#ffffff", "#16191d"};
constexpr Tone letters = {"letters", "fill", "#1f2328", "#dde1e6"};
constexpr Tone faint = {"faint", "stroke", "#e3e6ea", "#30363d"};
constexpr Tone frame = {"frame", "stroke", "#57606a", "#8b949e"};

std::string painted(const Tone& tone)
{
    return format("class='%s' %s='%s'", tone.name, tone.paint, tone.light);
}

std::string dark_screen()
{
    std::string css = "<style>@media(prefers-color-scheme:dark){";
    for (const Tone& tone : {paper, letters, faint, frame})
        css += format(".%s{%s:%s}", tone.name, tone.paint, tone.dark);
    for (std::size_t i = 0; i < inks.size(); ++i)
        css += format(".line%zu{stroke:%s}.marks%zu{fill:%s;stroke:%s}", i, inks[i].dark, i,
                      inks[i].dark, inks[i].dark);
    return css + "}</style>\n";
}

std::string line_style(const Series& series, std::size_t kind)
{
    return format("class='line%zu' fill='none' stroke-width='1.8' stroke='%s'%s", kind,
                  inks[kind].light, series.dashed ? " stroke-dasharray='6 4'" : "");
}

std::string marks(std::size_t kind, const std::string& markers)
{
    return format("<g class='marks%zu' fill='%s' stroke='%s' fill-opacity='0.3'>\n", kind,
                  inks[kind].light, inks[kind].light) +
           markers + "</g>\n"; // transparent, so that curves that coincide both show
}

std::string grid(const Axis& x, const Axis& y)
{
    std::string lines, texts;
    for (int i = 0; i <= x.lines(); ++i) {
        lines += format("M%.1f %.1fV%.1f", x.line(i), top, bottom);
        if (x.has_label(i))
            texts += text_at(x.line(i), bottom + 20, "text-anchor='middle'", x.label(i));
    }
    for (int i = 0; i <= y.lines(); ++i) {
        lines += format("M%.1f %.1fH%.1f", left, y.line(i), right);
        if (y.has_label(i))
            texts += text_at(left - 8, y.line(i) + 4.5, "text-anchor='end'", y.label(i));
    }
    return "<path fill='none' " + painted(faint) + " d='" + lines + "'/>\n<path fill='none' " +
           painted(frame) + format(" d='M%.1f %.1fV%.1fH%.1f'/>\n", left, top, bottom, right) +
           texts;
}

std::string curve(const Series& series, std::size_t kind, const Axis& x, const Axis& y,
                  const Plot& plot)
{
    std::string line, markers;
    for (const auto& [px, py] : drawable(series, plot)) {
        line += format("%s%.1f %.1f", line.empty() ? "M" : "L", x.at(px), y.at(py));
        if (!plot.is_linear) markers += marker(kind, x.at(px), y.at(py));
    }
    if (line.empty()) return {};
    return "<path " + line_style(series, kind) + " d='" + line + "'/>\n" + marks(kind, markers);
}

std::string legend_entry(const Series& series, std::size_t kind, double y, bool has_marker)
{
    return "<path " + line_style(series, kind) + format(" d='M%.1f %.1fh34'/>\n", right + 24, y) +
           (has_marker ? marks(kind, marker(kind, right + 41, y)) : "") +
           text_at(right + 68, y + 4.5, "", escaped(series.name));
}

} // namespace

std::string svg_of(const Plot& plot)
{
    std::vector<double> xs, ys;
    for (const Series& series : plot.series)
        for (const auto& [x, y] : drawable(series, plot)) {
            xs.push_back(x);
            ys.push_back(y);
        }
    const Axis x = axis_about(xs, left, right, plot.is_linear),
               y = axis_about(ys, bottom, top, plot.is_linear);

    std::string svg =
        format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f' width='%.0f' "
               "height='%.0f'>\n",
               width, height, width, height) +
        dark_screen() + "<rect width='100%' height='100%' rx='6' " + painted(paper) +
        "/>\n<g font-family='DejaVu Sans,Verdana,sans-serif' font-size='13' " + painted(letters) +
        ">\n" + text_at(left, 30, "font-size='15' font-weight='bold'", escaped(plot.title)) +
        grid(x, y) +
        text_at((left + right) / 2, height - 20, "text-anchor='middle'", escaped(plot.x_label)) +
        text_at(0, 0,
                format("text-anchor='middle' transform='translate(24 %.0f) rotate(-90)'",
                       (top + bottom) / 2),
                escaped(plot.y_label));
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        svg += curve(plot.series[i], i % inks.size(), x, y, plot);
        svg += legend_entry(plot.series[i], i % inks.size(), top + 14 + 24 * static_cast<double>(i),
                            !plot.is_linear);
    }
    return svg + "</g>\n</svg>\n";
}

void write_plot(const Plot& plot, const std::string& file)
{
    std::ofstream stream(file, std::ios::binary);
    stream << svg_of(plot);
    stream.close();
    if (!stream) throw std::runtime_error(file + ": cannot be written");
}

std::string plot_folder(int argc, char** argv)
{
    const auto option = std::find_if(argv + 1, argv + argc,
                                     [](const char* a) { return std::string_view(a) == "--out"; });
    if (option == argv + argc) return {};
    if (option + 1 == argv + argc) throw std::runtime_error("--out: expected a folder, found none");
    std::error_code error;
    std::filesystem::create_directories(option[1], error);
    if (!std::filesystem::is_directory(option[1]))
        throw std::runtime_error(std::string("--out: expected a folder, found ") + option[1]);
    return option[1];
}

} // namespace rigor
