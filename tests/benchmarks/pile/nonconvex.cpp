// SPDX-License-Identifier: MIT
// Piles of nonconvex bodies of different size. Each pile falls and comes to rest; then the steps
// are timed, and in every tenth step each phase is timed by itself. A straight line through the
// logarithms gives the growth of the time with the number of bodies.
#include "nonconvex.hpp"
#include "run.hpp"

#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/mass.hpp"
#include "rigid/detection/broad_phase.hpp"
#include "rigid/detection/contact_candidates.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/step.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

constexpr int layers = 5, falling = 90, lying = 60,
              sampled = 10;         // steps; the phases of every tenth are timed
constexpr double spacing = 1.4;     // [m]
constexpr double most_beyond = 0.1; // largest exponent of time/(N log N)

struct Room {
    int x = 0, z = 0; // bodies along each side; there are `layers` of them in y
    int bodies() const { return x * z * layers; }
};
constexpr Room rooms[] = {{3, 4}, {5, 5}, {5, 10}, {10, 10}};

// Solids that fit into a ball of 0.7 m.
std::vector<Shape> nonconvex_shapes()
{
    const auto solid = [](TriangleMesh mesh, const char* name) {
        return Shape(Mesh{std::make_shared<SolidMesh>(std::move(mesh), name)});
    };
    return {solid(torus_mesh(0.4, 0.12, 24, 12), "torus"),
            solid(ring_mesh(0.3, 0.5, 0.2, 24), "ring"), solid(cross_mesh(1, 0.25), "cross"),
            solid(bowl_mesh(0.5, 0.12, 24), "bowl"), solid(gear_mesh(10, 0.45, 0.15, 0.2), "gear")};
}

RigidBody body_of(const Shape& shape, const Vector3d& X, const Quaternion& q, bool is_static)
{
    RigidBody body;
    body.name = "body";
    Part part;
    part.shape = shape;
    part.density = pile_density;
    body.parts = {part};
    body.material = {0, pile_friction};
    body.is_static = is_static;
    body.state.position = X;
    body.state.orientation = q;
    set_mass_from_parts(body);
    return body;
}

World room_of_bodies(const Room& room)
{
    testing::Random random(1);
    const std::vector<Shape> shapes = nonconvex_shapes();
    const double w = room.x * spacing / 2, d = room.z * spacing / 2, height = 20;
    World world;
    world.settings.gravity = {0, pile_gravity, 0};
    world.settings.contact_method = ContactMethod::simultaneous;
    world.settings.formulas_are_reference = true;
    world.settings.optimisations.sleep = false;
    const auto wall = [&](const Vector3d& size, const Vector3d& X) {
        world.bodies.push_back(body_of(Box{size}, X, {}, true));
    };
    wall({2 * w + 2, 1, 2 * d + 2}, {0, -0.5, 0});
    for (double side : {-1.0, 1.0}) {
        wall({1, height, 2 * d + 2}, {side * (w + 0.5), height / 2, 0});
        wall({2 * w, height, 1}, {0, height / 2, side * (d + 0.5)});
    }
    for (int y = 0; y < layers; ++y)
        for (int z = 0; z < room.z; ++z)
            for (int x = 0; x < room.x; ++x) {
                const Vector3d X((x + 0.5) * spacing - w, (y + 0.5) * spacing,
                                 (z + 0.5) * spacing - d);
                const Shape& shape = shapes[world.bodies.size() % shapes.size()];
                world.bodies.push_back(body_of(shape, X, random.quaternion(), false));
            }
    return world;
}

// The times of the phases of a step [s], one entry for each measured step.
struct Phases {
    std::vector<double> flight, broad, narrow, solve;
};

// Times each phase again by itself on the same world. The rest of the step's time counts as
// solving.
void look_into(World world, double whole, Phases& phases)
{
    ThreadPool alone;
    std::vector<RigidState> flown;
    const std::vector<bool> pulled = pulled_bodies(world, pile_step);
    const double flight = seconds([&] { flown = fly_all(world, pulled, pile_step, alone); });
    std::vector<Pose> poses;
    std::vector<Bounds> bounds;
    for (const RigidBody& body : world.bodies) {
        const Part& part = body.parts[0];
        poses.push_back(pose_of(body.state));
        bounds.push_back(bounds_of(part.shape, part_pose(poses.back(), part)));
        if (!body.is_static) bounds.back().grow(bounding_radius(part) / 2);
    }
    const double broad = seconds([&] { near_pairs(world, poses, bounds, alone); });
    const double near = seconds([&] { contact_candidates(world, flown, pile_step, alone); });
    phases.flight.push_back(flight);
    phases.broad.push_back(broad);
    // The difference of noisy times can be negative.
    phases.narrow.push_back(std::max(0.0, near - broad));
    phases.solve.push_back(std::max(0.0, whole - flight - near));
}

int escaped(const World& world, const Room& room)
{
    return static_cast<int>(
        std::count_if(world.bodies.begin(), world.bodies.end(), [&](const RigidBody& body) {
            const Vector3d& X = body.state.position;
            const bool is_inside = X.y() > 0 && std::abs(X.x()) < room.x * spacing / 2 &&
                                   std::abs(X.z()) < room.z * spacing / 2;
            return !body.is_static && !is_inside;
        }));
}

// The median time of a step once the bodies lie at rest [s].
double measure(Bench& bench, const Room& room, int& left)
{
    World world = room_of_bodies(room);
    for (int i = 0; i < falling; ++i)
        step(world, pile_step);
    std::vector<double> times;
    Phases phases;
    std::uint64_t contacts = 0;
    for (int i = 0; i < lying; ++i) {
        const World before = i % sampled == 0 ? world : World();
        const std::uint64_t contacts_before = world.counters.contacts;
        times.push_back(seconds([&] { step(world, pile_step); }));
        contacts = world.counters.contacts - contacts_before;
        if (i % sampled == 0) look_into(before, times.back(), phases);
    }
    const double flight = median(phases.flight), broad = median(phases.broad),
                 narrow = median(phases.narrow), solve = median(phases.solve),
                 all = flight + broad + narrow + solve;
    const int gone = escaped(world, room);
    left += gone;
    bench.row({{"nonconvex bodies", static_cast<double>(room.bodies())},
               {"time a step [ms]", median(times) * 1e3},
               {"contacts", static_cast<double>(contacts)},
               {"escaped", static_cast<double>(gone)},
               {"flight", flight / all},
               {"broad phase", broad / all},
               {"narrow phase", narrow / all},
               {"solution", solve / all},
               {"level sets built", static_cast<double>(world.counters.level_sets_built)}});
    return median(times);
}

// The exponent p of y ∝ xᵖ, by a least-squares line through the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
    const auto n = static_cast<double>(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double a = std::log(x[i]), b = std::log(y[i]);
        sx += a;
        sy += b;
        sxx += a * a;
        sxy += a * b;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

} // namespace

void measure_nonconvex_piles(Bench& bench)
{
    std::vector<double> numbers, scaled;
    int left = 0;
    for (const Room& room : rooms) {
        const double n = room.bodies();
        numbers.push_back(n);
        scaled.push_back(measure(bench, room, left) / (n * std::log(n)));
    }
    bench.note("Nonconvex bodies: tori, rings, crosses, bowls and gears as meshes, five layers "
               "dropped into a room; times are medians of");
    bench.note(std::to_string(lying) + " steps from " + std::to_string(falling) +
               " on. Every tenth step is taken apart: its phases are timed by themselves.");
    bench.reach({"nonconvex bodies that left their room", static_cast<double>(left), 0, "lower"});
    bench.reach({"nonconvex bodies: exponent of the time a step beyond N log N",
                 exponent(numbers, scaled), most_beyond, "lower"});
}

} // namespace rigor
