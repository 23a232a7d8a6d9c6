// SPDX-License-Identifier: MIT
// Scenes from the command line: they are run, stored, drawn and compared.
#include "cli/difference.hpp"
#include "command.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <limits>

namespace rigor::testing {

namespace {

const std::string complete = std::string(RIGOR_SOURCE_DIR) + "/tests/samples/complete";
const std::string half_done = std::string(RIGOR_SOURCE_DIR) + "/tests/samples/half_done";

// Two steps of one ball that moves along x.
Trajectory two_steps()
{
    Trajectory trajectory;
    trajectory.scene.bodies.resize(1);
    trajectory.scene.bodies[0].name = "ball";
    trajectory.bodies.resize(1);
    trajectory.bodies[0].mass = 2;
    for (int step = 0; step < 2; ++step) {
        Frame frame;
        frame.step = step;
        frame.bodies.resize(1);
        frame.bodies[0].position = Vector3d(step, 0, 0);
        frame.bodies[0].velocity = Vector3d(1, 0, 0);
        trajectory.frames.push_back(frame);
    }
    return trajectory;
}

} // namespace

TEST_CASE("scene commands: a stored run can be drawn", "[cli][scene]")
{
    const TemporaryFolder folder;
    const std::string trajectory = folder.path() / "run", frames = folder.path() / "frames";
    const Run stored =
        rigor({"simulate", "a2-inertia/hammer", "--with", complete, "--out", trajectory, "--json"});
    CAPTURE(stored.output);
    REQUIRE(stored.status == 0);
    const Run drawn = rigor({"render", trajectory, "--out", frames, "--size", "64x48"});
    CAPTURE(drawn.output);
    REQUIRE(drawn.status == 0);
    const auto parsed = nlohmann::json::parse(stored.output.substr(stored.output.find('{')));
    long files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(frames))
        files += entry.path().extension() == ".png";
    REQUIRE(files == parsed["frames"]);
    REQUIRE(files > 30);
}

TEST_CASE("scene commands: a stub stops a scene and is named", "[cli][scene]")
{
    const Run stopped = rigor({"simulate", "a2-inertia/hammer", "--with", half_done});
    CAPTURE(stopped.output);
    REQUIRE(stopped.status == 1);
    REQUIRE(stopped.output.find("is not implemented yet") != std::string::npos);
}

TEST_CASE("scene commands: a formula that is not defined is named in one line", "[cli][scene]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", "// nothing yet\n");
    const Run stopped = rigor({"simulate", "a2-inertia/hammer", "--with", folder.path().string()});
    CAPTURE(stopped.output);
    REQUIRE(stopped.status == 2);
    const std::size_t at = stopped.output.find("scene hammer calls A2.");
    REQUIRE(at != std::string::npos);
    const std::string rest = stopped.output.substr(at);
    REQUIRE(rest.find(", which is not defined\n") == rest.find('\n') - 22);
}

TEST_CASE("scene commands: equal runs are said to be equal", "[cli][scene]")
{
    if (!std::filesystem::is_directory(std::string(RIGOR_SOURCE_DIR) + "/reference")) return;
    const Run same = rigor({"compare", "a2-inertia/hammer", "--with", complete});
    CAPTURE(same.output);
    REQUIRE(same.status == 0);
    REQUIRE(same.output.find("is the same as the reference") != std::string::npos);
}

TEST_CASE("scene commands: a difference is told by body and quantity", "[cli][scene]")
{
    const Comparison comparison(two_steps());
    Trajectory other = two_steps();
    REQUIRE(comparison.bodies(other.bodies).empty());
    for (const Frame& frame : other.frames)
        REQUIRE(comparison.frame(frame).empty());

    other.frames[1].bodies[0].position.x() += 1e-6;
    const std::vector<Difference> moved = comparison.frame(other.frames[1]);
    REQUIRE(moved.size() == 1);
    REQUIRE(moved[0].body == "ball");
    REQUIRE(moved[0].quantity == "X [m]");
    REQUIRE(std::abs(moved[0].size - 1e-6) < 1e-12);

    other.frames[1].bodies[0].velocity.y() = std::numeric_limits<double>::quiet_NaN();
    REQUIRE(comparison.frame(other.frames[1]).size() == 2); // NaN always counts as a difference
    other.bodies[0].mass = 3;
    REQUIRE(comparison.bodies(other.bodies).size() == 1);
}

TEST_CASE("scene commands: both signs of a quaternion are one orientation", "[cli][scene]")
{
    const Comparison comparison(two_steps());
    Trajectory other = two_steps();
    other.frames[1].bodies[0].orientation = {-1, Vector3d::Zero()};
    REQUIRE(comparison.frame(other.frames[1]).empty());
    other.frames[1].bodies[0].orientation = {std::cos(0.05), Vector3d(std::sin(0.05), 0, 0)};
    const std::vector<Difference> turned = comparison.frame(other.frames[1]);
    REQUIRE(turned.size() == 1);
    REQUIRE(std::abs(turned[0].size - 0.1) < 1e-12);
}

} // namespace rigor::testing
