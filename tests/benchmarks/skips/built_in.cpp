// SPDX-License-Identifier: MIT
// The skips that a scene cannot turn off. Each is compared with a scene that means the same but
// does not allow the skip, or with the same work done in the direct way.
#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/bodies/mass.hpp"
#include "rigid/detection/broad_phase.hpp"
#include "run.hpp"
#include "stress/scenes.hpp"
#include "support/random.hpp"

#include <limits>

namespace rigor {

namespace {

using stress::body_of;
using stress::cube;
using stress::fixed;
using stress::frame;
using stress::ground;

constexpr int many = 1000, second = 60;
constexpr double eps = std::numeric_limits<double>::epsilon();

Vector3d place(int i, double spacing, double height)
{
    return {spacing * (i % 10), height + spacing * (i / 100), spacing * (i / 10 % 10)};
}

// Rotating cubes in flight. Their inertia is a multiple of the identity; without `is_isotropic` it
// is treated as a general matrix.
SkipCase isotropic_inertia()
{
    testing::Random random(1);
    std::vector<RigidBody> bodies;
    for (int i = 0; i < many; ++i) {
        bodies.push_back(body_of(cube(1), place(i, 4, 50), {}, random.quaternion()));
        stress::spin(bodies.back(), 3 * random.vector());
    }
    const World marked = stress::world_of(bodies);
    for (RigidBody& body : bodies)
        body.is_isotropic = false;
    const World plain = stress::world_of(bodies);
    return {"isotropic inertia",
            "1000 cubes in flight, with and without the mark",
            "isotropic shortcuts",
            [=] { return run_steps(marked, second, &Counters::isotropic_shortcuts); },
            [=] { return run_steps(plain, second, &Counters::isotropic_shortcuts); },
            64 * second * eps * 50};
}

// Boxes that do not move, as static bodies and as bodies without any force.
SkipCase static_bodies()
{
    const auto scene = [](bool is_static) {
        std::vector<RigidBody> bodies;
        for (int i = 0; i < many; ++i)
            bodies.push_back(is_static ? fixed(cube(1), place(i, 4, 0))
                                       : body_of(cube(1), place(i, 4, 0)));
        RigidBody thrown = body_of(cube(1), {-10, 0, 0});
        thrown.state.velocity = {-3, 1, 0};
        bodies.push_back(thrown);
        return stress::world_of(std::move(bodies), {0, 0, 0});
    };
    return {"static bodies",
            "1000 boxes that stay, as static and as resting without gravity",
            "static skipped",
            [world = scene(true)] { return run_steps(world, second, &Counters::static_skipped); },
            [world = scene(false)] { return run_steps(world, second, &Counters::static_skipped); },
            0};
}

// Spheres in flight above the ground, compared with the same spheres resting on it, where the
// contact stage runs too. Both have closed-form solutions: a fall of g h² n²/2 and rest. The
// results that are compared are the errors against them.
SkipCase free_flight()
{
    const auto run = [](double height) {
        std::vector<RigidBody> bodies = {ground()};
        for (int i = 0; i < many; ++i)
            bodies.push_back(body_of(Sphere{0.5}, {2.0 * (i % 40), height, 2.0 * (i / 40)}));
        SkipRun done =
            run_steps(stress::world_of(std::move(bodies)), second, &Counters::free_flights);
        const double t = second * frame, y = height > 1 ? height - stress::g * t * t / 2 : height;
        for (int i = 0; i <= many; ++i) {
            const double expected = i == 0 ? 0 : y;
            done.result[3 * static_cast<std::size_t>(i) + 1] -= expected;
        }
        return done;
    };
    return {"no contact stage in flight",
            "1000 spheres, in flight and on the ground",
            "free flights",
            [run] { return run(100); },
            [run] { return run(0.5); },
            64 * second * eps * 100};
}

// Bodies that slide. A sphere has one contact, which is solved directly; a cube has four, which
// need sweeps. The results that are compared are the heights of the bodies, which are the same.
SkipCase single_contact()
{
    const auto run = [](const Shape& shape) {
        std::vector<RigidBody> bodies = {ground()};
        for (int i = 0; i < many; ++i) {
            bodies.push_back(body_of(shape, {2.0 * (i % 40), 0.5, 2.0 * (i / 40)}));
            bodies.back().state.velocity = {2, 0, 1};
        }
        SkipRun done =
            run_steps(stress::world_of(std::move(bodies)), second / 4, &Counters::contact_sweeps);
        std::vector<double> heights;
        for (std::size_t i = 1; i < done.result.size(); i += 3)
            heights.push_back(done.result[i]);
        done.result = heights;
        return done;
    };
    return {"no sweeps for one contact",
            "1000 spheres and 1000 cubes that slide",
            "contact sweeps",
            [run] { return run(Sphere{0.5}); },
            [run] { return run(cube(1)); },
            64 * second * eps};
}

// Cubes at random places, and the input of the broad phase for them.
struct Scattered {
    World world;
    std::vector<Pose> poses;
    std::vector<Bounds> bounds;
};

Scattered scattered_cubes()
{
    testing::Random random(1);
    std::vector<RigidBody> bodies;
    Scattered cubes;
    for (int i = 0; i < many; ++i) {
        bodies.push_back(body_of(cube(1), 10 * random.vector()));
        cubes.poses.push_back({Matrix3d::Identity(), bodies.back().state.position});
        cubes.bounds.push_back(bounds_of(bodies.back().parts[0].shape, cubes.poses.back()));
    }
    cubes.world = stress::world_of(std::move(bodies));
    return cubes;
}

// Appends the indices of the bodies.
void add(const std::vector<BodyPair>& pairs, std::vector<double>& all)
{
    for (const BodyPair& pair : pairs)
        all.insert(all.end(), {double(pair.body1), double(pair.body2)});
}

// The pairs that the broad phase finds, compared with a test of every pair.
SkipCase broad_phase()
{
    const Scattered cubes = scattered_cubes();
    const auto found = [=] {
        std::vector<BodyPair> pairs;
        ThreadPool alone;
        SkipRun run;
        run.seconds =
            seconds([&] { pairs = near_pairs(cubes.world, cubes.poses, cubes.bounds, alone); });
        add(pairs, run.result);
        run.counter = static_cast<double>(pairs.size());
        return run;
    };
    const auto every = [=] {
        std::vector<BodyPair> pairs;
        SkipRun run;
        run.seconds = seconds([&] {
            for (int i = 0; i < many; ++i)
                for (int j = i + 1; j < many; ++j)
                    if (cubes.bounds[i].overlaps(cubes.bounds[j])) pairs.push_back({i, j});
        });
        add(pairs, run.result);
        run.counter = many * (many - 1) / 2.0;
        return run;
    };
    return {"pairs that are far apart",
            "1000 cubes, against a look at every pair",
            "pairs tested",
            found,
            every,
            0};
}

// Pairs from the pair cache of the last step, compared with a new search in every step.
SkipCase remembered_pairs()
{
    const Scattered cubes = scattered_cubes();
    testing::Random random(2);
    std::vector<Vector3d> ways;
    for (int i = 0; i < many; ++i)
        ways.push_back(0.005 * random.vector());
    const auto steps = [=](bool remembers) {
        World world = cubes.world;
        const std::vector<Pose>& poses = cubes.poses;
        const std::vector<double> margins(cubes.bounds.size(), 0.1);
        std::vector<Bounds> moved = cubes.bounds;
        ThreadPool alone;
        SkipRun run;
        for (int k = 0; k < 20; ++k) {
            std::vector<BodyPair> pairs;
            run.seconds += seconds([&] {
                pairs = remembers ? cached_near_pairs(world, poses, moved, margins, alone)
                                  : near_pairs(world, poses, moved, alone);
            });
            add(pairs, run.result);
            for (std::size_t i = 0; i < moved.size(); ++i) {
                moved[i].low += ways[i];
                moved[i].high += ways[i];
            }
        }
        run.counter = static_cast<double>(world.counters.pair_searches_saved);
        return run;
    };
    return {"a search for pairs while bodies stay in their fat bounds",
            "1000 cubes that move by up to 5 mm a step",
            "pair searches saved",
            [=] { return steps(true); },
            [=] { return steps(false); },
            0};
}

} // namespace

std::vector<SkipCase> built_in_skips()
{
    return {isotropic_inertia(), static_bodies(),    free_flight(),
            broad_phase(),       remembered_pairs(), single_contact()};
}

} // namespace rigor
