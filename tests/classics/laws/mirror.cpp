// SPDX-License-Identifier: MIT
// Mechanics knows no left and right: the mirror image of a scene does the mirror image of what it
// did. Under x → -x a velocity changes the sign of x, an angular velocity those of y and z.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace mirror {

namespace {

Vector3d mirrored(const Vector3d& v)
{
    return {-v.x(), v.y(), v.z()};
}

RigidBody mirrored(RigidBody body)
{
    RigidState& s = body.state;
    s.position = mirrored(s.position);
    s.velocity = mirrored(s.velocity);
    s.angular_momentum = -mirrored(s.angular_momentum);
    s.orientation.v = -mirrored(s.orientation.v);
    return body;
}

} // namespace

TEST_CASE("classics: the mirror image of a scene does the mirror image", "[classics]")
{
    for (unsigned seed = 0; seed < 6; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Material material{0.5, 0.4};
        std::vector<RigidBody> bodies = {fixed(Plane{}, material)}, images = bodies;
        const std::vector<Shape> shapes = {Box{{0.4, 0.3, 0.5}}, Sphere{0.2}, Cylinder{0.2, 0.3}};
        for (int i = 0; i < 3; ++i) {
            RigidBody body = body_of(shapes[i], Vector3d(0.6 * i, 0.6, 0) + 0.05 * random.vector(),
                                     material, random.quaternion());
            body.state.velocity = random.vector();
            spin(body, 2 * random.vector());
            bodies.push_back(body);
            images.push_back(mirrored(body));
        }
        World world = solved(bodies), image = solved(images);
        run(world, 50, 0.01);
        run(image, 50, 0.01);
        for (int i = 1; i < 4; ++i) {
            const RigidState s = mirrored(world.bodies[i]).state, &t = image.bodies[i].state;
            CHECK_THAT(t.position, IsClose(s.position, Order(1e-6)));
            CHECK_THAT(t.velocity, IsClose(s.velocity, Order(1e-5)));
        }
    }
}

} // namespace mirror
