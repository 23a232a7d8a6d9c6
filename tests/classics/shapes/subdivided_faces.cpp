// SPDX-License-Identifier: MIT
// A cube rests on its face however the face is divided into triangles: the solid is the same, and
// the ground's pressure does not know of vertices inside a flat face.
#include "framework/rigid/worlds.hpp"

#include "geometry/meshes/generators.hpp"
#include "support/catch.hpp"

#include <array>
#include <map>

using namespace rigor;
using namespace rigor::testing;

namespace {

// A cube of edge 1 m, each face divided into n by n squares.
TriangleMesh divided_cube(int n)
{
    TriangleMesh mesh;
    std::map<std::array<int, 3>, int> numbers;
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [found, is_new] =
            numbers.try_emplace(at, static_cast<int>(mesh.vertices.size()));
        if (is_new)
            mesh.vertices.push_back(Vector3d(at[0], at[1], at[2]) / n - Vector3d(0.5, 0.5, 0.5));
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> at{};
                        at[axis] = side;
                        at[(axis + 1) % 3] = i + di;
                        at[(axis + 2) % 3] = j + dj;
                        return vertex(at);
                    };
                    std::array<int, 4> c = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                    if (side == 0) std::swap(c[1], c[3]);
                    mesh.triangles.push_back({c[0], c[1], c[2]});
                    mesh.triangles.push_back({c[0], c[2], c[3]});
                }
    return mesh;
}

} // namespace

TEST_CASE("classics: a cube rests on any tessellation of its face", "[classics]")
{
    const Material rough{0, 0.5};
    const auto cube = [](int n) { return mesh_of(divided_cube(n)); };
    const std::vector<std::pair<const char*, Shape>> grounds = {
        {"plane", Plane{}}, {"box", Box{{4, 1, 4}}}, {"cube", cube(1)}, {"cube 5", cube(5)}};
    for (const auto& [name, ground] : grounds)
        for (int n : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 20}) {
            CAPTURE(name, n);
            const double top = name[0] == 'p' ? 0 : 0.5;
            const Vector3d start(0.1, top + 0.5, -0.07);
            RigidBody body = body_of(cube(n), start, rough, turn({0, 1, 0}, 0.3));
            World world = world_of({fixed(ground, rough), body});
            world.settings.formulas_are_reference = true;
            run(world, 240, 1 / 60.);
            const RigidState& s = world.bodies[1].state;
            const double moved = (s.position - start).norm(),
                         turned = (s.orientation.v - body.state.orientation.v).norm();
            check_at_most(moved, 1e-12, "way [m]");
            check_at_most(turned, 1e-12, "turn");
        }
}
