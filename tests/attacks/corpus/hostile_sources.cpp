// SPDX-License-Identifier: MIT
#include "corpus.hpp"

#include <algorithm>
#include <fstream>
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

Expectation expectation_of(const fs::path& file)
{
    constexpr std::string_view mark = "// expect: ";
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(mark)) return expectation_in(line.substr(mark.size()));
    throw std::runtime_error(file.string() + ": expected a line that begins with " +
                             std::string(mark));
}

fs::path write_source(const fs::path& source, const fs::path& folder)
{
    const fs::path place = folder / source.stem();
    fs::create_directories(place);
    for (const auto& entry : fs::directory_iterator(source.parent_path()))
        if (entry.path().extension() == ".hpp")
            fs::copy_file(entry.path(), place / entry.path().filename());
    std::ofstream(place / "pipeline.cpp", std::ios::binary) << text_of(source);
    return place;
}

} // namespace

std::vector<HostileSubmission> hostile_sources(const fs::path& submissions)
{
    std::vector<HostileSubmission> all;
    for (const auto& entry : fs::recursive_directory_iterator(submissions)) {
        const fs::path source = entry.path();
        if (source.extension() != ".cpp") continue;
        all.push_back({source.parent_path().filename() / source.stem(), expectation_of(source),
                       [source](const fs::path& folder) { return write_source(source, folder); }});
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return all;
}

} // namespace rigor::corpus
