// SPDX-License-Identifier: MIT
// The skips of level sets: a box needs none, and that of a mesh is built when it is first needed.
#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "run.hpp"
#include "stress/scenes.hpp"

namespace rigor {

namespace {

using stress::body_of;
using stress::ground;

constexpr double resting = 0.01; // largest difference of the places where bodies come to rest [m]

// A unit cube as a triangle mesh, with a dent of 5 mm in its top. It is not convex, so it needs a
// level set.
Shape dented_cube()
{
    TriangleMesh mesh = box_mesh(Vector3d::Ones());
    const int middle = static_cast<int>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0.5 - 5e-3, 0);
    std::vector<std::array<int, 3>> triangles;
    for (const std::array<int, 3>& t : mesh.triangles) {
        const auto is_up = [&](int v) {
            return mesh.vertices[static_cast<std::size_t>(v)].y() > 0.4;
        };
        if (!(is_up(t[0]) && is_up(t[1]) && is_up(t[2]))) {
            triangles.push_back(t);
            continue;
        }
        // Two of its edges belong to the square; the third is the diagonal, which is removed.
        for (int i = 0; i < 3; ++i) {
            const int a = t[static_cast<std::size_t>(i)],
                      b = t[static_cast<std::size_t>((i + 1) % 3)];
            const Vector3d edge = mesh.vertices[static_cast<std::size_t>(a)] -
                                  mesh.vertices[static_cast<std::size_t>(b)];
            if (edge.norm() < 1.2) triangles.push_back({a, b, middle});
        }
    }
    mesh.triangles = triangles;
    return Mesh{std::make_shared<SolidMesh>(std::move(mesh), "dented cube")};
}

// Five towers of two cubes, as boxes and as meshes.
SkipCase no_level_set_for_a_box()
{
    const auto scene = [](const Shape& shape) {
        std::vector<RigidBody> bodies = {ground()};
        for (int i = 0; i < 10; ++i)
            bodies.push_back(body_of(shape, {3.0 * (i % 5), 0.5 + i / 5, 0}));
        return stress::world_of(std::move(bodies));
    };
    return {"no level set for a box",
            "5 towers of 2 cubes, as boxes and as meshes with a dent",
            "level set samples",
            [world = scene(stress::cube(1))] {
                return run_steps(world, 30, &Counters::level_set_samples);
            },
            [world = scene(dented_cube())] {
                return run_steps(world, 30, &Counters::level_set_samples);
            },
            resting};
}

// Rings with separate meshes that never come near each other, so that their level sets are never
// needed. They are compared with rings whose level sets are built at the start.
SkipCase lazy_level_sets()
{
    const auto run = [](bool at_once) {
        constexpr int count = 5;
        double built = 0;
        std::vector<RigidBody> bodies;
        SkipRun done;
        const double making = seconds([&] {
            for (int i = 0; i < count; ++i) {
                const auto solid =
                    std::make_shared<SolidMesh>(ring_mesh(0.3, 0.5, 0.2, 24), "ring");
                if (at_once) solid->level_set([&built] { ++built; });
                bodies.push_back(body_of(Mesh{solid}, {5.0 * i, 20, 0}));
            }
        });
        done = run_steps(stress::world_of(std::move(bodies)), 30, &Counters::level_sets_built);
        done.seconds += making;
        done.counter += built;
        return done;
    };
    return {"level sets when they are asked for",
            "5 rings in flight, their level sets made at once",
            "level sets built",
            [run] { return run(false); },
            [run] { return run(true); },
            0};
}

} // namespace

std::vector<SkipCase> mesh_skips()
{
    return {no_level_set_for_a_box(), lazy_level_sets()};
}

} // namespace rigor
