// SPDX-License-Identifier: MIT
// Each formula of the contract is called in some shipped scene, except those that only tests call.
#include "formulas/table.hpp"
#include "handouts/coverage.hpp"
#include "handouts/handouts.hpp"
#include "handouts/reached/called.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <regex>
#include <set>

using namespace rigor;
using namespace rigor::handouts;

namespace {

// The formulas of an assignment without scenes are called by tests alone: the warm-up, and the
// tests of A8, which are no formulas of the engine. Any other formula needs a scene.
bool only_in_tests(const Formula& formula)
{
    return formula.topic == "pipeline" || formula.topic == "validation";
}

// Long enough for every method to be at work [s].
constexpr double longest = 1;

std::vector<std::filesystem::path> scenes_of(const Handout& handout)
{
    std::vector<std::filesystem::path> files;
    const auto folder = assignments() / handout.name / "scenes";
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// The formulas that a scene calls until this time [s].
std::set<std::string> called_in(const std::filesystem::path& file, double end)
{
    forget_calls();
    Scene scene = load_scene(file);
    scene.end = std::min(scene.end, end);
    scene.frames_per_second = std::min(scene.frames_per_second, 1 / scene.time_step);
    run_scene(scene, Record::frames, [](const auto&...) {});
    return called_formulas();
}

// For each handout and each of its scenes, such as "stack", the formulas that the scene calls. The
// scenes run once.
const std::map<std::string, std::map<std::string, std::set<std::string>>>& called()
{
    static const auto all = [] {
        std::map<std::string, std::map<std::string, std::set<std::string>>> tags;
        for (const Handout& handout : all_handouts()) {
            tags[handout.label]; // also where there are no scenes
            for (const auto& file : scenes_of(handout))
                tags[handout.label][file.stem().string()] = called_in(file, longest);
        }
        return tags;
    }();
    return all;
}

// The tags in the sentence "The scenes also call …" of a handout, which may be "A3.5 to A3.9".
std::set<std::string> said_of_scenes(const Handout& handout)
{
    std::set<std::string> tags;
    const std::string text = std::regex_replace(handout.text, std::regex("\n(?!\n)"), " ");
    const std::size_t start = text.find("scenes also call");
    if (start == std::string::npos) return tags;
    const std::string sentence = text.substr(start, text.find("Count", start) - start);
    static const std::regex tag(R"((A\d\.)(\d+)( to A\d\.(\d+))?)");
    for (std::sregex_iterator i(sentence.begin(), sentence.end(), tag), end; i != end; ++i) {
        const int first = std::stoi((*i)[2]);
        const int last = (*i)[4].matched ? std::stoi((*i)[4]) : first;
        for (int number = first; number <= last; ++number)
            tags.insert((*i)[1].str() + std::to_string(number));
    }
    return tags;
}

std::string joined(const std::set<std::string>& tags)
{
    std::string text;
    for (const std::string& tag : tags)
        text += tag + " ";
    return text;
}

} // namespace

TEST_CASE("scenes: each formula is reached by a shipped scene", "[reached]")
{
    std::set<std::string> reached;
    for (const auto& [label, scenes] : called())
        for (const auto& [scene, tags] : scenes)
            reached.insert(tags.begin(), tags.end());
    for (const Formula& formula : formulas) {
        const std::string tag(formula.tag);
        INFO(tag << " " << formula.name << " is called by "
                 << (reached.count(tag) ? "a scene" : "no scene"));
        CHECK((reached.count(tag) == 1) != only_in_tests(formula));
    }
}

TEST_CASE("scenes: a handout names the formulas of others that its scenes call", "[reached]")
{
    for (const Handout& handout : all_handouts()) {
        std::set<std::string> others;
        for (const auto& [scene, tags] : called().at(handout.label))
            for (const std::string& tag : tags)
                if (tag.substr(0, tag.find('.')) != handout.label) others.insert(tag);
        INFO(handout.label << " must say: " << joined(others));
        CHECK(joined(said_of_scenes(handout)) == joined(others));
    }
}

TEST_CASE("coverage: a row's scene calls the formula of its task", "[reached]")
{
    for (const CoverageRow& row : coverage()) {
        const bool has_formula =
            std::any_of(std::begin(formulas), std::end(formulas),
                        [&](const Formula& formula) { return formula.tag == row.tag; });
        const std::string label = "A" + row.assignment.substr(1, 1); // "A4" of "a4-collision"
        INFO(row.statement << ": " << row.assignment << "/" << row.scene << " and " << row.tag);
        std::set<std::string> tags = called().at(label).at(row.scene);
        if (has_formula && tags.count(row.tag) == 0) { // it may come later
            const auto file = assignments() / row.assignment / "scenes" / (row.scene + ".json");
            tags = called_in(file, std::numeric_limits<double>::infinity());
        }
        if (has_formula)
            CHECK(tags.count(row.tag) == 1);
        else // a task about scenes is about those of its own assignment
            CHECK(row.tag.substr(0, row.tag.find('.')) == label);
    }
}
