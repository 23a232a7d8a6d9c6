// SPDX-License-Identifier: MIT
// Balls of one radius on a line, perhaps above a wall, moved exactly from one impact to the next by
// the laws of Huygens (1703, "De motu corporum ex percussione") and Newton's restitution.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rigor::testing {

struct OnLine {
    double x = 0, v = 0, mass = 0;
};

struct BallsOnALine {
    std::vector<OnLine> balls; // from left to right
    double radius = 0.1, restitution = 1;
    bool has_wall = false; // at x = 0, left of all balls
    double gravity = 0;    // towards the wall [m/s²]

    // What happened so far: the number of impacts, the slowest of them, and the slowest bounce off
    // the wall [m/s].
    int impacts = 0;
    double slowest = std::numeric_limits<double>::infinity(), slowest_off_wall = slowest;

    /// Advances by the time T, or until there were `most` impacts.
    void advance(double T, int most = 1000)
    {
        while (T > 0 && impacts < most) {
            double next = T;
            int hit = none;
            const auto at = [&](double time, int which) {
                if (time >= next) return;
                next = std::max(time, 0.0);
                hit = which;
            };
            if (has_wall) at(time_to_wall(), wall);
            for (int i = 0; i + 1 < static_cast<int>(balls.size()); ++i) {
                const double closing = balls[i].v - balls[i + 1].v;
                const double apart = balls[i + 1].x - balls[i].x - 2 * radius;
                if (closing > 1e-12) at(apart / closing, i);
            }
            for (OnLine& ball : balls) {
                ball.x += ball.v * next - gravity * next * next / 2;
                ball.v -= gravity * next;
            }
            T -= next;
            if (hit != none) collide(hit);
        }
    }

private:
    static constexpr int wall = -1, none = -2;

    double time_to_wall() const
    {
        const double v = balls[0].v, d = balls[0].x - radius;
        if (gravity == 0) return v < 0 ? -d / v : std::numeric_limits<double>::infinity();
        if (d < 1e-13 && v >= 0) return 2 * v / gravity; // it has just bounced
        return (v + std::sqrt(std::max(0.0, v * v + 2 * gravity * d))) / gravity;
    }

    void collide(int i)
    {
        ++impacts;
        if (i == wall) {
            balls[0].v *= -restitution;
            slowest_off_wall = std::min(slowest_off_wall, balls[0].v);
            return;
        }
        OnLine &a = balls[i], &b = balls[i + 1];
        slowest = std::min(slowest, a.v - b.v);
        const double j = (1 + restitution) * (a.v - b.v) / (1 / a.mass + 1 / b.mass);
        a.v -= j / a.mass;
        b.v += j / b.mass;
    }
};

} // namespace rigor::testing
