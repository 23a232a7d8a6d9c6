// SPDX-License-Identifier: MIT
#include "framework/rigid/worlds.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/detection/broad_phase.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

namespace {

struct Crowd {
    World world;
    std::vector<Pose> poses;
    std::vector<Bounds> bounds;
};

Crowd crowd(unsigned seed, int bodies, double spread)
{
    Random random(seed);
    Crowd crowd;
    for (int i = 0; i < bodies; ++i) {
        const Vector3d X = spread * random.vector();
        const double size = random.uniform(0.1, 1);
        const Quaternion q = random.quaternion();
        RigidBody body = i % 7 == 3 ? fixed(Box{{size, 1, 1}}, {}, X, q)
                         : i % 2    ? body_of(Sphere{size}, X, {}, q)
                                    : body_of(Box{{size, 1, 0.5}}, X, {}, q);
        if (i % 31 == 5) body = fixed(Plane{}, {}, X, q);
        crowd.poses.push_back({rotation_matrix(q), X});
        crowd.bounds.push_back(bounds_of(body.parts[0].shape, crowd.poses.back()));
        crowd.world.bodies.push_back(std::move(body));
    }
    return crowd;
}

// Whether a half-space meets a box, tested at the deepest corner of the box.
bool meets_plane(const Pose& plane, const Bounds& b)
{
    for (int i = 0; i < 8; ++i) {
        const Vector3d corner(i & 1 ? b.high.x() : b.low.x(), i & 2 ? b.high.y() : b.low.y(),
                              i & 4 ? b.high.z() : b.low.z());
        if ((plane.R.transpose() * (corner - plane.X)).y() <= 1e-12) return true;
    }
    return false;
}

} // namespace

TEST_CASE("broad phase: it finds what comparing all pairs finds", "[rigid]")
{
    for (unsigned seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        const Crowd c = crowd(seed, 80, seed % 3 == 0 ? 2 : 6);
        std::vector<BodyPair> expected;
        const int n = static_cast<int>(c.world.bodies.size());
        for (int i = 0; i < n; ++i)
            for (int j = i + 1; j < n; ++j) {
                const RigidBody &a = c.world.bodies[i], &b = c.world.bodies[j];
                if (a.is_static && b.is_static) continue;
                const bool near = is_plane(a.parts[0])   ? meets_plane(c.poses[i], c.bounds[j])
                                  : is_plane(b.parts[0]) ? meets_plane(c.poses[j], c.bounds[i])
                                                         : c.bounds[i].overlaps(c.bounds[j]);
                if (near) expected.push_back({i, j});
            }
        ThreadPool alone;
        const std::vector<BodyPair> found = near_pairs(c.world, c.poses, c.bounds, alone);
        REQUIRE(found.size() > 10);
        REQUIRE(found == expected);
    }
}

// The number of pairs of which not both are static.
static std::uint64_t pairs_possible(const World& world)
{
    const auto n = static_cast<std::uint64_t>(world.bodies.size());
    const auto fixed = static_cast<std::uint64_t>(std::count_if(
        world.bodies.begin(), world.bodies.end(), [](const RigidBody& b) { return b.is_static; }));
    return n * (n - 1) / 2 - fixed * (fixed - 1) / 2;
}

TEST_CASE("broad phase: pairs that could meet are counted without those of static bodies",
          "[rigid]")
{
    Crowd c = crowd(1, 80, 6);
    ThreadPool alone;
    const std::vector<double> margins(c.bounds.size(), 0.1);
    const auto found = cached_near_pairs(c.world, c.poses, c.bounds, margins, alone);
    const Counters& counters = c.world.counters;
    CHECK(counters.pairs_possible == pairs_possible(c.world));
    CHECK(found.size() < counters.pairs_possible / 4);
}

TEST_CASE("broad phase: what is remembered finds the same pairs while bodies move, stop and start",
          "[rigid]")
{
    Random random(5);
    Crowd c = crowd(2, 80, 3);
    const Counters& counters = c.world.counters;
    ThreadPool alone;
    const std::vector<double> margins(c.bounds.size(), 0.1);
    for (int k = 0; k < 300; ++k) {
        for (std::size_t i = 0; i < c.bounds.size(); ++i) {
            RigidBody& body = c.world.bodies[i];
            if (random.uniform(0, 1) > 0.999 && !body.is_static)
                body.rest.group = body.rest.is_asleep() ? -1 : 0;
            if (body.is_still() || is_plane(body.parts[0])) continue;
            const Vector3d way = 0.03 * random.vector();
            c.poses[i].X += way;
            c.bounds[i].low += way;
            c.bounds[i].high += way;
        }
        const auto found = cached_near_pairs(c.world, c.poses, c.bounds, margins, alone);
        REQUIRE(found == near_pairs(c.world, c.poses, c.bounds, alone));
    }
    CHECK(counters.pairs_possible == 300 * pairs_possible(c.world));
    CHECK(counters.pair_searches_saved > 100);
    CHECK(counters.pair_searches_saved < 290);
}

TEST_CASE("broad phase: the world without bodies has no pairs", "[rigid]")
{
    World world;
    ThreadPool alone;
    CHECK(cached_near_pairs(world, {}, {}, {}, alone).empty());
    CHECK(world.counters.pairs_possible == 0);
}
