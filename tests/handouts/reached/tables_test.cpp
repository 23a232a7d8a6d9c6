// SPDX-License-Identifier: MIT
// The tables that a student makes with scenes: the first row, and what the others show.
#include "handouts/reached/scene_runs.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::handouts;

namespace {

const std::vector<std::string> halved_steps = {"0.02", "0.01", "0.005"}; // [s]

} // namespace

TEST_CASE("tables: the energy of the spring pendulum", "[tables]")
{
    std::vector<double> lost;
    for (const char* step : {"0.04", "0.02", "0.01"}) {
        const Run pendulum = run("a1-kinematics/spring_pendulum", {{"time_step", step}});
        lost.push_back(pendulum.first.total_energy() - pendulum.last.total_energy());
    }
    check_says("a1-kinematics", "| 0.04 | " + number(lost[0], "%.5f") + " | |");
    check_says("a1-kinematics", "The next losses are " + number(lost[1], "%.6f") + " and " +
                                    number(lost[2], "%.8f") + ", and the quotients " +
                                    number(lost[0] / lost[1], "%.1f") + " and " +
                                    number(lost[1] / lost[2], "%.1f") + ".");
}

TEST_CASE("tables: the energy of a cube on a grid", "[tables]")
{
    for (const int n : {2, 4, 8, 16})
        for (const char* method : {"\"particles\"", "\"grid\""}) {
            const Run cube = run("a2-inertia/sampled_cube",
                                 {{"mass_by", method}, {"mass_samples", std::to_string(n)}});
            CHECK(std::abs(cube.first.kinetic_energy - (1 - 1.0 / (n * n))) < 1e-12);
        }
    check_says("a2-inertia", "| 2 | 0.75 | 0.25 | |");
    check_says("a2-inertia", "after 0.75 come 0.9375, 0.984375 and 0.99609375,");
    // five standard deviations: the bounds of luck
    for (const int points : {100, 10000, 1000000}) {
        const Run cube = run("a2-inertia/sampled_cube", {{"mass_by", "\"samples\""},
                                                         {"mass_samples", std::to_string(points)}});
        const double deviation = 0.1054 * 12 / 2 / std::sqrt(points);
        CHECK(std::abs(cube.first.kinetic_energy - 1) < 5 * deviation);
        CHECK(cube.first.kinetic_energy != 1);
    }
}

TEST_CASE("tables: the energy of the spinning box", "[tables]")
{
    const auto gained = [](const std::string& integrator) {
        std::vector<double> energies;
        for (const std::string& step : halved_steps) {
            const Run box = run("a3-rotation/spinning_box",
                                {{"integrator", "\"" + integrator + "\""}, {"time_step", step}});
            energies.push_back(box.last.kinetic_energy - box.first.kinetic_energy);
        }
        return energies;
    };
    const auto linear = gained("linear"), exact = gained("exponential"), buss = gained("buss");
    check_says("a3-rotation", "| 0.02 | " + number(linear[0], "%.2f") + " | " +
                                  number(exact[0], "%.2f") + " | " + number(buss[0], "%.4f") +
                                  " |");
    check_says("a3-rotation", number(linear[1], "%.2f") + " and " + number(linear[2], "%.2f") +
                                  " J for `\"linear\"` and " + number(exact[1], "%.2f") + " and " +
                                  number(exact[2], "%.2f") + " J for `\"exponential\"`");
    check_says("a3-rotation", "has " + number(buss[1], "%.5f") + " and " + number(buss[2], "%.6f") +
                                  " J. It falls by " + number(buss[0] / buss[1], "%.1f") + " and " +
                                  number(buss[1] / buss[2], "%.1f") + ",");
}

TEST_CASE("tables: blocks that slide", "[tables]")
{
    const auto height = [](const std::string& integrator, const std::string& step) {
        const std::string both = step + ", \"integrator\": \"" + integrator + "\"";
        return run("a4-collision/incline_sliding", {{"time_step", both}}).last.potential_energy;
    };
    std::vector<double> linear, exact;
    for (const std::string& step : halved_steps) {
        linear.push_back(height("linear", step));
        exact.push_back(height("runge_kutta", step));
        CHECK(std::abs(exact.back() - exact.front()) < 1e-6);
    }
    check_says("a4-collision",
               "| 0.02 | " + number(linear[0], "%.2f") + " | " + number(exact[0], "%.2f") + " |");
    // the differences of the numbers that are printed
    const auto printed = [](double value) { return std::stod(number(value, "%.2f")); };
    const auto too_low = [&](double value) {
        return number(printed(exact[0]) - printed(value), "%.2f");
    };
    check_says("a4-collision", "has " + number(linear[1], "%.2f") + " and " +
                                   number(linear[2], "%.2f") + " J. It is too low by " +
                                   too_low(linear[0]) + ", " + too_low(linear[1]) + " and " +
                                   too_low(linear[2]) + " J");
}

TEST_CASE("tables: a stack by three methods", "[tables]")
{
    const Run at_once = run("a5-contact/stack", {{"contact", "\"simultaneous\""}});
    CHECK(at_once.deepest < 1e-12);
    CHECK(at_once.last.kinetic_energy < 1e-12);
    const Run shocks = run("a5-contact/stack", {{"contact", "\"shock_propagation\""}});
    CHECK(shocks.deepest < 1e-6);
    CHECK(shocks.last.kinetic_energy < 0.1);
    const Run single = run("a5-contact/stack", {{"contact", "\"one_at_a_time\""}});
    CHECK(single.deepest > 0.01);
    CHECK(single.last.potential_energy < 0.2 * single.first.potential_energy);
    check_says("a5-contact", "| `\"simultaneous\"` | 0, to rounding | 0, to rounding |");
}

TEST_CASE("tables: the stretched bar", "[tables]")
{
    std::vector<double> strains;
    for (const char* drag : {"16", "8", "4"})
        strains.push_back(run("a6-plasticity/stretched_bar", {{"drag", drag}})
                              .last.solids[0]
                              .largest_plastic_strain);
    check_says("a6-plasticity", "| 16 | " + number(strains[0], "%.5f") + " | " +
                                    number(strains[0] - 0.08, "%.5f") + " |");
    check_says("a6-plasticity", "The next rows have " + number(strains[1], "%.5f") + " and " +
                                    number(strains[2], "%.5f") + ":");
}

TEST_CASE("tables: the stress below a notch", "[tables]")
{
    const std::vector<std::pair<std::string, std::string>> meshes = {
        {"[11, 12, 1]", "[1, 4]"}, {"[22, 24, 1]", "[2, 8]"}, {"[33, 36, 1]", "[3, 12]"}};
    std::vector<std::string> stresses;
    for (const auto& [cells, notch] : meshes) {
        const Run plate =
            run("a7-fracture/notched_plate",
                {{"end", "0.1"}, {"cells", cells}, {"notch", notch}, {"strength", "1e11"}});
        stresses.push_back(number(plate.last.solids[0].largest_stress, "%.0f"));
    }
    check_says("a7-fracture", "| `[11, 12, 1]` | `[1, 4]` | " + stresses[0] + " |");
    check_says("a7-fracture",
               "It shows " + stresses[0] + ", " + stresses[1] + " and " + stresses[2] + " Pa");
}
