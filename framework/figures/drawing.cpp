// SPDX-License-Identifier: MIT
// Writes SVG elements one after the other. Colors are classes, so that the style sheet can have
// other colors for a dark background. Coordinates are written with two digits after the point.
#include "figures/drawing.hpp"

#include "errors/markup.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <regex>

namespace rigor::figures {

namespace {

// A text has a rim in the color of the paper, so that no line runs through it.
constexpr std::string_view style_sheet = R"(
.paper { fill: #ffffff; stroke: none }
text { font: 15px sans-serif; fill: #1f2328; paint-order: stroke; stroke: #ffffff !important }
text { stroke-width: 4; stroke-dasharray: none }
.thin { stroke-width: 1 } .thick { stroke-width: 3.5 } .dashed { stroke-dasharray: 6 5 }
.ink { stroke: #1f2328 } .grey { stroke: #8c959f } .blue { stroke: #0969da }
.orange { stroke: #bc4c00 } .green { stroke: #1a7f37 } .red { stroke: #cf222e }
text.grey { fill: #656d76 } text.blue { fill: #0969da } text.orange { fill: #bc4c00 }
text.green { fill: #1a7f37 } text.red { fill: #cf222e }
.filled { fill-opacity: 0.18 } .solid { fill-opacity: 1 }
.filled.ink, .solid.ink { fill: #1f2328 } .filled.grey, .solid.grey { fill: #8c959f }
.filled.blue, .solid.blue { fill: #0969da } .filled.orange, .solid.orange { fill: #bc4c00 }
.filled.green, .solid.green { fill: #1a7f37 } .filled.red, .solid.red { fill: #cf222e }
@media (prefers-color-scheme: dark) {
.paper { fill: #0d1117 } text { fill: #e6edf3; stroke: #0d1117 !important }
.ink { stroke: #e6edf3 } .blue { stroke: #58a6ff } .orange { stroke: #f0883e }
.green { stroke: #56d364 } .red { stroke: #ff7b72 }
text.grey { fill: #8c959f } text.blue { fill: #58a6ff } text.orange { fill: #f0883e }
text.green { fill: #56d364 } text.red { fill: #ff7b72 }
.filled.ink, .solid.ink { fill: #e6edf3 } .filled.blue, .solid.blue { fill: #58a6ff }
.filled.orange, .solid.orange { fill: #f0883e } .filled.green, .solid.green { fill: #56d364 }
.filled.red, .solid.red { fill: #ff7b72 }
}
)";

constexpr double head_length = 11, head_width = 4.5; // an arrow's head [px]

// The text as markup: "x_{r}" becomes an x with the subscript r, and a "-" that begins a number, as
// in "-3" but not in "1e-3", becomes a minus sign.
std::string markup(const std::string& text)
{
    static const std::regex minus(R"((^|[ (])-(\d))"), subscript(R"(_\{([^}]*)\}([^_]*))");
    return std::regex_replace(
        std::regex_replace(escaped_markup(text), minus, "$1−$2"), subscript,
        "<tspan dy=\"4\" font-size=\"11\">$1</tspan><tspan dy=\"-4\">$2</tspan>");
}

// A number with two digits after the point. Rounding must not give "-0.00".
std::string number(double value)
{
    const double rounded = std::round(value * 100) / 100;
    return fmt::format("{:.2f}", rounded == 0 ? 0.0 : rounded);
}

} // namespace

Drawing::Drawing(std::string title, double width, double height)
    : title_(std::move(title)), width_(width), height_(height)
{
}

void Drawing::place(const Vector2d& origin, double unit)
{
    origin_ = origin;
    unit_ = unit;
}

Vector2d Drawing::px(const Vector2d& point) const
{
    return {origin_.x() + unit_ * point.x(), origin_.y() - unit_ * point.y()};
}

std::string Drawing::path(const Points& points) const
{
    std::string text;
    for (const Vector2d& point : points) {
        const Vector2d p = px(point);
        text += (text.empty() ? "M" : " L") + number(p.x()) + " " + number(p.y());
    }
    return text;
}

void Drawing::line(const Vector2d& a, const Vector2d& b, std::string_view style)
{
    curve({a, b}, style);
}

void Drawing::arrow(const Vector2d& a, const Vector2d& b, std::string_view style)
{
    const Vector2d tip = px(b), along = tip - px(a);
    if (along.norm() < 1) return;
    const double length = std::min(head_length, along.norm());
    const Vector2d back = along.normalized() * length;
    const Vector2d aside = Vector2d(-back.y(), back.x()).normalized() * head_width;
    const Vector2d neck = tip - back, left = neck + aside, right = neck - aside, from = px(a);
    content_ += fmt::format("<path class=\"{}\" d=\"M{} {} L{} {}\"/>\n", style, number(from.x()),
                            number(from.y()), number(neck.x()), number(neck.y()));
    const std::string_view color = style.substr(0, style.find(' '));
    content_ += fmt::format("<path class=\"{} solid thin\" d=\"M{} {} L{} {} L{} {} Z\"/>\n", color,
                            number(tip.x()), number(tip.y()), number(left.x()), number(left.y()),
                            number(right.x()), number(right.y()));
}

void Drawing::curve(const Points& points, std::string_view style)
{
    content_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, path(points));
}

void Drawing::polygon(const Points& points, std::string_view style)
{
    content_ += fmt::format("<path class=\"{}\" d=\"{} Z\"/>\n", style, path(points));
}

void Drawing::circle(const Vector2d& center, double radius, std::string_view style)
{
    const Vector2d c = px(center);
    content_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", style,
                            number(c.x()), number(c.y()), number(radius * unit_));
}

void Drawing::dot(const Vector2d& point, std::string_view style)
{
    const Vector2d c = px(point);
    content_ += fmt::format("<circle class=\"{} solid thin\" cx=\"{}\" cy=\"{}\" r=\"4\"/>\n",
                            style, number(c.x()), number(c.y()));
}

void Drawing::label(const Vector2d& point, const std::string& text, Side side,
                    std::string_view style)
{
    Vector2d at = px(point);
    std::string_view anchor = "middle";
    constexpr double gap = 8, line = 15; // [px]
    at.y() += line / 3;
    if (side == Side::left) at.x() -= gap, anchor = "end";
    if (side == Side::right) at.x() += gap, anchor = "start";
    if (side == Side::above) at.y() -= line / 3 + gap;
    if (side == Side::below) at.y() += line * 2 / 3 + gap / 2;
    labels_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n",
                           style, number(at.x()), number(at.y()), anchor, markup(text));
}

Points Drawing::sampled(double from, double to, int steps, const std::function<Vector2d(double)>& f)
{
    Points points;
    for (int i = 0; i <= steps; ++i)
        points.push_back(f(from + (to - from) * i / steps));
    return points;
}

std::string Drawing::svg() const
{
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
                       "width=\"{0}\" height=\"{1}\" role=\"img\" fill=\"none\" "
                       "stroke-width=\"2\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n"
                       "<title>{2}</title>\n<style>{3}</style>\n"
                       "<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n{4}{5}</svg>\n",
                       width_, height_, escaped_markup(title_), style_sheet, content_, labels_);
}

View::View(double turn, double tilt)
{
    const double a = turn * std::numbers::pi / 180, b = tilt * std::numbers::pi / 180;
    const Vector3d ahead(-std::sin(a) * std::cos(b), -std::sin(b), -std::cos(a) * std::cos(b));
    right_ = Vector3d(std::cos(a), 0, -std::sin(a));
    up_ = right_.cross(ahead);
}

} // namespace rigor::figures
