// SPDX-License-Identifier: MIT
// A chain that hangs (Bernoulli, Huygens and Leibniz 1691): along it the horizontal pull H is the
// same, and the vertical one grows by the weight of each mass. A link under the tension T is
// l + T/k long.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a chain hangs at rest along its catenary", "[classics]")
{
    constexpr int N = 15;
    const double M = 12, k = 1e4, l = 0.1;
    for (const double H : {0.5 * M * g, 3 * M * g}) {
        CAPTURE(H);
        World world = solved(std::vector<RigidBody>(N, free_box()));
        std::vector<Vector3d> places = {Vector3d::Zero()};
        for (int j = 0; j <= N; ++j) {
            const Vector3d pull(H, (j - N / 2.) * M * g, 0);
            places.push_back(places.back() + (l / pull.norm() + 1 / k) * pull);
        }
        for (int j = 0; j <= N; ++j) {
            Spring link{j - 1, j < N ? j : -1, Vector3d::Zero(), Vector3d::Zero(), k, 0, l};
            if (j == N) link.point2 = places.back();
            link.only_pulls = true;
            world.springs.push_back(link);
        }
        for (int i = 0; i < N; ++i)
            world.bodies[i].state.position = places[i + 1];
        run(world, 200, 0.01);
        for (int i = 0; i < N; ++i)
            CHECK_THAT(world.bodies[i].state.position, IsClose(places[i + 1], Order(1e-10)));
        CHECK_THAT(places.back().y(), IsClose(0.0, Order(1e-12))); // the ends are level
    }
}
