// SPDX-License-Identifier: MIT
// Bodies slide and roll over a level floor that is made of many boxes. Its joints must not change
// their motion: no body catches on an edge that lies in the plane of its neighbors (van den Bergen
// 2003, "Collision detection in interactive 3D environments": internal edges).
#include "classics/problems.hpp"

#include "geometry/meshes/generators.hpp"

#include <string>
#include <vector>

namespace floor_of_tiles {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double wide = 0.23, deep = 0.19; // a tile along x and along z [m]
constexpr int steps = 60;

struct Traveler {
    const char* name;
    Shape shape;
    double height;     // the height where its center is [m]
    bool lies = false; // its y axis is level and across its way
    bool rolls = false;
};

std::vector<Traveler> travelers(double r)
{
    return {{"sphere slides", Sphere{r}, r},
            {"sphere rolls", Sphere{r}, r, false, true},
            {"cube slides", Box{Vector3d::Constant(2 * r)}, r},
            {"disk slides", Cylinder{r, r}, r / 2},
            {"cone slides", Cone{r, r}, r / 4},
            {"cylinder rolls", Cylinder{r, 1.5 * r}, r, true, true},
            {"capsule rolls", Capsule{r, 1.5 * r}, r, true, true},
            {"capsule slides", Capsule{r, 1.5 * r}, r, true},
            {"torus rolls", Torus{0.8 * r, 0.2 * r}, r, true, true}};
}

// The tiles on which a body moves that starts at the origin.
std::vector<RigidBody> tiles(const Shape& tile, const Vector3d& way, double r,
                             const Material& material)
{
    std::vector<RigidBody> bodies;
    for (int i = -40; i <= 40; ++i)
        for (int k = -40; k <= 40; ++k) {
            const Vector3d X((i + 0.37) * wide, -0.5, (k + 0.41) * deep);
            const Vector3d from = X.cwiseMin(X - way), to = X.cwiseMax(X - way);
            const double reach = 2 * r + wide;
            const bool is_near =
                from.x() < reach && to.x() > -reach && from.z() < reach && to.z() > -reach;
            if (is_near) bodies.push_back(fixed(tile, material, X));
        }
    return bodies;
}

RigidBody body_that_moves(const Traveler& traveler, double r, const Vector3d& V,
                          const Material& material)
{
    const double angle = std::atan2(-V.z(), V.x());
    Quaternion q = turn({0, 1, 0}, angle);
    if (traveler.lies) {
        const Eigen::Quaterniond lying(rotation_matrix(q) *
                                       rotation_matrix(turn({1, 0, 0}, pi / 2)));
        q = {lying.w(), lying.vec()};
    }
    RigidBody body = body_of(traveler.shape, {0, traveler.height, 0}, material, q);
    body.state.velocity = V;
    if (traveler.rolls) spin(body, Vector3d(V.z(), 0, -V.x()) / r);
    return body;
}

} // namespace

namespace {

// Lets the bodies for which holds(name) is true move over a floor of such tiles.
void cross_joints(const Shape& tile, bool (*holds)(const std::string& name))
{
    Sweep sweep;
    const double h = 1. / 60;
    for (const double restitution : {0., 0.5, 1.})
        for (const double r : {0.05, 0.3, 1.})
            for (const Vector3d& V :
                 {Vector3d(3, 0, 1), Vector3d(1, 0, 0.3), Vector3d(0.2, 0, 0.07),
                  Vector3d(2, 0, 0.01), Vector3d(-1.5, 0, 1.2)})
                for (const Traveler& traveler : travelers(r)) {
                    if (!holds(traveler.name) || !sweep.takes_next()) continue;
                    CAPTURE(restitution, r, V, traveler.name);
                    const Material material{restitution, traveler.rolls ? 0.6 : 0};
                    const Vector3d way = steps * h * V;
                    std::vector<RigidBody> bodies = tiles(tile, way, r, material);
                    bodies.push_back(body_that_moves(traveler, r, V, material));
                    const Vector3d start = bodies.back().state.position;
                    World world = solved(std::move(bodies));
                    world.settings.optimisations.sleep = false;
                    run(world, steps, h);
                    const RigidState& end = world.bodies.back().state;
                    CHECK_THAT(end.position, IsClose(start + way, Order(1e-3 * r)));
                    CHECK_THAT(end.velocity, IsClose(V, Order(1e-3 * V.norm())));
                }
}

} // namespace

TEST_CASE("classics: the joints of a floor of tiles do not change a motion",
          "[classics][unsanitized]")
{
    cross_joints(Box{{wide, 1, deep}}, [](const std::string&) { return true; });
}

TEST_CASE("classics: the joints of a floor of convex meshes do not change a motion",
          "[classics][.long][unsanitized]")
{
    // Capsules and tori still catch on such joints.
    cross_joints(mesh_of(box_mesh({wide, 1, deep})), [](const std::string& name) {
        return name.find("capsule") == name.npos && name.find("torus") == name.npos;
    });
}

} // namespace floor_of_tiles
