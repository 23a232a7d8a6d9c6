// SPDX-License-Identifier: MIT
// A drawing in the plane, as SVG that can be read on a light and on a dark background.
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::figures {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Points = std::vector<Vector2d>;

/// Where the text of a label lies beside its point.
enum class Side { left, right, above, below, middle };

/// A drawing. Each thing in it has a style: a color ("ink", "grey", "blue", "orange", "green",
/// "red"), to which "dashed", "thick", "thin" or "filled" can be added.
class Drawing {
public:
    /// @param title  one sentence, which screen readers read
    /// @param width, height  [px]
    Drawing(std::string title, double width, double height);

    /// Sets where the following things are drawn: the origin at `origin`, in px from the upper left
    /// corner, and `unit` px for a unit of length. The second coordinate points up.
    void place(const Vector2d& origin, double unit);

    void line(const Vector2d& a, const Vector2d& b, std::string_view style);
    void arrow(const Vector2d& a, const Vector2d& b, std::string_view style);
    void curve(const Points& points, std::string_view style);
    void polygon(const Points& points, std::string_view style);
    void circle(const Vector2d& center, double radius, std::string_view style);
    void dot(const Vector2d& point, std::string_view style);
    /// A part "_{…}" of the text is written as a subscript, and a "-" that begins a number as a
    /// minus sign.
    void label(const Vector2d& point, const std::string& text, Side side = Side::right,
               std::string_view style = "ink");

    /// The points f(t) for t from `from` to `to`.
    static Points sampled(double from, double to, int steps,
                          const std::function<Vector2d(double)>& f);

    std::string svg() const;

private:
    Vector2d px(const Vector2d& point) const;
    std::string path(const Points& points) const;

    std::string title_, content_, labels_; // labels are drawn last
    double width_, height_, unit_ = 1;
    Vector2d origin_ = Vector2d::Zero();
};

/// A parallel projection of space onto the drawing, without perspective.
class View {
public:
    /// @param turn, tilt  azimuth and elevation of the eye [degrees]
    View(double turn, double tilt);
    Vector2d operator()(const Vector3d& x) const { return {right_.dot(x), up_.dot(x)}; }
    /// How far a point lies in front of the plane through the origin that is perpendicular to the
    /// line of sight.
    double nearness(const Vector3d& x) const { return right_.cross(up_).dot(x); }

private:
    Vector3d right_, up_;
};

} // namespace rigor::figures
