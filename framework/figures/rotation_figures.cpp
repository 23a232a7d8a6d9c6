// SPDX-License-Identifier: MIT
// The figures of assignment A3, about rotation: the naive step of a matrix, the linear step of a
// quaternion on its circle, Euler angles on the way to gimbal lock, and a top whose inertia does
// not turn with it.
#include "figures/rotation_figures.hpp"

#include "formulas/inertia.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/rotation.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rigor::figures {

namespace {

constexpr double pi = std::numbers::pi;

Points arc(double from, double to, double radius = 1)
{
    return Drawing::sampled(from, to, 72, [&](double t) {
        return Vector2d(radius * std::cos(t), radius * std::sin(t));
    });
}

Drawing drift()
{
    Drawing drawing("A column of R moves along the tangent of its sphere and grows; Gram–Schmidt "
                    "shortens it again but does not turn it.",
                    660, 360);
    const Vector3d w(0, 0, 1);
    const double h = 0.5;
    drawing.place({120, 320}, 200);
    drawing.curve(arc(-0.1, pi / 2 + 0.1), "grey");
    drawing.label({1, 0}, "start: a column of R, length 1", Side::below, "grey");
    Matrix3d drifting = Matrix3d::Identity(), repaired = drifting;
    for (int i = 0; i < 3; ++i) {
        const Matrix3d next = advance_matrix(drifting, w, h);
        drawing.arrow(drifting.col(0).head<2>(), next.col(0).head<2>(), "red");
        drifting = next;
        repaired = gram_schmidt(advance_matrix(repaired, w, h));
        drawing.line({0, 0}, repaired.col(0).head<2>(), "blue thin");
        drawing.dot(repaired.col(0).head<2>(), "blue");
        const Vector2d exact(std::cos((i + 1) * h), std::sin((i + 1) * h));
        drawing.dot(exact, "green");
    }
    drawing.label(drifting.col(0).head<2>(), "without repair", Side::left, "red");
    drawing.place({0, 0}, 1);
    drawing.label({375, -110}, "by Gram–Schmidt: unit, but behind", Side::right, "blue");
    drawing.label({375, -140}, "exact", Side::right, "green");
    return drawing;
}

Drawing quaternion_path()
{
    Drawing drawing(
        "Quaternions (s, z) of rotations about z: the exact step follows the circle, the "
        "linear step goes along the tangent and is pulled back.",
        660, 360);
    const Vector3d w(0, 0, 1);
    const double h = 1.2;
    const auto at = [](const Quaternion& q) { return Vector2d(q.s, q.v.z()); };
    drawing.place({150, 310}, 220);
    drawing.curve(arc(-0.1, pi / 2 + 0.15), "grey");
    drawing.arrow({0, 0}, {1.35, 0}, "ink thin");
    drawing.label({1.35, 0}, "s", Side::right);
    drawing.arrow({0, 0}, {0, 1.25}, "ink thin");
    drawing.label({0, 1.25}, "z", Side::left);
    Quaternion exact, linear;
    for (int i = 0; i < 2; ++i) {
        const Quaternion rate = quaternion_rate(linear, w);
        const Quaternion tip = {linear.s + h * rate.s, linear.v + h * rate.v};
        drawing.arrow(at(linear), at(tip), "orange");
        linear = advance_linear(linear, w, h);
        drawing.line(at(tip), at(linear), "orange dashed");
        drawing.dot(at(linear), "orange");
        exact = advance_exact(exact, w, h);
        drawing.line({0, 0}, at(exact), "blue thin");
        drawing.dot(at(exact), "blue");
    }
    drawing.dot({1, 0}, "ink");
    drawing.label({1, 0}, "q₀", Side::below);
    drawing.place({0, 0}, 1);
    drawing.label({430, -80}, "exact: half of |ω| Δt = 1.2", Side::right, "blue");
    std::string text = fmt::format("linear: arctan 0.6 = {:.4f}", std::atan(0.6));
    drawing.label({430, -110}, text, Side::right, "orange");
    return drawing;
}

void draw_axes(Drawing& drawing, double pitch, const std::string& text)
{
    const View view(35, 25);
    // y points up in a view; the axes of the handout have z up
    const auto at = [&](const Vector3d& a) { return view(Vector3d(a.y(), a.z(), a.x())); };
    const Matrix3d R_y = euler_to_matrix({0, pitch, 0});
    const Vector3d roll = R_y.col(0), pitch_axis = Vector3d::UnitY(), yaw = Vector3d::UnitZ();
    drawing.arrow({0, 0}, at(yaw), "blue thick");
    drawing.label(at(yaw), "yaw", Side::above, "blue");
    drawing.arrow({0, 0}, at(pitch_axis), "green thick");
    drawing.label(at(pitch_axis), "pitch", Side::right, "green");
    drawing.arrow({0, 0}, at(roll), "orange thick");
    drawing.label(at(roll), "roll", Side::below, "orange");
    const auto rates = euler_rates({0, pitch, 0}, Vector3d(1, 0, 0));
    const std::string rate = rates ? fmt::format("yaw rate {:.2f}", rates->z()) : "no rates";
    drawing.label({0, -1.35}, text, Side::below);
    drawing.label({0, -1.6}, rate, Side::below, "grey");
}

Drawing gimbal_lock()
{
    Drawing drawing("The axes of roll, pitch and yaw: at a pitch of 90° roll and yaw lie on one "
                    "line, and no rates make ω = (1, 0, 0).",
                    660, 330);
    const double angles[] = {0, 60, 90};
    for (int i = 0; i < 3; ++i) {
        drawing.place({105 + 213.0 * i, 130}, 80);
        std::string text = fmt::format("pitch {:.0f}°", angles[i]);
        draw_axes(drawing, angles[i] * pi / 180, text);
    }
    drawing.place({330, 300}, 1);
    drawing.label({0, 0}, "rates for ω = (1, 0, 0); z points up here", Side::below, "grey");
    return drawing;
}

// The principal moments [kg m²] and the initial ω [rad/s] of the top in the scene symmetric_top.
const Vector3d top_moments(0.04, 0.04, 0.02), top_spin(2, 4, 6);

// The path of the top's axis in 1.1 s, where ω is I(t)⁻¹ L. inertia_turns: whether I(t) turns with
// the top; otherwise it stays as it is at the start.
Points path_of_the_axis(const View& view, bool inertia_turns)
{
    const Matrix3d I_body_inverse = top_moments.cwiseInverse().asDiagonal();
    const Vector3d L = top_moments.cwiseProduct(top_spin);
    const double h = 0.005;
    const int steps = 220;
    Quaternion q;
    Points path;
    for (int i = 0; i <= steps; ++i) {
        const Matrix3d R = to_matrix(q);
        path.push_back(view(R.col(2)));
        const Matrix3d I_inverse =
            inertia_turns ? world_inverse_inertia(R, I_body_inverse) : I_body_inverse;
        q = advance_exact(q, I_inverse * L, h);
    }
    return path;
}

Drawing wrong_inertia()
{
    Drawing drawing(
        "The path of the axis of a free top: around L if the inertia turns with the top, "
        "and around an ω that stands still if it does not.",
        660, 380);
    const View view(35, 25);
    drawing.place({230, 215}, 150);
    drawing.circle({0, 0}, 1, "grey thin");
    const Vector3d L = top_moments.cwiseProduct(top_spin).normalized() * 1.25;
    const Vector3d w = top_spin.normalized() * 1.25;
    drawing.curve(path_of_the_axis(view, true), "blue thick");
    drawing.curve(path_of_the_axis(view, false), "red dashed");
    drawing.arrow({0, 0}, view(L), "blue");
    drawing.label(view(L), "L", Side::above, "blue");
    drawing.arrow({0, 0}, view(w), "red dashed");
    drawing.label(view(w), "ω", Side::left, "red");
    drawing.dot(view({0, 0, 1}), "ink");
    drawing.label(view({0, 0, 1}), "start", Side::below);
    drawing.place({425, 150}, 1);
    drawing.label({0, 0}, "I(t) turns with the top", Side::right, "blue");
    drawing.label({0, -30}, "I_{body} in place of I(t)", Side::right, "red");
    return drawing;
}

} // namespace

std::span<const Figure> rotation_figures()
{
    static constexpr Figure all[] = {{"a3-rotation", "drift", drift},
                                     {"a3-rotation", "quaternion_path", quaternion_path},
                                     {"a3-rotation", "gimbal_lock", gimbal_lock},
                                     {"a3-rotation", "wrong_inertia", wrong_inertia}};
    return all;
}

} // namespace rigor::figures
