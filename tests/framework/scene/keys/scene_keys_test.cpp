// SPDX-License-Identifier: MIT
#include "scene/keys/scene_keys.hpp"
#include "support/close.hpp"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

using namespace rigor;
using namespace rigor::testing;

namespace {

std::vector<std::filesystem::path> shipped_scenes()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(RIGOR_SOURCE_DIR "/assignments"))
        if (entry.path().extension() == ".json" &&
            entry.path().parent_path().filename() == "scenes")
            files.push_back(entry.path());
    return files;
}

std::string handbook()
{
    std::ifstream stream(RIGOR_SOURCE_DIR "/assignments/scenes.md");
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    REQUIRE(!text.empty());
    return text;
}

Scene scene_of(const std::string& keys)
{
    return parse_scene("{\"bodies\": [{\"name\": \"b\", \"shape\": {\"box\": {\"size\": [1, 2, 3]}}"
                       ", " +
                           keys + "}]}",
                       "folder/some.scene.json");
}

} // namespace

TEST_CASE("scene: what is written is what is read")
{
    const std::string text = R"({
        "description": "A ball on a spring.", "gravity": [0, -1, 0], "time_step": 0.02, "end": 4,
        "frames_per_second": 25, "integrator": "buss",
        "bodies": [
            {"name": "ball", "shape": {"sphere": {"radius": 2}}, "mass": 3, "inertia": [1, 1.5, 2],
             "position": [1, 2, 3], "velocity": [4, 5, 6], "angular_velocity": [7, 8, 9],
             "restitution": 1, "friction": 0, "color": [0, 0.5, 1]},
            {"name": "wall", "static": true, "parts": [
                {"shape": {"plane": {}}, "position": [0, 1, 0]},
                {"shape": {"box": {"size": [1, 2, 3]}}, "density": 7}]}],
        "springs": [{"body2": "ball", "point1": [0, 9, 0], "point2": [0, 2, 0], "stiffness": 10,
                     "damping": 0.5, "rest_length": 1}],
        "forces": [{"body": "ball", "force": [1, 0, 0], "point": [0, 0, 2], "start": 1, "end": 2}],
        "camera": {"position": [1, 1, 1], "target": [0, 1, 0], "field_of_view": 50},
        "draw": {"axes": true, "contacts": true, "grid": false}})";
    const Scene scene = parse_scene(text, "folder/some.scene.json");
    CHECK(scene.name == "some.scene");
    CHECK(scene.text == text);
    CHECK(scene.description == "A ball on a spring.");
    CHECK(scene.settings.gravity == Vector3d(0, -1, 0));
    CHECK(scene.time_step == 0.02);
    CHECK(scene.end == 4);
    CHECK(scene.frames_per_second == 25);
    CHECK(scene.settings.integrator == Integrator::buss);
    REQUIRE(scene.bodies.size() == 2);
    const BodyDescription& ball = scene.bodies[0];
    CHECK(std::get<Sphere>(ball.parts.at(0).shape).radius == 2);
    CHECK(ball.mass.value() == 3);
    CHECK(ball.inertia.value() == Matrix3d(Vector3d(1, 1.5, 2).asDiagonal()));
    CHECK(ball.position == Vector3d(1, 2, 3));
    CHECK(ball.velocity == Vector3d(4, 5, 6));
    CHECK(ball.angular_velocity == Vector3d(7, 8, 9));
    CHECK(ball.material.restitution == 1);
    CHECK(ball.material.friction == 0);
    CHECK(ball.color.value() == Vector3d(0, 0.5, 1));
    const BodyDescription& wall = scene.bodies[1];
    CHECK(wall.is_static);
    CHECK(std::holds_alternative<Plane>(wall.parts.at(0).shape));
    CHECK(wall.parts[0].position == Vector3d(0, 1, 0));
    CHECK(wall.parts[0].density == 1000);
    CHECK(wall.parts.at(1).density == 7);
    const Spring& spring = scene.springs.at(0);
    CHECK(spring.body1 == -1);
    CHECK(spring.body2 == 0);
    CHECK(spring.point1 == Vector3d(0, 9, 0));
    CHECK(spring.point2 == Vector3d(0, 2, 0));
    CHECK(spring.stiffness == 10);
    CHECK(spring.damping == 0.5);
    CHECK(spring.rest_length == 1);
    const AppliedForce& force = scene.forces.at(0);
    CHECK(force.body == 0);
    CHECK(force.force == Vector3d(1, 0, 0));
    CHECK(force.point == Vector3d(0, 0, 2));
    CHECK(force.start == 1);
    CHECK(force.end == 2);
    CHECK(scene.camera.position == Vector3d(1, 1, 1));
    CHECK(scene.camera.target == Vector3d(0, 1, 0));
    CHECK(scene.camera.field_of_view == 50);
    CHECK(scene.overlays.axes);
    CHECK(scene.overlays.contacts);
    CHECK(!scene.overlays.grid);
    CHECK(!scene.overlays.labels);
}

TEST_CASE("scene: three ways to write an orientation agree")
{
    const double c = std::sqrt(0.5);
    const Quaternion expected{c, {0, 0, c}};
    for (const char* way :
         {R"({"axis": [0, 0, 5], "degrees": 90})", R"({"euler_degrees": [0, 0, 90]})",
          R"({"quaternion": [0.7071067811865476, 0, 0, 0.7071067811865476]})"}) {
        const Scene scene = scene_of(std::string("\"orientation\": ") + way);
        CHECK_THAT(scene.bodies[0].orientation, IsClose(expected, Rounding(4, 1)));
    }
    // The rotation about x comes first: roll takes y to z, then yaw does not change z.
    const Scene scene = scene_of(R"("orientation": {"euler_degrees": [90, 0, 90]})");
    const Quaternion& q = scene.bodies[0].orientation;
    const Eigen::Quaterniond rotation(q.s, q.v.x(), q.v.y(), q.v.z());
    CHECK_THAT(Vector3d(rotation * Vector3d::UnitY()), IsClose(Vector3d(0, 0, 1), Rounding(4, 1)));
}

TEST_CASE("scene: a mass alone is spread evenly over the volume")
{
    const Scene scene = scene_of("\"mass\": 12");
    CHECK(!scene.bodies[0].mass);
    CHECK_THAT(scene.bodies[0].parts[0].density, IsClose(2.0, Rounding(2)));
}

TEST_CASE("scene: a grid makes named bodies in order and from its seed alone")
{
    const auto grid = [](const std::string& more) {
        return scene_of(
                   R"("position": [10, 20, 30], "grid": {"count": [2, 3, 4], "spacing": [1, 2, 3])" +
                   more + "}")
            .bodies;
    };
    const std::vector<BodyDescription> plain = grid("");
    REQUIRE(plain.size() == 24);
    CHECK(plain.front().name == "b 1");
    CHECK(plain.back().name == "b 24");
    CHECK(plain[0].position == Vector3d(10, 20, 30));
    CHECK(plain[1].position == Vector3d(11, 20, 30));
    CHECK(plain[2].position == Vector3d(10, 20, 33));
    CHECK(plain[8].position == Vector3d(10, 22, 30));
    CHECK(plain.back().position == Vector3d(11, 24, 39));

    const std::string random = R"(, "jitter": 0.1, "jitter_degrees": 20, "seed": )";
    const std::vector<BodyDescription> one = grid(random + "5"), same = grid(random + "5"),
                                       other = grid(random + "6");
    double largest = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK(one[i].position == same[i].position);
        CHECK(one[i].orientation.v == same[i].orientation.v);
        CHECK(one[i].position != other[i].position);
        const Vector3d shift = one[i].position - plain[i].position;
        largest = std::max(largest, shift.cwiseAbs().maxCoeff());
    }
    CHECK(largest <= 0.1);
    CHECK(largest > 0.08);
}

TEST_CASE("scene: frames lie at the steps nearest to their times")
{
    Scene scene;
    scene.time_step = 0.01;
    scene.end = 2;
    scene.frames_per_second = 30;
    CHECK(step_count(scene) == 200);
    CHECK(frame_count(scene) == 61);
    CHECK(frame_step(scene, 0) == 0);
    CHECK(frame_step(scene, 1) == 3);
    CHECK(frame_step(scene, 2) == 7);
    CHECK(frame_step(scene, 60) == 200);
    scene.end = 0.999;
    CHECK(step_count(scene) == 100);
    CHECK(frame_count(scene) == 31);
    scene.time_step = scene.end = 1;
    scene.frames_per_second = 1;
    CHECK(frame_count(scene) == 2);
}

TEST_CASE("scene: long steps take one frame a step")
{
    const Scene scene = parse_scene(R"({"time_step": 0.1, "bodies": [
        {"name": "a", "shape": {"sphere": {"radius": 1}}}]})",
                                    "a");
    CHECK_THAT(scene.frames_per_second, IsClose(10.0, Rounding(1)));
    CHECK(frame_count(scene) == step_count(scene) + 1);
}

TEST_CASE("scene: every shipped scene loads and is worth a film")
{
    const std::vector<std::filesystem::path> files = shipped_scenes();
    REQUIRE(files.size() >= 16);
    for (const std::filesystem::path& file : files) {
        CAPTURE(file.string());
        const Scene scene = load_scene(file);
        CHECK(scene.name == file.stem());
        CHECK(!scene.description.empty());
        CHECK(frame_count(scene) >= 61);
        CHECK(scene.end <= 6);
    }
}

TEST_CASE("scene: the handbook's examples are what they say")
{
    const std::string text = handbook();
    const auto block = [&](std::size_t from) {
        const std::size_t start = text.find("```json\n", from) + 8;
        return text.substr(start, text.find("```", start) - start);
    };
    const Scene scene = parse_scene(block(0), "handbook");
    CHECK(scene.bodies.size() == 3);
    const std::string hammer = block(text.find("Example of a compound body"));
    CHECK(parse_scene("{\"bodies\": [" + hammer + "]}", "hammer").bodies.at(0).parts.size() == 2);
    const Scene bar = parse_scene(block(text.find("## Deformable solids")), "bar");
    CHECK(bar.solids.at(0).handles.size() == 2);
}

TEST_CASE("scene: the handbook explains every key in the words of the table")
{
    const std::string text = handbook();
    const std::vector<KeyMeaning> language = scene_language();
    REQUIRE(language.size() > 50);
    std::string generated;
    for (std::size_t i = 0; i < language.size(); ++i) {
        const KeyMeaning& row = language[i];
        if (i == 0 || language[i - 1].object != row.object)
            generated += "\n### " + std::string(row.object) + "\n\n| key | meaning |\n|---|---|\n";
        generated += "| `" + std::string(row.key) + "` | " + std::string(row.meaning) + " |\n";
    }
    INFO("assignments/scenes.md must hold these tables:\n" << generated);
    std::istringstream lines(generated);
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        REQUIRE(text.find(line + "\n") != std::string::npos);
    }
}
