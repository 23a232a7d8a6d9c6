// SPDX-License-Identifier: MIT
// The limits that the boxes "What our engine does differently" name are those of the engine. A row
// has the words of a handout, and the line of the source that they are true with.
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <regex>

using namespace rigor::handouts;

namespace {

struct Limit {
    const char *label, *words, *source, *line;
};

constexpr Limit limits[] = {
    {"A3", "at most 1000.", "rigid/motion/free_flight.cpp", "most_substeps = 1000;"},
    {"A3", "`\"matrix\"` takes none", "rigid/motion/free_flight.cpp",
     "if (integrator == Integrator::matrix) return 1;"},
    {"A3", "except by `\"linear\"`", "rigid/motion/free_flight.cpp",
     "if (body.is_isotropic && integrator != Integrator::linear) return 1;"},
    {"A3", "by another integrator than `\"linear\"` it makes $q$ unit again",
     "rigid/motion/free_flight.cpp",
     "if (integrator != Integrator::matrix && integrator != Integrator::linear)"},
    {"A4", "at least nine tenths", "rigid/contact/collisions.cpp", "equally_deep = 0.9;"},
    {"A4", "at most four impulses", "rigid/contact/collisions.cpp", "most_rounds = 4;"},
    {"A4", "in each of ten rounds", "rigid/contact/collisions.cpp", "most_sweeps = 10;"},
    {"A4", "a fifth of the overlap", "rigid/contact/position_correction.cpp",
     "corrected_fraction = 0.2;"},
    {"A4", "a group of at most 32", "rigid/detection/overlap_depth.hpp", "most_refined = 32;"},
    {"A4", "ten times in all", "rigid/step/substeps/divisions.hpp", "most_divisions = 10;"},
    {"A4", "for half a second", "rigid/step/sleep.cpp", "needed_rest = 0.5;"},
    {"A5", "get 10 iterations", "rigid/contact/solvers/one_at_a_time.cpp", "iterations = 10;"},
    {"A5", "with 40, 160, … iterations", "rigid/contact/solvers/one_at_a_time.cpp", "growth = 4,"},
    {"A5", "more than 4000 contacts", "rigid/contact/solvers/one_at_a_time.cpp",
     "most_visits = 4000;"},
    {"A5", "no more than 2 %", "rigid/contact/solvers/one_at_a_time.cpp", "enough_share = 0.02;"},
    {"A5", "points up by more than 0.3", "rigid/contact/load_estimate.hpp", "least_lift = 0.3;"},
    {"A6", "at most 20 rounds", "deformable/motion/implicit_motion.cpp", "most_flow_rounds = 20;"},
    {"A6", "is kept below 0.8", "deformable/elasticity/flow.cpp", "most = 0.8;"},
    {"A7", "at most 64 cracks", "deformable/fracture/fracture.hpp", "most_cracks = 64;"},
    {"A7", "than a fifth of the flattest", "deformable/fracture/fracture.cpp",
     "least_share = 0.2;"},
    {"A7", "at most three cracks", "deformable/fracture/fracture.cpp", "most_in_element = 3;"},
};

// The box of a handout as one line, without the marks at the beginnings of its lines.
std::string box_of(const Handout& handout)
{
    const std::size_t start = handout.text.find("> **What our engine does differently.**");
    if (start == std::string::npos) return "";
    const std::string box = handout.text.substr(start, handout.text.find("\n\n", start) - start);
    return std::regex_replace(box, std::regex(R"(\n>? *)"), " ");
}

} // namespace

TEST_CASE("boxes: each handout has one that is as long as a paragraph", "[boxes]")
{
    for (const Handout& handout : all_handouts()) {
        if (!has_scenes(handout)) continue; // the engine has no part in it
        CAPTURE(handout.label);
        CHECK(box_of(handout).size() > 200);
    }
}

TEST_CASE("boxes: the limits that they name are those of the engine", "[boxes]")
{
    const std::vector<Handout> handouts = all_handouts();
    const auto framework = assignments().parent_path() / "framework";
    for (const Limit& limit : limits) {
        CAPTURE(limit.label, limit.words, limit.line);
        const auto handout = std::find_if(handouts.begin(), handouts.end(),
                                          [&](const Handout& h) { return h.label == limit.label; });
        REQUIRE(handout != handouts.end());
        CHECK(box_of(*handout).find(limit.words) != std::string::npos);
        CHECK(content(framework / limit.source).find(limit.line) != std::string::npos);
    }
}
