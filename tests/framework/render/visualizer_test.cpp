// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "geometry/distance/signed_distance.hpp"
#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "pictures.hpp"
#include "render/shape_surfaces.hpp"
#include "render/visualizer.hpp"
#include "scene/trajectory/trajectory.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace rigor;

TEST_CASE("visualizer: each part becomes a solid where its body is", "[render]")
{
    SmallRun run = small_run();
    const double half = std::sqrt(0.5);
    run.frame.bodies[1].orientation = {half, Vector3d(0, 0, half)}; // a quarter turn about z
    run.bodies[1].center_of_mass = Vector3d(0.25, 0, 0);
    run.scene.bodies[1].parts[0].position = Vector3d(0.5, 0, 0);
    const Picture picture = Visualizer(run.scene, run.bodies, Overlays()).picture(run.frame);

    REQUIRE(picture.boxes.size() == 1);
    REQUIRE(picture.balls.size() == 1);
    REQUIRE(picture.grounds.size() == 1);
    CHECK(picture.grounds[0].solid);
    CHECK(picture.rods.empty()); // no overlays, no springs
    CHECK(picture.texts.empty());
    // X + R (part − c) = (−1, 0.5, 0) + (0, 0.25, 0)
    CHECK((picture.boxes[0].position - Vector3f(-1, 0.75F, 0)).norm() < 1e-6F);
    CHECK((picture.boxes[0].axes.col(0) - Vector3f(0, 0.5F, 0)).norm() < 1e-6F);
    CHECK((picture.balls[0].axes - 0.5F * Matrix3f::Identity()).norm() < 1e-6F);
    CHECK((picture.boxes[0].color - picture.balls[0].color).norm() > 0.1F);
}

TEST_CASE("visualizer: of boxes of a body with faces in one plane the first is seen", "[render]")
{
    SmallRun run = small_run();
    std::vector<Part>& parts = run.scene.bodies[1].parts;
    parts[0] = Part{Box{{2, 1, 0.5}}, Vector3d(0.1, 0, 0), Quaternion{}, 1000};
    Part turned = parts[0]; // turned about z: both faces along z are in common planes
    turned.orientation = {std::cos(0.2), Vector3d(0, 0, std::sin(0.2))};
    Part other = parts[0]; // on top of the first: faces in a common plane look opposite ways
    other.position = Vector3d(0.3, 0.2, 0.5);
    parts.insert(parts.end(), {turned, other});
    const Picture picture = Visualizer(run.scene, run.bodies, Overlays()).picture(run.frame);
    REQUIRE(picture.boxes.size() == 3);
    const auto half_sizes = [&](int i) -> Vector3f {
        return picture.boxes[i].axes.colwise().norm().transpose();
    };
    CHECK((half_sizes(0) - Vector3f(1, 0.5F, 0.25F)).norm() < 1e-6F);
    CHECK((half_sizes(2) - Vector3f(1, 0.5F, 0.25F)).norm() < 1e-6F);
    CHECK((half_sizes(1).head<2>() - Eigen::Vector2f(1, 0.5F)).norm() < 1e-6F);
    CHECK(half_sizes(1).z() < 0.25F - 2e-5F);
    CHECK(half_sizes(1).z() > 0.25F - 2e-4F); // only a little thinner
}

TEST_CASE("visualizer: shapes of one make are drawn from one surface", "[render]")
{
    SmallRun run = small_run();
    const auto cross = std::make_shared<SolidMesh>(cross_mesh(1, 0.3));
    const auto add = [&](const Shape& shape) {
        run.scene.bodies.push_back(run.scene.bodies[1]);
        run.scene.bodies.back().parts[0].shape = shape;
        run.bodies.push_back(run.bodies[1]);
        run.frame.bodies.push_back(run.frame.bodies[1]);
    };
    for (const Shape& shape : {Shape(Cylinder{1, 2}), Shape(Cylinder{1, 2}), Shape(Cylinder{1, 3}),
                               Shape(Cone{1, 2}), Shape(Capsule{1, 2}), Shape(Torus{2, 1}),
                               Shape(Mesh{cross}), Shape(Mesh{cross}), Shape(Ellipsoid{{1, 2, 3}})})
        add(shape);
    const Picture picture = Visualizer(run.scene, run.bodies, Overlays()).picture(run.frame);
    REQUIRE(picture.models.size() == 6);
    std::vector<std::size_t> instances;
    for (const Model& model : picture.models)
        instances.push_back(model.instances.size());
    CHECK(instances == std::vector<std::size_t>{2, 1, 1, 1, 1, 2});
    CHECK(picture.boxes.size() == 1);
    REQUIRE(picture.balls.size() == 2); // the ellipsoid is drawn as a ball
    CHECK((picture.balls[1].axes.colwise().norm().transpose() - Vector3f(1, 2, 3)).norm() < 1e-5F);
}

TEST_CASE("visualizer: a surface has the size of its shape and normals that point out of it",
          "[render]")
{
    for (const Shape& shape :
         {Shape(Cylinder{1, 2}), Shape(Cone{1, 2}), Shape(Capsule{1, 2}), Shape(Torus{2, 1})}) {
        CAPTURE(shape.index());
        const Surface surface = surface_of(shape);
        REQUIRE(surface.triangles.size() > 100);
        for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return Vector3d(
                    (surface.triangles[i + k].position + surface.center).cast<double>());
            };
            const Vector3d face = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
            for (std::size_t k = 0; k < 3; ++k) {
                const SurfaceVertex& v = surface.triangles[i + k];
                REQUIRE(std::abs(signed_distance(shape, corner(k)).distance) < 1e-5);
                REQUIRE(std::abs(v.normal.norm() - 1) < 1e-5F);
                REQUIRE(v.normal.cast<double>().dot(face) > 0.8);
                REQUIRE(v.position.norm() <= surface.radius);
            }
        }
    }
}

TEST_CASE("visualizer: sharp edges are marked and smooth ones are not", "[render]")
{
    const auto marked = [](const Shape& shape) {
        std::size_t count = 0;
        for (const SurfaceVertex& v : surface_of(shape).triangles)
            count += v.edges.minCoeff() < 1e5F;
        return count;
    };
    CHECK(marked(Torus{2, 1}) == 0);
    CHECK(marked(Capsule{1, 2}) == 0);
    CHECK(marked(Cylinder{1, 2}) > 0); // its rims are marked
    const Surface cube = surface_of(Mesh{std::make_shared<SolidMesh>(box_mesh({2, 2, 2}))});
    for (std::size_t i = 0; i < cube.triangles.size(); i += 3) {
        // Each triangle is half of a square: its two edges at right angles are sharp, its diagonal
        // is not.
        Vector3f farthest = Vector3f::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            farthest = farthest.cwiseMax(cube.triangles[i + k].edges);
        std::sort(farthest.data(), farthest.data() + 3);
        CHECK(std::abs(farthest[0] - 2) < 1e-5F);
        CHECK(std::abs(farthest[1] - 2) < 1e-5F);
        CHECK(farthest[2] > 1e5F);
    }
}

TEST_CASE("visualizer: a color that a scene names is taken", "[render]")
{
    SmallRun run = small_run();
    run.scene.bodies[1].color = Vector3d(1, 0, 0);
    const Picture picture = Visualizer(run.scene, run.bodies, Overlays()).picture(run.frame);
    CHECK(picture.boxes[0].color == Vector4f(1, 0, 0, 1));
}

TEST_CASE("visualizer: angular velocity and momentum point where they should", "[render]")
{
    SmallRun run = small_run();
    Overlays overlays;
    overlays.angular_velocity = true;
    const auto first_cone = [&] {
        const Picture picture = Visualizer(run.scene, run.bodies, overlays).picture(run.frame);
        REQUIRE(picture.cones.size() == 1); // only for the box, since the ball does not turn
        return picture.cones[0].axes.col(2).normalized().eval();
    };
    // ω = I⁻¹ L = (0.1/0.1, 0.4/0.2, 0)
    CHECK((first_cone() - Vector3f(1, 2, 0).normalized()).norm() < 1e-5F);
    overlays.angular_velocity = false;
    overlays.angular_momentum = true;
    CHECK((first_cone() - Vector3f(1, 4, 0).normalized()).norm() < 1e-5F);
}

TEST_CASE("visualizer: a rod without inertia about its axis has an angular velocity", "[render]")
{
    SmallRun run = small_run();
    run.bodies[1].inertia = Vector3d(0.1, 0, 0.1).asDiagonal();
    run.frame.bodies[1].angular_momentum = Vector3d(0.1, 0, 0);
    Overlays overlays;
    overlays.angular_velocity = true;
    const Picture picture = Visualizer(run.scene, run.bodies, overlays).picture(run.frame);
    REQUIRE(picture.cones.size() == 1);
    CHECK((picture.cones[0].axes.col(2).normalized() - Vector3f::UnitX()).norm() < 1e-5F);
}

TEST_CASE("visualizer: a spring ends where it is fastened", "[render]")
{
    SmallRun run = small_run();
    const Vector3d center(0.3, -0.1, 0.2), point(0.5, 0.5, 0), wall(-2, 1, 0);
    run.bodies[1].center_of_mass = center;
    run.frame.bodies[1].position = {1, 2, 3};
    run.frame.bodies[1].orientation = {std::sqrt(0.5), {0, 0, std::sqrt(0.5)}}; // 90° about z
    Spring spring;
    spring.body1 = -1;
    spring.point1 = wall;
    spring.body2 = 1;
    spring.point2 = point;
    run.scene.springs = {spring};
    const Picture picture = Visualizer(run.scene, run.bodies, Overlays()).picture(run.frame);
    REQUIRE(!picture.rods.empty());
    const Vector3d arm = point - center,
                   end = Vector3d(1, 2, 3) + Vector3d(-arm.y(), arm.x(), arm.z());
    const Instance &first = picture.rods.front(), &last = picture.rods.back();
    CHECK((first.position - wall.cast<float>()).norm() < 1e-5F);
    CHECK((last.position + last.axes.col(2) - end.cast<float>()).norm() < 1e-5F);
}

TEST_CASE("visualizer: overlays add what they name and a legend", "[render]")
{
    SmallRun run = small_run();
    ContactRecord contact;
    contact.body1 = 1;
    contact.point = Vector3d(-1, 0, 0);
    contact.impulse = Vector3d(0, 2, 0);
    run.frame.contacts = {contact};
    run.frame.time = 0.25;
    Overlays overlays;
    overlays.axes = overlays.contacts = overlays.labels = true;
    const Picture picture = Visualizer(run.scene, run.bodies, overlays).picture(run.frame);

    CHECK(picture.cones.size() == 7); // three axes for the box, three for the ball, one impulse
    CHECK(picture.dots.size() == 1);
    std::string all;
    for (const Text& text : picture.texts)
        all += text.text + "\n";
    for (const char* expected : {"small   t = 0.250 s", "x body axis", "impulse", "box", "ball"})
        CHECK(all.find(expected) != std::string::npos);
    CHECK(all.find("angular") == std::string::npos);
    CHECK(all.find("floor") == std::string::npos); // a plane gets no name
}

TEST_CASE("visualizer: a scene without a plane gets lines to see motion by", "[render]")
{
    SmallRun run = small_run();
    run.scene.bodies[0].parts[0].shape = Box{{1, 1, 1}};
    Overlays overlays;
    Picture picture = Visualizer(run.scene, run.bodies, overlays).picture(run.frame);
    REQUIRE(picture.grounds.size() == 1);
    CHECK_FALSE(picture.grounds[0].solid);
    overlays.grid = false;
    CHECK(Visualizer(run.scene, run.bodies, overlays).picture(run.frame).grounds.empty());
}

TEST_CASE("visualizer: a comparison draws as ghosts what lies apart", "[render]")
{
    const SmallRun run = small_run();
    const Visualizer visualizer(run.scene, run.bodies, Overlays());
    Frame other = run.frame;
    const Picture same = visualizer.comparison(run.frame, other, "student", "reference");
    CHECK(same.ghost_boxes.empty());
    CHECK(same.rods.empty());
    other.bodies[1].position += Vector3d(0, 1, 0);
    other.bodies[2].orientation = {0, Vector3d(0, 1, 0)}; // half a turn at the same place
    const Picture apart = visualizer.comparison(run.frame, other, "student", "reference");
    CHECK(apart.ghost_boxes.size() == 1);
    CHECK(apart.ghost_balls.size() == 1);
    CHECK(apart.rods.size() == 1);
    CHECK(apart.boxes.size() == 1);
    CHECK(apart.texts.back().text == "2 of 3 bodies lie apart");
}

TEST_CASE("visualizer: a body that flew off or turned to nonsense is survived", "[render]")
{
    SmallRun run = small_run();
    run.frame.bodies[1].position = Vector3d(1e300, 0, 0);
    run.frame.bodies[2].orientation = {0, Vector3d::Zero()};
    run.frame.bodies[2].angular_momentum = Vector3d(1e300, 1e300, 0);
    Overlays overlays;
    overlays.angular_velocity = overlays.angular_momentum = overlays.axes = overlays.labels = true;
    const Picture picture = Visualizer(run.scene, run.bodies, overlays).picture(run.frame);
    CHECK(picture.boxes.empty());
    CHECK(picture.balls.size() == 1);
    for (const Instance& rod : picture.rods)
        CHECK(rod.axes.allFinite());
}

TEST_CASE("visualizer: a record of other bodies is refused", "[render]")
{
    SmallRun run = small_run();
    run.frame.bodies.pop_back();
    const Visualizer visualizer(run.scene, run.bodies, Overlays());
    CHECK_THROWS_WITH(visualizer.picture(run.frame), "small: step 0: expected 3 bodies, found 2");
    run.bodies.pop_back();
    CHECK_THROWS_AS(Visualizer(run.scene, run.bodies, Overlays()), InputError);
}
