// SPDX-License-Identifier: MIT
// Scenes of deformable solids from the command line.
#include "cli/difference.hpp"
#include "command.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

namespace rigor::testing::solid_commands_test {

namespace {

// A bar that falls for three steps.
std::string falling_bar(const std::string& material)
{
    return R"({"time_step": 0.01, "end": 0.03, "solids": [{"name": "bar",
        "mesh": {"bar": {"size": [2, 1, 1], "cells": [2, 1, 1]}}, )" +
           material + "}]}";
}

// Two steps of one tetrahedron.
Trajectory two_steps()
{
    const auto topology = std::make_shared<SolidTopology>();
    topology->nodes = 4;
    topology->pieces = 1;
    topology->elements = {{0, 1, 2, 3}};
    Trajectory trajectory;
    trajectory.scene.solids.resize(1);
    trajectory.scene.solids[0].name = "bar";
    for (int step = 0; step < 2; ++step) {
        Frame frame;
        frame.step = step;
        SolidFrame& solid = frame.solids.emplace_back();
        solid.topology = topology;
        solid.positions.assign(4, Vector3d(1, 0, 0));
        solid.velocities.assign(4, Vector3d(0, 2, 0));
        solid.stresses = {100};
        solid.plastic_strains = {0.5F};
        trajectory.frames.push_back(frame);
    }
    return trajectory;
}

} // namespace

TEST_CASE("solid commands: simulate tells what became of each solid", "[cli][scene]")
{
    const TemporaryFolder folder;
    const std::filesystem::path scene = folder.write("bar.json", falling_bar("\"density\": 500"));
    const Run run = rigor({"simulate", scene.string(), "--with", "reference", "--json"});
    CAPTURE(run.output);
    REQUIRE(run.status == 0);
    const nlohmann::json result = nlohmann::json::parse(run.output.substr(run.output.find('{')));
    const nlohmann::json& bar = result.at("solids").at(0);
    CHECK(bar.at("name") == "bar");
    CHECK(std::abs(bar.at("last").at("mass").get<double>() - 1000) < 1e-9);
    CHECK(bar.at("mass_drift") == 0);
    CHECK(bar.at("last").at("pieces") == 1);
    CHECK(bar.at("last").at("elements") == 10);
    CHECK(bar.at("last").at("kinetic_energy") > 0);
    CHECK(bar.at("largest_plastic_strain") == 0);
    CHECK(result.at("counters").at("deformable_substeps") > 0);

    const Run stats = rigor({"simulate", scene.string(), "--with", "reference", "--stats"});
    CHECK(stats.output.find("solid \"bar\"") != std::string::npos);
    CHECK(stats.output.find(result.at("hash").get<std::string>()) != std::string::npos);
}

TEST_CASE("solid commands: a material that cannot be is one line and status 2", "[cli][scene]")
{
    const TemporaryFolder folder;
    const std::filesystem::path scene =
        folder.write("bar.json", falling_bar("\n\"poisson_ratio\": 0.5"));
    const Run run = rigor({"simulate", scene.string(), "--with", "reference"});
    CHECK(run.status == 2);
    CHECK(run.output.find("bar.json:3: expected a Poisson's ratio between -1 and 0.5") !=
          std::string::npos);
}

TEST_CASE("solid commands: where two runs of a solid part is told by node and element",
          "[cli][scene]")
{
    const Trajectory expected = two_steps();
    const Comparison comparison(expected);
    Frame frame = expected.frames[1];
    CHECK(comparison.frame(frame).empty());
    SolidFrame& solid = frame.solids[0];
    solid.positions[2].x() += 1e-10; // as large as rounding errors that have grown
    solid.stresses[0] *= 1 + 1e-7F;
    CHECK(comparison.frame(frame).empty());

    solid.positions[3].x() += 1e-6;
    solid.stresses[0] = 101;
    const std::vector<Difference> found = comparison.frame(frame);
    REQUIRE(found.size() == 2);
    CHECK(found[0].body == "bar, node 3");
    CHECK(found[0].quantity == "x [m]");
    CHECK(found[1].body == "bar, element 0");
    CHECK(found[1].quantity == "σ [Pa]");

    auto cracked = std::make_shared<SolidTopology>(*solid.topology);
    cracked->elements.push_back({0, 1, 2, 3});
    cracked->pieces = 2;
    solid.topology = cracked;
    const std::vector<Difference> other = comparison.frame(frame);
    REQUIRE(other.size() == 1);
    CHECK(other[0].quantity == "mesh, cracked otherwise");
    CHECK(other[0].actual == "4 nodes, 2 elements in 2 pieces");
}

} // namespace rigor::testing::solid_commands_test
