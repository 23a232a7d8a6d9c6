// SPDX-License-Identifier: MIT
// Keys that choose the formula which a scene runs on, for the mass, the spin, the point of a force,
// yielding, and a solid that moves as a rigid body.
#include "deformable/step/step.hpp"
#include "errors/input_error.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace method_keys_test {

using namespace rigor;

namespace {

std::string with_body(const std::string& keys)
{
    return "{\"gravity\": [0, 0, 0], \"end\": 0.1, \"bodies\": [\n{\"name\": \"b\", " + keys +
           "}]}";
}

std::string with_solid(const std::string& keys)
{
    return "{\"time_step\": 0.01, \"end\": 1, \"gravity\": [0, -10, 0], \"solids\": [\n"
           "{\"name\": \"s\", \"mesh\": {\"bar\": {\"size\": [1, 2, 0.5], \"cells\": [2, 4, "
           "1]}}, " +
           keys + "}]}";
}

std::string refusal(const std::string& text)
{
    try {
        parse_scene(text, "s");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

const std::string cube = R"("shape": {"box": {"size": [1, 1, 1]}}, "density": 12)";

RigidBody body_of(const std::string& keys)
{
    return make_world(parse_scene(with_body(keys), "s")).bodies.at(0);
}

// The solid after one second.
Deformable moved(const std::string& keys)
{
    const Scene scene = parse_scene(with_solid(keys), "s");
    DeformableWorld world = make_deformable_world(scene);
    for (int i = 0; i < 100; ++i)
        step(world, scene.time_step);
    return world.solids.at(0);
}

double length_of(const Deformable& solid)
{
    double longest = 0;
    for (const Vector3d& x : solid.positions)
        for (const Vector3d& y : solid.positions)
            longest = std::max(longest, (x - y).norm());
    return longest;
}

} // namespace

TEST_CASE("mass_by: each method approximates the same cube")
{
    const RigidBody exact = body_of(cube);
    CHECK(std::abs(exact.inertia(0, 0) - 2) < 1e-14);
    for (const std::string method : {"particles", "grid"})
        for (const int n : {1, 4, 20}) {
            const RigidBody body = body_of(cube + ", \"mass_by\": \"" + method +
                                           "\", \"mass_samples\": " + std::to_string(n));
            CAPTURE(method, n);
            CHECK(std::abs(body.mass - 12) < 1e-12);
            CHECK(std::abs(body.inertia(0, 0) - 2 * (1 - 1.0 / (n * n))) < 1e-12);
        }
    const RigidBody box = body_of(cube + R"(, "mass_by": "bounding_box")");
    CHECK((box.inertia - exact.inertia).norm() < 1e-13);
    // The limit is five standard deviations of the mean of 10 000 samples.
    const RigidBody random = body_of(cube + R"(, "mass_by": "samples")");
    CHECK(std::abs(random.inertia(0, 0) - 2) < 5 * 0.1054 * 12 / 100);
}

TEST_CASE("mass_by: the center of mass of a compound body is where the method finds it")
{
    const RigidBody hammer = body_of(R"("parts": [
        {"shape": {"box": {"size": [1, 1, 1]}}},
        {"shape": {"box": {"size": [1, 1, 1]}}, "position": [0, 1, 0], "density": 3000}],
        "mass_by": "grid", "mass_samples": 2)");
    CHECK(std::abs(hammer.mass - 4000) < 1e-9);
    CHECK((hammer.state.position - Vector3d(0, 0.75, 0)).norm() < 1e-14);
    CHECK((hammer.parts.at(0).position + Vector3d(0, 0.75, 0)).norm() < 1e-14);
}

TEST_CASE("mass_by: a thin rod has a moment of exactly 0")
{
    const RigidBody rod = body_of(R"("shape": {"cylinder": {"radius": 0.1, "height": 2}}, "mass": 3,
                   "mass_by": "thin_rod", "angular_velocity": [0, 5, 2])");
    CHECK(std::abs(rod.mass - 3) < 1e-14);
    CHECK(rod.inertia(1, 1) == 0);
    CHECK(rod.inverse.inverse_inertia(1, 1) == 0);
    CHECK(rod.state.angular_momentum.y() == 0);
}

TEST_CASE("filmed: the spin is that of the sine formula")
{
    const RigidBody body = body_of(cube + R"(, "filmed":
        {"after": 0.4, "orientation": {"axis": [0, 0, 1], "degrees": 114.59155902616465}})");
    const double w = std::sin(2.0) / 0.4;
    CHECK((body.state.angular_momentum - Vector3d(0, 0, 2 * w)).norm() < 1e-14);
}

TEST_CASE("world_point: a force acts at this point of a turned body")
{
    const std::string text = R"({"bodies": [{"name": "b", "position": [1, 2, 3],
        "orientation": {"axis": [0, 0, 1], "degrees": 90},
        "shape": {"box": {"size": [1, 2, 3]}}}],
        "forces": [{"body": "b", "force": [1, 0, 0], "world_point": [1, 3, 3]},
                   {"body": "b", "force": [1, 0, 0], "point": [1, 0, 0]}]})";
    const World world = make_world(parse_scene(text, "s"));
    CHECK((world.forces.at(0).point - world.forces.at(1).point).norm() < 1e-15);
}

TEST_CASE("velocity_modes: a solid falls and turns as a rigid body does")
{
    const Deformable solid = moved(
        R"("integrator": "velocity_modes", "velocity": [1, 5, 0], "angular_velocity": [0, 0, 3])");
    Vector3d center = Vector3d::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < solid.positions.size(); ++i) {
        center += solid.masses[i] * solid.positions[i];
        mass += solid.masses[i];
    }
    CHECK((center / mass - Vector3d(1, 5 - 10.0 / 2, 0)).norm() < 1e-12);
    // |x| grows at most by the factor √(1 + ¼ |ω|⁴ h⁴) in each step.
    const double rest = std::sqrt(1 + 4 + 0.25);
    CHECK(length_of(solid) >= rest);
    CHECK(length_of(solid) < rest * (1 + 100.0 / 8 * 81 * 1e-8));
}

TEST_CASE("matrix: a solid grows across its axis and not along it")
{
    const Deformable solid = moved(R"("integrator": "matrix", "angular_velocity": [0, 0, 3])");
    const double growth = std::pow(1 + 9 * 1e-4, 50);
    CHECK(std::abs(length_of(solid) - std::sqrt(5 * growth * growth + 0.25)) < 1e-12);
}

TEST_CASE("yield_by: all formulas let a solid flow alike")
{
    std::vector<double> strains;
    for (const char* formula : {"strain", "yield_strain", "deviator", "frobenius", "principal"}) {
        const Deformable solid = moved(std::string(R"("youngs_modulus": 1e5, "yield_stress": 2e3,
            "damping": 0.01, "yield_by": ")") +
                                       formula + R"(", "handles": [
            {"region": {"from": [-1, -1, -1], "to": [1, -1, 1]}},
            {"region": {"from": [-1, 1, -1], "to": [1, 1, 1]},
             "path": [{"time": 0.5, "displacement": [0.2, 0.2, 0]}]}])");
        double sum = 0;
        for (const Matrix3d& strain : solid.plastic_strains)
            sum += strain.norm();
        strains.push_back(sum);
    }
    CHECK(strains[0] > 0.01);
    for (const double sum : strains)
        CHECK(std::abs(sum - strains[0]) < 1e-6 * strains[0]);
}

TEST_CASE("flow: in the step or after it")
{
    CHECK(moved(R"("yield_stress": 2e3)").flow_time == FlowTime::in_step);
    CHECK(moved(R"("yield_stress": 2e3, "flow": "after_step")").flow_time == FlowTime::after_step);
}

TEST_CASE("methods: what cannot be is refused in its own line")
{
    const auto body = [](const std::string& keys) {
        return refusal(with_body(cube + ",\n" + keys));
    };
    CHECK(body(R"("mass_by": "sample")") ==
          "s:3: expected one of \"exact\", \"particles\", \"grid\", \"samples\", \"bounding_box\", "
          "\"thin_rod\", found \"sample\"; did you mean \"samples\"?");
    CHECK(body(R"("mass_samples": 3)") ==
          "s:3: expected \"mass_by\" with \"particles\", \"grid\" or \"samples\" beside "
          "\"mass_samples\", found none of these");
    CHECK(body("\"mass_by\": \"grid\",\n\"mass_samples\": 101")
              .rfind("s:4: expected a number of samples", 0) == 0);
    CHECK(body(R"("mass_by": "thin_rod")") ==
          "s:3: expected one cylinder for \"thin_rod\", found another shape");
    CHECK(body(R"("static": true, "mass_by": "grid")") ==
          "s:3: expected no \"mass_by\" of a static body, found one");
    CHECK(refusal(with_body(R"("shape": {"cross": {"length": 1, "width": 0.3}},
"mass_by": "grid")")) ==
          "s:3: expected \"mass_by\" only for shapes that are no mesh, found a mesh");
    const std::string film = R"("filmed": {"after": 1, "orientation": {"axis": [1, 0, 0],
        "degrees": 9}})";
    CHECK(body(film + R"(, "angular_velocity": [0, 0, 1])") ==
          "s:3: expected either \"angular_velocity\" or \"filmed\", found both");
    CHECK(body(film + R"(, "static": true)") ==
          "s:3: expected no \"filmed\" of a static body, found one");
    CHECK(body(R"("filmed": {"after": 1})").rfind("s:3: expected an \"orientation\"", 0) == 0);
    CHECK(body(R"("filmed": {"after": 0})").rfind("s:3: expected a time > 0", 0) == 0);
    CHECK(refusal(with_solid("\"integrator\": \"matrix\",\n\"yield_stress\": 1")) ==
          "s:3: expected no \"yield_stress\" or \"strength\" of the solid \"s\" that moves as a "
          "rigid body, found one");
}

} // namespace method_keys_test
