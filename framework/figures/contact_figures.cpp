// SPDX-License-Identifier: MIT
// The figures of assignment A5, about contact: the velocities of the ends of a rod after some
// iterations, the levels of a contact graph, how three methods stop a stack, and the seesaw.
#include "figures/contact_figures.hpp"

#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace rigor::figures {

namespace {

Points rectangle(const Vector2d& center, const Vector2d& size)
{
    const Vector2d h = size / 2;
    return {center + Vector2d(-h.x(), -h.y()), center + Vector2d(h.x(), -h.y()),
            center + Vector2d(h.x(), h.y()), center + Vector2d(-h.x(), h.y())};
}

double speed_up(const Body& body, const Vector3d& x)
{
    return point_velocity(body.velocity, body.angular_velocity, body.position, x).y();
}

Drawing flat_rod()
{
    Drawing drawing("The velocities of the ends of a flat rod after one, two and ten iterations.",
                    660, 300);
    Body rod;
    rod.inverse_mass = 1;
    rod.inverse_inertia = Vector3d(3, 0, 3).asDiagonal();
    rod.velocity = Vector3d(0, -1, 0);
    std::vector<BodyContact> ends(2);
    ends[0].point = Vector3d(-1, 0, 0);
    ends[1].point = Vector3d(1, 0, 0);
    ends[0].body2 = ends[1].body2 = 1;
    const int iterations[] = {0, 1, 2, 10};
    for (int k = 0; k < 4; ++k) {
        const int n = iterations[k];
        const Body after = resolve_contacts({rod, Body()}, ends, n).bodies[0];
        drawing.place({82 + 166.0 * k, 110}, 48);
        drawing.polygon(rectangle({0, 0}, {2, 0.12}), "grey filled");
        for (const BodyContact& end : ends) {
            const double v = speed_up(after, end.point);
            const Vector2d at = end.point.head<2>();
            drawing.arrow(at, at + Vector2d(0, 1.2 * v), v < -1e-9 ? "red thick" : "green thick");
            std::string text = fmt::format("{:.4g}", std::abs(v) < 1e-12 ? 0.0 : v);
            drawing.label(at + Vector2d(0, 0.1), text, Side::above);
        }
        drawing.label({0, -2}, n == 0 ? "before" : "N = " + std::to_string(n), Side::below, "grey");
    }
    return drawing;
}

Drawing levels()
{
    Drawing drawing(
        "A pile, who rests on whom, and the levels: two cards that lean on each other share "
        "one.",
        660, 380);
    struct Item {
        Points shape;
        Vector2d center;
    };
    const auto box = [](double x, double y, double w, double h) {
        return Item{rectangle({x, y}, {w, h}), {x, y}};
    };
    const std::vector<Item> items = {
        box(3.3, -0.1, 7.4, 0.2), // the ground
        box(0.8, 0.5, 1, 1),
        box(2.2, 0.5, 1, 1),
        box(1.5, 1.2, 2.6, 0.4),
        box(1.5, 1.9, 1, 1),
        {{{4.3, 0}, {4.45, 0}, {5.0, 1.7}, {4.9, 1.75}}, {4.65, 0.85}},
        {{{5.7, 0}, {5.55, 0}, {4.95, 1.75}, {5.05, 1.78}}, {5.4, 0.85}},
        box(5.0, 1.95, 1.4, 0.3)};
    const std::vector<std::vector<int>> rests_on = {{},  {0},    {0},    {1, 2},
                                                    {3}, {0, 6}, {0, 5}, {5, 6}};
    std::vector<bool> is_static(items.size(), false);
    is_static[0] = true;
    const std::vector<int> levels = contact_levels(rests_on, is_static);
    // An arrow to the ground ends below its body, or at the foot of a card that leans. The two
    // arrows between the cards lie one above the other.
    const auto arrow_of = [&](int i, int below) -> std::pair<Vector2d, Vector2d> {
        const Vector2d from = items[i].center, to = items[below].center;
        const double foot = i == 5 ? 4.375 : i == 6 ? 5.625 : from.x() + 0.12;
        if (below == 0) return {{i > 4 ? from.x() : foot, from.y()}, {foot, 0}};
        const Vector2d aside =
            i > 4 && i < 7 ? Vector2d(0, i == 5 ? 0.2 : -0.2) : Vector2d(0.12, 0);
        return {from + aside, from + 0.8 * (to - from) + aside};
    };
    drawing.place({60, 320}, 78);
    const char* colors[] = {"grey", "blue", "green", "orange"};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string color = colors[std::min(levels[i], 3)];
        drawing.polygon(items[i].shape, color + " filled");
    }
    for (std::size_t i = 0; i < items.size(); ++i)
        for (const int below : rests_on[i]) {
            const auto [from, to] = arrow_of(static_cast<int>(i), below);
            drawing.arrow(from, to, "ink thin");
        }
    for (std::size_t i = 0; i < items.size(); ++i)
        drawing.label(items[i].center - Vector2d(i == 0   ? 3.2
                                                 : i == 6 ? -0.35
                                                 : i == 5 ? 0.3
                                                          : 0.12,
                                                 0),
                      std::to_string(levels[i]),
                      i == 0   ? Side::middle
                      : i == 6 ? Side::right
                               : Side::left);
    return drawing;
}

// A stack of blocks of 1 kg without rotation. Each block falls at 1 m/s.
struct Stack {
    std::vector<Body> bodies;
    std::vector<BodyContact> contacts;
    std::vector<int> levels;
};

Stack stack(int height)
{
    Stack made;
    made.bodies.push_back(Body());
    made.levels.push_back(0);
    for (int i = 0; i < height; ++i) {
        Body block;
        block.inverse_mass = 1;
        block.position = Vector3d(0, i + 0.5, 0);
        block.velocity = Vector3d(0, -1, 0);
        made.bodies.push_back(block);
        made.levels.push_back(i + 1);
        BodyContact contact;
        contact.body1 = i + 1;
        contact.body2 = i;
        contact.point = Vector3d(0, i, 0);
        contact.depth = 1e-3 * (height - i);
        made.contacts.push_back(contact);
    }
    return made;
}

double fastest_approach(const Stack& stack, const std::vector<Body>& bodies)
{
    double fastest = 0;
    for (const BodyContact& c : stack.contacts)
        fastest = std::max(fastest, bodies[c.body2].velocity.y() - bodies[c.body1].velocity.y());
    return fastest;
}

Drawing sweeps()
{
    Drawing drawing(
        "What is left of the approach in a stack of ten: one point at a time, all at once, "
        "and level by level.",
        660, 380);
    const Stack ten = stack(10);
    drawing.place({90, 75}, 1);
    // The scale is logarithmic down to 1e-3. Smaller values are drawn as 0, below a break of the
    // axis.
    const double least = 1e-3;
    const auto at = [&](double n, double v) {
        return Vector2d(n * 2.6, v < least ? -245 : std::log10(v) * 65);
    };
    drawing.label(at(0, 1) + Vector2d(-40, 18), "fastest approach [m/s]", Side::right);
    drawing.line(at(0, 1), at(0, least), "ink thin");
    for (const double gap : {0.0, 8.0}) // two short lines: the break of the axis
        drawing.line(at(0, least) + Vector2d(-7, -24 - gap), at(0, least) + Vector2d(7, -18 - gap),
                     "ink thin");
    for (const double v : {1.0, 1e-1, 1e-2, 1e-3, 0.0}) {
        drawing.line(at(0, v), at(200, v), "grey thin");
        drawing.label(at(0, v), fmt::format("{:g}", v), Side::left, "grey");
    }
    for (const int n : {50, 100, 150, 200})
        drawing.label(at(n, 0), std::to_string(n), Side::below, "grey");
    Points one, all, shock;
    for (int n = 1; n <= 200; n += n < 20 ? 1 : 5) {
        one.push_back(
            at(n, fastest_approach(ten, resolve_contacts(ten.bodies, ten.contacts, n).bodies)));
        all.push_back(at(
            n, fastest_approach(ten, resolve_simultaneously(ten.bodies, ten.contacts, n).bodies)));
        shock.push_back(
            at(n, fastest_approach(
                      ten, shock_propagation(ten.bodies, ten.contacts, ten.levels, n).bodies)));
    }
    drawing.curve(one, "red");
    drawing.curve(all, "blue");
    drawing.curve(shock, "green thick");
    drawing.label(at(60, 0.42), "resolve_contacts", Side::right, "red");
    drawing.label(at(38, 0.012), "resolve_simultaneously", Side::right, "blue");
    drawing.label(at(20, 0) + Vector2d(0, 16), "shock_propagation", Side::right, "green");
    drawing.label(at(100, 0) - Vector2d(0, 22), "iterations or sweeps", Side::below, "grey");
    return drawing;
}

Drawing seesaw()
{
    Drawing drawing("A seesaw: the weights of two blocks have different arms about the edge of the "
                    "ridge, and what lies farther out is harder to turn.",
                    660, 300);
    drawing.place({330, 180}, 105);
    drawing.polygon({{-0.5, -0.55}, {0.5, -0.55}, {0.15, 0}, {-0.15, 0}}, "grey filled");
    drawing.polygon(rectangle({0, 0.08}, {4.4, 0.16}), "grey filled");
    drawing.polygon(rectangle({-1.7, 0.56}, {0.8, 0.8}), "blue filled");
    drawing.polygon(rectangle({1.85, 0.36}, {0.4, 0.4}), "orange filled");
    const Vector3d pivot(-0.15, 0, 0);
    drawing.dot(pivot.head<2>(), "ink");
    drawing.label(pivot.head<2>() - Vector2d(0, 0.05), "x_{r}", Side::below);
    const Vector3d big(-1.7, 0.56, 0), small(1.85, 0.36, 0);
    const std::vector<PointForce> weights = {{Vector3d(0, -1.1, 0), big},
                                             {Vector3d(0, -0.28, 0), small}};
    drawing.arrow(big.head<2>(), (big + weights[0].force).head<2>(), "blue thick");
    drawing.arrow(small.head<2>(), (small + weights[1].force * 1.8).head<2>(), "orange thick");
    drawing.label(big.head<2>() + Vector2d(0, 0.4), "m₁ g", Side::above, "blue");
    drawing.label(small.head<2>() + Vector2d(0, 0.2), "m₂ g", Side::above, "orange");
    drawing.line(pivot.head<2>(), big.head<2>(), "ink dashed");
    drawing.label((pivot + big).head<2>() / 2, "r₁", Side::above);
    drawing.line({big.x(), -0.75}, {pivot.x(), -0.75}, "blue");
    drawing.label({(big.x() + pivot.x()) / 2, -0.75}, "arm x_{r} − x₁", Side::below, "blue");
    const double turning = net_wrench(weights, pivot).torque.z();
    drawing.label({0.9, 1.2}, turning > 0 ? "turns to the left" : "turns to the right",
                  Side::above);
    return drawing;
}

} // namespace

std::span<const Figure> contact_figures()
{
    static constexpr Figure all[] = {{"a5-contact", "flat_rod", flat_rod},
                                     {"a5-contact", "levels", levels},
                                     {"a5-contact", "seesaw", seesaw},
                                     {"a5-contact", "sweeps", sweeps}};
    return all;
}

} // namespace rigor::figures
