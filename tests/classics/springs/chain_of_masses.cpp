// SPDX-License-Identifier: MIT
// The modes of N equal masses on N + 1 equal springs between walls (Lagrange 1788, "Mécanique
// analytique"): ωₙ = 2 √(k/M) sin(n π/(2 (N + 1))), with the shape sin(n π i/(N + 1)). If the
// rest length of the springs is 0, this formula holds for vibrations along the chain and across it,
// with any amplitude.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: each mode of a chain keeps its shape and has its frequency", "[classics]")
{
    constexpr int N = 6;
    const double M = 12, k = 500, A = 0.3, T = 2;
    for (const int n : {1, 2, 5, 6}) {
        const double w = 2 * std::sqrt(k / M) * std::sin(n * pi / (2 * (N + 1)));
        std::vector<double> errors;
        for (const int steps : {60, 120, 240}) {
            World world = solved(std::vector<RigidBody>(N, free_box()), {0, 0, 0});
            const Vector3d end(N + 1, 0, 0);
            const auto shape = [&](int i, double time) -> Vector3d {
                const double s = A * std::sin(n * pi * i / (N + 1)) * std::cos(w * time);
                return Vector3d(i, 0, 0) + s * Vector3d(0.4, 0.5, -0.3);
            };
            for (int i = 0; i <= N; ++i)
                world.springs.push_back({i - 1, i < N ? i : -1, Vector3d::Zero(),
                                         i < N ? Vector3d(0, 0, 0) : end, k, 0, 0});
            for (int i = 1; i <= N; ++i)
                world.bodies[i - 1].state.position = shape(i, 0);
            run(world, steps, T / steps);
            double off = 0;
            for (int i = 1; i <= N; ++i)
                off = std::max(off, (world.bodies[i - 1].state.position - shape(i, T)).norm());
            errors.push_back(off);
        }
        CAPTURE(n, errors);
        check_order(errors, 4);
    }
}
