// SPDX-License-Identifier: MIT
#include "handouts/reached/scene_runs.hpp"

#include "handouts/handouts.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/reader.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <regex>

namespace rigor::handouts {

namespace {

std::string with(std::string text, const std::vector<Change>& changes)
{
    for (const auto& [key, value] : changes) {
        const std::regex old("\"" + key + "\": (\\[[^\\]]*\\]|[^,}\\]]*)");
        const std::string now = "\"" + key + "\": " + value;
        REQUIRE(std::regex_search(text, old));
        text = std::regex_replace(text, old, now, std::regex_constants::format_first_only);
    }
    return text;
}

} // namespace

Run run(const std::string& name, const std::vector<Change>& changes)
{
    const std::size_t slash = name.find('/');
    const std::string text = content(assignments() / name.substr(0, slash) / "scenes" /
                                     (name.substr(slash + 1) + ".json"));
    const Scene scene = parse_scene(with(text, changes), name);
    Run result;
    std::optional<Statistics> statistics;
    bool is_first = true;
    TrajectoryReader::Handlers handlers;
    handlers.on_start = [&](const Scene& started, const std::vector<RecordedBody>& bodies) {
        statistics.emplace(started, bodies);
    };
    handlers.on_frame = [&](const Frame& frame) {
        result.last = statistics->of(frame);
        if (is_first) result.first = result.last;
        is_first = false;
        result.deepest = std::max(result.deepest, result.last.deepest_penetration);
    };
    handlers.on_end = [](const Counters&) {};
    TrajectoryReader reader(handlers);
    run_scene(scene, Record::frames, [&](std::span<const std::byte> bytes) { reader.feed(bytes); });
    REQUIRE(reader.complete());
    return result;
}

std::string number(double value, const char* format)
{
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

void check_says(const std::string& name, const std::string& words)
{
    const std::string text =
        std::regex_replace(content(assignments() / name / "README.md"), std::regex(R"(\s+)"), " ");
    CAPTURE(words);
    CHECK(text.find(words) != std::string::npos);
}

} // namespace rigor::handouts
