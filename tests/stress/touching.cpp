// SPDX-License-Identifier: MIT
// Contacts without a single best solution: faces in one plane, parallel edges, bodies of almost
// zero thickness, floors made of many pieces.
#include "stress/scenes.hpp"
#include "stress/watch.hpp"

#include "geometry/shapes/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor::stress {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double quarter = std::numbers::pi / 4;

// A floor of nx × nz boxes whose tops all lie at y = 0.
std::vector<RigidBody> tiles(int nx, int nz, double width, const Material& material)
{
    std::vector<RigidBody> bodies;
    const double w = width / nx, d = width / nz;
    for (int i = 0; i < nx; ++i)
        for (int k = 0; k < nz; ++k)
            bodies.push_back(fixed(Box{{w, 1, d}},
                                   {(i + 0.5) * w - width / 2, -0.5, (k + 0.5) * d - width / 2},
                                   material));
    return bodies;
}

// A floor 20 m wide with its top at y = 0, made of boxes or of triangles.
struct Floor {
    std::string name;
    std::vector<RigidBody> (*bodies)(const Material&);
    bool is_quick = false;
};

std::vector<RigidBody> mesh_floor(int n, const Material& material)
{
    return {fixed(slab(n, 20), {0, 0, 0}, material)};
}

const Floor floors[] = {
    {"2 boxes", [](const Material& m) { return tiles(2, 1, 20, m); }, true},
    {"64 boxes", [](const Material& m) { return tiles(8, 8, 20, m); }, true},
    {"8010 boxes", [](const Material& m) { return tiles(89, 90, 20, m); }, false},
    {"2 triangles on top", [](const Material& m) { return mesh_floor(1, m); }, true},
    {"8192 triangles on top", [](const Material& m) { return mesh_floor(64, m); }, false},
};

// A body slides over the seams of a floor without friction. It must move on as if there were no
// seams, up to the rounding errors of n steps.
void cross_seams(Record& record, RigidBody body, std::vector<RigidBody> bodies)
{
    constexpr int steps = 120;
    const Vector3d v(3, 0, 1);
    body.state.velocity = v;
    bodies.push_back(body);
    Watch watch(world_of(std::move(bodies)), record, 0);
    watch.run(steps, frame, 20);
    const RigidState &before = watch.start().bodies.back().state,
                     &after = watch.world().bodies.back().state;
    const Vector3d expected = before.position + steps * frame * v;
    record.limit_drift("place against v t [m]", (after.position - expected).norm(),
                       64 * steps * eps * 10, 'R');
    record.limit("speed against v [m/s]", (after.velocity - v).norm(), 64 * steps * eps * 3, 'R');
    watch.limit_penetration(64 * steps * eps);
    watch.limit_energy(64 * steps * eps);
}

// A stack that stands on a floor made of pieces.
void rest_on_pieces(Record& record, std::vector<RigidBody> bodies)
{
    for (int i = 0; i < 5; ++i)
        bodies.push_back(body_of(cube(1), {0.1, i + 0.5, 0.2}));
    World world = world_of(std::move(bodies));
    const double scale = lifting_energy(world, 1);
    Watch watch(std::move(world), record, scale);
    watch.run(300, frame, 50);
    record.limit_drift("moved, in edges", watch.farthest_moved(), standing, 'B');
    watch.limit_penetration(allowed_depth);
    watch.limit_energy(allowed_depth);
}

void add_floors(Suite& suite)
{
    const std::string line = "coplanar faces, floors of many pieces";
    const Material smooth{0, 0};
    for (const Floor& floor : floors) {
        const auto make = floor.bodies;
        const auto add = [&](const std::string& name, const RigidBody& body) {
            suite.push_back({line, name + " slides over " + floor.name, floor.is_quick,
                             [=](Record& record) { cross_seams(record, body, make(smooth)); }});
        };
        add("cube", body_of(cube(1), {-4, 0.5, -2}, smooth));
        add("turned cube", body_of(cube(1), {-4, 0.5, -2}, smooth, turn({0, 1, 0}, 0.3)));
        add("sphere", body_of(Sphere{0.5}, {-4, 0.5, -2}, smooth));
        suite.push_back({line, "5 cubes rest on " + floor.name, floor.is_quick,
                         [=](Record& record) { rest_on_pieces(record, make(rough)); }});
    }
}

// A body falls onto a static body or lies on it. It must neither sink in nor gain energy.
void fall_on(Record& record, const RigidBody& fixed_body, const RigidBody& body, double size,
             bool is_touching)
{
    World world = world_of({fixed_body, body});
    const double scale = lifting_energy(world, size);
    Watch watch(std::move(world), record, scale);
    watch.run(120, frame);
    watch.limit_penetration((is_touching ? allowed_depth : allowed_impact_depth) * size);
    record.limit("penetration at the end [m]", deepest_overlap(watch.world()), allowed_depth * size,
                 'I');
    watch.limit_energy(allowed_depth);
}

void add_edges(Suite& suite)
{
    const double top = std::sqrt(0.5); // a unit cube that stands on an edge
    const RigidBody edge_up = fixed(cube(1), {0, 0, 0}, rough, turn({0, 0, 1}, quarter));
    for (const double height : {0.0, 0.5}) {
        const std::string how = height > 0 ? ", falling 0.5 m" : ", touching";
        const auto add = [&](const std::string& name, const RigidBody& below,
                             const RigidBody& above, double size) {
            suite.push_back({"parallel and crossed edges", name + how, true, [=](Record& record) {
                                 fall_on(record, below, above, size, height == 0);
                             }});
        };
        const auto on_edge = [&](const Vector3d& axis, double x) {
            return body_of(cube(1), {x, 2 * top + height, 0}, rough, turn(axis, quarter));
        };
        add("cube edge on a parallel edge", edge_up, on_edge({0, 0, 1}, 0), 1);
        add("the same, 0.1 beside", edge_up, on_edge({0, 0, 1}, 0.1), 1);
        add("two crossed cubes, edge on edge", edge_up, on_edge({1, 0, 0}, 0), 1);
        const RigidBody bar = fixed(Box{{0.1, 0.1, 4}}, {0, 0, 0}, rough, turn({0, 0, 1}, quarter));
        add("two crossed bars, edge on edge", bar,
            body_of(Box{{4, 0.1, 0.1}}, {0, 0.2 * top + height, 0}, rough,
                    turn({1, 0, 0}, quarter)),
            0.1);
        add("face on an edge", edge_up, body_of(cube(1), {0, top + 0.5 + height, 0}), 1);
    }
}

// A pile of plates keeps its order: no plate falls through another one or through the floor.
void lay_plates(Record& record, double thickness)
{
    std::vector<RigidBody> bodies = {ground()};
    for (int i = 0; i < 5; ++i)
        bodies.push_back(body_of(Box{{1, thickness, 1}},
                                 {0.05 * i, (i + 0.5) * (thickness + 0.1), 0}, rough,
                                 turn({1, 0, 2}, 0.01 * i)));
    World world = world_of(std::move(bodies));
    const double scale = lifting_energy(world, thickness);
    Watch watch(std::move(world), record, scale);
    watch.run(300, frame);
    double order = std::numeric_limits<double>::infinity(), below = -thickness / 2;
    for (std::size_t i = 1; i < watch.world().bodies.size(); ++i) {
        const double y = watch.world().bodies[i].state.position.y();
        order = std::min(order, (y - below) / thickness);
        below = y;
    }
    record.limit_drift("share of its thickness that a plate is missing", 1 - order, standing, 'I');
    watch.limit_penetration(standing * thickness);
    watch.limit_energy(standing);
}

} // namespace

void add_touching(Suite& suite)
{
    add_floors(suite);
    add_edges(suite);
    for (double thickness : {1e-1, 1e-2, 1e-3, 1e-4}) {
        char name[64];
        std::snprintf(name, sizeof name, "5 plates 1 x 1 x %g fall on each other", thickness);
        suite.push_back({"slivers", name, true,
                         [thickness](Record& record) { lay_plates(record, thickness); }});
    }
}

} // namespace rigor::stress
