// SPDX-License-Identifier: MIT
#include "corpus.hpp"

#include "formulas/table.hpp"
#include "slips/solutions.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>

namespace rigor::corpus {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Reads "0 crashed|failed: a text".
Expectation expectation_in(const std::string& line)
{
    Expectation expected;
    std::istringstream words(line);
    std::string statuses;
    words >> expected.points;
    if (!(words >> statuses)) throw std::runtime_error("expected points and a status: " + line);
    if (statuses.ends_with(':')) {
        statuses.pop_back();
        std::getline(words >> std::ws, expected.text);
    }
    std::istringstream parts(statuses);
    for (std::string status; std::getline(parts, status, '|');)
        expected.statuses.push_back(status);
    return expected;
}

// The rest of the line that begins with these words; empty if there is none.
std::string line_of(const fs::path& file, std::string_view words)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(words)) return line.substr(words.size());
    return "";
}

std::string topic_of(const fs::path& file)
{
    const std::string topic = line_of(file, "// topic: ");
    return topic.empty() ? "pipeline" : topic;
}

HostileSubmission described(const fs::path& file)
{
    const std::string expected = line_of(file, "// expect: ");
    if (expected.empty())
        throw std::runtime_error(file.string() + ": expected a line that begins with // expect: ");
    HostileSubmission hostile;
    hostile.name = file.parent_path().filename() / file.stem();
    hostile.expected = expectation_in(expected);
    hostile.topic = topic_of(file);
    std::istringstream tasks(line_of(file, "// tasks: "));
    for (std::string tag; tasks >> tag;)
        hostile.tasks.push_back(tag);
    return hostile;
}

std::vector<fs::path> sources_in(const fs::path& submissions)
{
    std::vector<fs::path> sources;
    for (const auto& entry : fs::recursive_directory_iterator(submissions))
        if (entry.path().extension() == ".cpp") sources.push_back(entry.path());
    std::sort(sources.begin(), sources.end());
    return sources;
}

// Writes a file with this text, and the headers that go with the source.
fs::path write_source(const fs::path& source, const std::string& topic, const std::string& text,
                      const fs::path& folder)
{
    const fs::path place = folder / source.stem();
    fs::create_directories(place);
    for (const auto& entry : fs::directory_iterator(source.parent_path()))
        if (entry.path().extension() == ".hpp")
            fs::copy_file(entry.path(), place / entry.path().filename());
    std::ofstream(place / (topic + ".cpp"), std::ios::binary) << text;
    return place;
}

std::string tag_of(const std::string& formula)
{
    const auto row = std::find_if(std::begin(formulas), std::end(formulas),
                                  [&](const Formula& each) { return each.name == formula; });
    if (row == std::end(formulas)) throw std::logic_error("no formula " + formula);
    return std::string(row->tag);
}

// A definition of the formula that attacks, by way of the formula of A0, and then calls the right
// one.
std::string attacking(const slips::Place& place, const std::string& attack)
{
    return attack + "\nnamespace rigor {\n" + place.result + " " + place.name + "(" +
           place.parameters +
           ")\n{\n    static volatile double energy;\n"
           "    energy = kinetic_energy(1, {1, 2, 3}, Matrix3d::Identity(), {3, 2, 1});\n"
           "    return " +
           slips::right_call(place) + ";\n}\n}\n";
}

HostileSubmission elsewhere(const fs::path& source, const slips::Place& place)
{
    HostileSubmission hostile = described(source);
    hostile.name += "@" + place.topic;
    hostile.topic = place.topic;
    hostile.tasks = {tag_of(place.name), tag_of(place.neighbour)};
    // Where the attack has no formula of A0, that of student/ is called.
    for (const char* status : {"not_implemented", "passed"})
        hostile.expected.statuses.emplace_back(status);
    hostile.expected.text.clear(); // the message may be about another line
    hostile.write = [source, &place](const fs::path& folder) {
        const fs::path written =
            write_source(source, place.topic,
                         slips::solution_beside(place, attacking(place, text_of(source))), folder);
        slips::copy_headers(written);
        return written;
    };
    return hostile;
}

} // namespace

std::vector<HostileSubmission> hostile_sources(const fs::path& submissions)
{
    std::vector<HostileSubmission> all;
    for (const fs::path& source : sources_in(submissions)) {
        all.push_back(described(source));
        all.back().write = [source](const fs::path& folder) {
            const std::string topic = topic_of(source), beside = line_of(source, "// beside: ");
            if (beside.empty()) return write_source(source, topic, text_of(source), folder);
            const std::string text = slips::whole_solution_beside(topic, beside, text_of(source));
            const fs::path written = write_source(source, topic, text, folder);
            slips::copy_headers(written);
            return written;
        };
    }
    return all;
}

std::vector<HostileSubmission> in_other_topics(const fs::path& submissions)
{
    std::vector<HostileSubmission> all;
    for (const fs::path& source : sources_in(submissions))
        for (const slips::Place& place : slips::places_of_slips())
            if (topic_of(source) == "pipeline" && place.topic != "pipeline")
                all.push_back(elsewhere(source, place));
    return all;
}

std::vector<HostileSubmission> drawn_of_each_kind(const std::vector<HostileSubmission>& all,
                                                  unsigned seed)
{
    std::mt19937 random(seed);
    std::map<std::string, std::vector<const HostileSubmission*>> kinds;
    for (const HostileSubmission& each : all)
        kinds[each.name.substr(0, each.name.find('/'))].push_back(&each);
    std::vector<HostileSubmission> drawn;
    for (const auto& [kind, some] : kinds)
        drawn.push_back(*some[random() % some.size()]);
    return drawn;
}

} // namespace rigor::corpus
