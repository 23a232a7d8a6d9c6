// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "scene/keys/scene_keys.hpp"
#include "support/catch.hpp"

#include <filesystem>
#include <fstream>

namespace scene_error_test {

using namespace rigor;

namespace {

// The one-line message with which a text is refused, without the name of the file.
std::string refusal(const std::string& text)
{
    try {
        parse_scene(text, "s.json");
    } catch (const InputError& error) {
        const std::string message = error.what();
        CHECK(message.find('\n') == std::string::npos);
        REQUIRE(message.rfind("s.json", 0) == 0);
        return message.substr(6);
    }
    return "accepted";
}

// A scene with one ball. Its keys are in line 2, more keys of the body in line 3 and more keys of
// the scene in line 5.
std::string scene_with(const std::string& body, const std::string& scene = "")
{
    return "{\"bodies\": [\n{\"name\": \"ball\", \"shape\": {\"sphere\": {\"radius\": 1}}" +
           (body.empty() ? "" : ",\n" + body) + "}\n]" + (scene.empty() ? "" : ",\n" + scene) + "}";
}

std::string refused_body(const std::string& keys)
{
    return refusal(scene_with(keys));
}

std::string refused_scene(const std::string& keys)
{
    return refusal(scene_with("\"static\": false", keys));
}

} // namespace

TEST_CASE("scene: a text that is no JSON is refused in its line")
{
    CHECK(refusal("") == ":1: expected a JSON object, found an empty text");
    CHECK(refusal(" \n\n") == ":1: expected a JSON object, found an empty text");
    CHECK(refusal("{\n\"end\": 1\n\"time_step\": 2}") == ":3: expected ',' or '}', found a string");
    CHECK(refusal("{\n\"end\": 1,\n}") == ":3: expected a key in quotes, found '}'");
    CHECK(refusal("{\n\"end\": }") == ":2: expected a value, found '}'");
    CHECK(refusal("{\n\"end\": 1\n") == ":2: expected ',' or '}', found end of input");
    CHECK(refusal(scene_with("") + "\n{}") == ":4: expected nothing after the scene, found '{'");
    CHECK(refusal("{\n\"end\": NaN}").rfind(":2: expected valid JSON, found invalid literal", 0) ==
          0);
    CHECK(refusal("{\n\"end").rfind(":2: expected valid JSON, found invalid string", 0) == 0);
    CHECK(refusal("{\n\"description\": \"a\nb\"}").rfind(":2: expected valid JSON", 0) == 0);
    CHECK(refusal("{\"description\": \"\xff\"}").rfind(":1: expected valid JSON", 0) == 0);
    CHECK(refusal("\n" + std::string(1, '\0')) == ":2: expected text, found a zero byte");
    CHECK(refusal(scene_with("") + std::string(1, '\0')) == ":3: expected text, found a zero byte");
}

TEST_CASE("scene: hostile texts are refused before they cost much")
{
    CHECK(refusal(std::string(1'000'000, '[')) ==
          ":1: expected at most 32 levels of brackets, found more");
    CHECK(refusal(std::string(17'000'000, ' ')) ==
          ": expected a scene of at most 16000000 bytes, found 17000000");
    std::string many = "[0";
    for (int i = 0; i < 1'000'000; ++i)
        many += ",0";
    CHECK(refusal(many + "]") == ":1: expected at most 1000000 values, found more");
    std::string keys = "{\"a\": 0";
    for (int i = 0; i < 1000; ++i)
        keys += ",\n\"a" + std::to_string(i) + "\": 0";
    CHECK(refusal(keys + "}") == ":1001: expected at most 1000 keys, found more");
    CHECK(refused_scene("\"end\": 1e999") == ":5: expected a finite number, found 1e999");
    CHECK(refused_scene("\"end\": 1e9, \"time_step\": 1e-9") ==
          ":5: expected at most 10000000 steps, found 1e+18");
    CHECK(refused_body("\"grid\": {\"count\": [1000, 1000, 1],\n\"spacing\": [1, 1, 1]}") ==
          ":3: expected at most 100000 bodies, found 1000000");
    const std::string letters(5000, 'x');
    CHECK(refused_body("\"color\": \"" + letters + "\"").size() < 120);
    CHECK(refused_body("\"" + letters + "\": 1").size() < 300);
    CHECK(refused_body("\"name2\\u001b[31m\": 1").find("\\x1b[31m") != std::string::npos);
}

TEST_CASE("scene: an unknown key is refused with the nearest one")
{
    CHECK(refused_body("\"restituton\": 1") ==
          ":3: unknown key \"restituton\"; did you mean \"restitution\"?");
    CHECK(refused_body("\"Density\": 1") ==
          ":3: unknown key \"Density\"; did you mean \"density\"?");
    CHECK(refused_scene("\"timestep\": 1") ==
          ":5: unknown key \"timestep\"; did you mean \"time_step\"?");
    CHECK(refused_scene("\"camera\": {\"taregt\": [0, 0, 0]}") ==
          ":5: unknown key \"taregt\"; did you mean \"target\"?");
    CHECK(refused_scene("\"camera\": {\"zoom\": 2}") ==
          ":5: unknown key \"zoom\"; expected one of \"position\", \"target\", \"field_of_view\"");
    CHECK(refusal("{\"bodies\": [{\"name\": \"a\",\n\"shape\": {\"sphre\": {}}}]}") ==
          ":2: unknown key \"sphre\"; did you mean \"sphere\"?");
    CHECK(refused_scene("\"integrator\": \"rungekutta\"") ==
          ":5: expected one of \"matrix\", \"linear\", \"exponential\", \"buss\", \"runge_kutta\", "
          "\"gram_schmidt\", \"euler_angles\", \"exact\", found \"rungekutta\"; did you mean "
          "\"runge_kutta\"?");
    CHECK(refused_body("\"mass\": 1, \"mass\": 2") ==
          ":3: expected each key once, found \"mass\" again (first in line 3)");
}

TEST_CASE("scene: a wrong value is refused in its own line")
{
    CHECK(refused_body("\"density\": -3\n") == ":3: expected a density > 0, found -3");
    CHECK(refused_body("\"density\":\n\n-3\n") == ":5: expected a density > 0, found -3");
    CHECK(refused_body("\"density\": 0") == ":3: expected a density > 0, found 0");
    CHECK(refused_body("\"density\": 1e-300") ==
          ":3: expected a density of at least 1e-12, found 1e-300");
    CHECK(refused_body("\"mass\": null") == ":3: expected a mass > 0, found null");
    CHECK(refused_body("\"position\": [1,\n2,\n\"x\"\n]") == ":5: expected a number, found \"x\"");
    CHECK(refused_body("\"position\": [1,\n2,\n1e13\n]") ==
          ":5: expected a number of at most 1e12 in size, found 10000000000000");
    CHECK(refused_body("\"position\": [\n1, 2]") == ":3: expected three numbers, found [1, 2]");
    CHECK(refused_body("\"velocity\": {\"x\": 1}") ==
          ":3: expected three numbers, found {\"x\": …}");
    CHECK(refused_body("\"static\": 0") == ":3: expected true or false, found 0");
    CHECK(refused_body("\"restitution\": 1.5") ==
          ":3: expected a restitution from 0 to 1, found 1.5");
    CHECK(refused_body("\"friction\": -1") == ":3: expected a friction ≥ 0, found -1");
    CHECK(refused_body("\"color\": [0, 0, 2]") ==
          ":3: expected a part of a color from 0 to 1, found 2");
    CHECK(refused_body("\"orientation\": {\"axis\": [0, 0, 1]}")
              .rfind(":3: expected an orientation by \"axis\" and \"degrees\"", 0) == 0);
    CHECK(refused_body("\"orientation\": {\"axis\": [0, 0, 0], \"degrees\": 1}") ==
          ":3: expected an axis of length > 0, found [0, 0, 0]");
    CHECK(refused_body("\"orientation\": {\"quaternion\": [1, 1, 0, 0]}") ==
          ":3: expected a unit quaternion [s, x, y, z], found one of length 1.41421");
    CHECK(refused_body("\"grid\": {\"count\": [1.5, 1, 1], \"spacing\": [1, 1, 1]}") ==
          ":3: expected a count, a whole number from 1 to 100000, found 1.5");
    CHECK(refusal("[1, 2]") == ":1: expected a scene {\"bodies\": […], …}, found [1, 2]");
    CHECK(refusal("3\n") == ":1: expected a scene {\"bodies\": […], …}, found 3");
}

TEST_CASE("scene: a body that cannot be is refused")
{
    CHECK(refused_body("\"mass\": 1,\n\"density\": 2") ==
          ":4: expected either \"mass\" or \"density\", found both");
    CHECK(refused_body("\"inertia\": [1, 1, 1]") ==
          ":3: expected \"mass\" beside \"inertia\", found none");
    CHECK(refused_body("\"mass\": 1,\n\"inertia\": [1, 1, 3]") ==
          ":4: expected an inertia that matter can have (no moment negative or larger than the sum "
          "of the other two), found [1, 1, 3]");
    CHECK(refused_body("\"mass\": 1, \"inertia\": [1, 1, 2]") == "accepted"); // a flat body
    CHECK(refused_body("\"mass\": 1, \"inertia\": [1, 1, 0]") == "accepted"); // a rod
    CHECK(refused_body("\"mass\": 1, \"inertia\": [[1, 2, 0], [0, 1, 0], [0, 0, 1]]") ==
          ":3: expected a symmetric inertia, found rows that differ from the columns");
    CHECK(refused_body("\"static\": true,\n\"velocity\": [1, 0, 0]") ==
          ":4: expected no velocity of a static body, found [1, 0, 0]");
    CHECK(refused_body("\"parts\": []") ==
          ":2: expected either \"shape\" or \"parts\", not both, in the body \"ball\"");
    CHECK(refusal("{\"bodies\": [\n{\"name\": \"a\"}]}") ==
          ":2: expected a \"shape\" or \"parts\" in the body \"a\"");
    CHECK(refusal("{\"bodies\": [\n{\"shape\": {\"plane\": {}}}]}") ==
          ":2: expected a \"name\" in the body, found none");
    CHECK(refusal("{\"bodies\": [\n{\"name\": \"a\", \"shape\": {\"plane\": {}}}]}") ==
          ":2: expected \"static\": true for the plane \"a\", found a body that moves");
    CHECK(refusal("{\"bodies\": [\n{\"name\": \"a\", \"shape\": {\"sphere\": {}}}]}") ==
          ":2: expected a \"radius\" in the sphere, found {}");
    CHECK(refusal(
              "{\"bodies\": [{\"name\": \"a\", \"shape\":\n{\"box\": {\"size\": [1,\n0, 1]}}}]}") ==
          ":3: expected an edge length > 0, found 0");
}

TEST_CASE("scene: settings that contradict each other are refused")
{
    CHECK(refusal("{}") == ":1: expected \"bodies\" or \"solids\" in the scene, found none");
    CHECK(refusal("{\n\"bodies\": []}") == ":2: expected at least one body or solid, found []");
    CHECK(refused_scene("\"time_step\": 0") == ":5: expected a time step > 0, found 0");
    CHECK(refused_scene("\"time_step\": 1,\n\"end\": 0.5") ==
          ":6: expected an end of at least one time step (1 s), found 0.5");
    CHECK(refused_scene("\"time_step\": 0.1,\n\"frames_per_second\": 30") ==
          ":6: expected at most one frame a step (10 per second), found 30");
    CHECK(refused_scene("\"springs\": [{\"body1\": \"bal\",\n\"stiffness\": 1}]") ==
          ":5: expected the name of a body, found \"bal\"; did you mean \"ball\"?");
    CHECK(refused_scene("\"springs\": [\n{\"stiffness\": 1}]") ==
          ":6: expected \"body1\" or \"body2\" in the spring, found {\"stiffness\": …}");
    CHECK(refused_scene("\"springs\": [{\"body1\": \"ball\", \"body2\": \"ball\", \"stiffness\": "
                        "1}]") == ":5: expected two different bodies, found \"ball\"");
    CHECK(refused_scene("\"forces\": [{\"body\": \"ball\", \"force\": [0, 0, 1], \"start\": 1,\n"
                        "\"end\": 1}]") == ":6: expected an end > 1, found 1");
    CHECK(refused_scene("\"camera\":\n{\"position\": [0, 0, 0]}") ==
          ":6: expected a camera whose position is not its target, found {\"position\": …}");
    const std::string body = "{\"name\": \"a\",\n\"shape\": {\"sphere\": {\"radius\": 1}}}";
    CHECK(refusal("{\"bodies\": [" + body + ",\n" + body + "]}") ==
          ":3: expected a name of its own for each body, found \"a\" twice");
}

TEST_CASE("scene: a file that is no file is refused")
{
    const auto load = [](const std::filesystem::path& file) {
        try {
            load_scene(file);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    CHECK(load("/") == "/: expected a scene file, found something else");
    CHECK(load("/dev/zero") == "/dev/zero: expected a scene file, found something else");
    CHECK(load("no/such.json") == "no/such.json: expected a scene file, found nothing");
}

} // namespace scene_error_test
