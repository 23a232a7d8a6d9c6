// SPDX-License-Identifier: MIT
// Laws that must hold for each pair of shapes.
#include "framework/rigid/contact_shapes.hpp"
#include "support/sweep.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("contact: seen from the other side every pair has the same touches", "[rigid]")
{
    for (const NamedShape& first : all_shapes())
        for (const NamedShape& second : all_shapes())
            for (unsigned seed = 0; seed < 4; ++seed) {
                CAPTURE(first.name, second.name, seed);
                Random random(seed);
                const Pose a{random.rotation(), 0.6 * random.vector()},
                    b{random.rotation(), 0.6 * random.vector()};
                const auto there = touches_of(first.shape, a, second.shape, b, 0.1),
                           back = touches_of(second.shape, b, first.shape, a, 0.1);
                REQUIRE(there.size() <= 9);
                for (const Contact& t : there) {
                    REQUIRE(t.point.allFinite());
                    REQUIRE_THAT(t.normal.norm(), IsClose(1.0, Rounding(16)));
                    REQUIRE(t.gap < 0.1);
                }
                const bool are_meshes = std::holds_alternative<Mesh>(first.shape) &&
                                        std::holds_alternative<Mesh>(second.shape);
                // For two meshes, or two shapes of one kind, it may matter which comes first.
                if (are_meshes || first.name == second.name) continue;
                REQUIRE(there.size() == back.size());
                for (std::size_t i = 0; i < there.size(); ++i) {
                    REQUIRE_THAT(back[i].gap, IsClose(there[i].gap, Rounding(64, 4)));
                    REQUIRE_THAT(back[i].normal, IsClose(Vector3d(-there[i].normal), Rounding(64)));
                }
            }
}

TEST_CASE("contact: shapes that approach touch where they meet", "[rigid]")
{
    // The second shape comes from outside along a random direction, and is placed where the fine
    // meshes of both shapes just touch. There the gap must be zero.
    Sweep sweep;
    for (const NamedShape& first : all_shapes())
        for (const NamedShape& second : all_shapes())
            for (unsigned seed = 0; seed < 3; ++seed) {
                if (!sweep.takes_next()) continue;
                CAPTURE(first.name, second.name, seed);
                Random random(seed);
                const Pose a{random.rotation(), {0, 0, 0}};
                Pose b{random.rotation(), {0, 0, 0}};
                const Vector3d away = random.unit_vector();
                b.X = meeting_distance(first.shape, a, second.shape, b.R, away) * away;
                const auto touches = touches_of(first.shape, a, second.shape, b, 0.1);
                REQUIRE(!touches.empty());
                const double tolerance = first.accuracy + second.accuracy;
                REQUIRE(std::abs(deepest(touches)) < tolerance);
            }
}

TEST_CASE("contact: the same shape as a mesh and exactly touches alike", "[rigid]")
{
    const std::vector<std::pair<Shape, Shape>> twins = {
        {Sphere{0.5}, mesh(icosphere(0.5, 5))},
        {Torus{0.4, 0.15}, mesh(torus_mesh(0.4, 0.15, 96, 48))},
        {Box{{0.7, 0.5, 0.9}}, mesh(box_mesh({0.7, 0.5, 0.9}))},
        {Cylinder{0.4, 0.8},
         mesh(surface_of_revolution({{0, -0.4}, {0.4, -0.4}, {0.4, 0.4}, {0, 0.4}}, 96))}};
    for (std::size_t k = 0; k < twins.size(); ++k)
        for (const NamedShape& other : all_shapes())
            for (unsigned seed = 0; seed < 4; ++seed) {
                CAPTURE(k, other.name, seed);
                Random random(seed);
                const Pose a{random.rotation(), {0, 0, 0}},
                    b{random.rotation(), 0.7 * random.unit_vector()};
                const auto exact = touches_of(twins[k].first, a, other.shape, b, 0.2);
                const auto by_mesh = touches_of(twins[k].second, a, other.shape, b, 0.2);
                if (exact.empty() || deepest(exact) < -0.05 || deepest(exact) > 0.19) continue;
                REQUIRE(!by_mesh.empty());
                REQUIRE(std::abs(deepest(by_mesh) - deepest(exact)) < 0.01 + other.accuracy);
            }
}

TEST_CASE("contact: nothing is a number that is none for shapes at one place", "[rigid]")
{
    for (const NamedShape& first : all_shapes())
        for (const NamedShape& second : all_shapes())
            for (const Vector3d& X :
                 {Vector3d(0, 0, 0), Vector3d(0, 1e-15, 0), Vector3d(1e-3, 0, 0)}) {
                CAPTURE(first.name, second.name);
                for (const Contact& t :
                     touches_of(first.shape, {}, second.shape, {Matrix3d::Identity(), X}, 0.1)) {
                    REQUIRE(std::isfinite(t.gap));
                    REQUIRE(t.point.allFinite());
                    REQUIRE_THAT(t.normal.norm(), IsClose(1.0, Rounding(16)));
                }
            }
}

TEST_CASE("contact: far from the origin of the world touches are the same", "[rigid]")
{
    const Vector3d far(1e6, -1e6, 1e6);
    for (const NamedShape& first : all_shapes())
        for (const NamedShape& second : all_shapes()) {
            CAPTURE(first.name, second.name);
            Random random(3);
            const Pose a{random.rotation(), {0, 0, 0}},
                b{random.rotation(), 0.5 * random.unit_vector()};
            const auto here = touches_of(first.shape, a, second.shape, b, 0.1);
            const auto there =
                touches_of(first.shape, {a.R, a.X + far}, second.shape, {b.R, b.X + far}, 0.1);
            if (here.empty()) continue;
            REQUIRE(!there.empty());
            REQUIRE(std::abs(deepest(here) - deepest(there)) < 1e-8); // 1e6 eps with a margin
        }
}
