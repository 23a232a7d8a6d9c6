// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rigor {

namespace {

int positive(const std::string& option, const std::string& text)
{
    std::size_t used = 0;
    int value = 0;
    try {
        value = std::stoi(text, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used != text.size() || value < 1)
        throw std::invalid_argument(option + ": expected a number > 0, found '" + text + "'");
    return value;
}

const std::string& known_part(const std::string& text)
{
    for (const char* part : {"cubes", "settled", "threads", "nonconvex"})
        if (text == part) return text;
    throw std::invalid_argument("--part: expected cubes, settled, threads or nonconvex, found '" +
                                text + "'");
}

int side_of(const std::string& text)
{
    const int cubes = positive("--cubes", text);
    const int side = static_cast<int>(std::lround(std::cbrt(cubes)));
    if (side * side * side != cubes)
        throw std::invalid_argument("--cubes: expected a cube such as 1000, found '" + text + "'");
    return side;
}

} // namespace

bool PileChoice::does(const std::string& part) const
{
    return parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end();
}

bool PileChoice::wants(const std::string& engine) const
{
    return engines.empty() || std::find(engines.begin(), engines.end(), engine) != engines.end();
}

PileChoice pile_choice(int argc, char** argv)
{
    PileChoice choice;
    std::vector<int> sides;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--json") {
            choice.json = true;
            continue;
        }
        if (i + 1 == argc) throw std::invalid_argument("expected a value after '" + option + "'");
        const std::string value = argv[++i];
        if (option == "--cubes")
            sides.push_back(side_of(value));
        else if (option == "--engine")
            choice.engines.push_back(value);
        else if (option == "--part")
            choice.parts.push_back(known_part(value));
        else if (option == "--rounds")
            choice.rounds = positive(option, value);
        else if (option == "--steps")
            choice.steps = positive(option, value);
        else
            throw std::invalid_argument(
                "expected --cubes, --engine, --part, --rounds, --steps or --json, found '" +
                option + "'");
    }
    if (!sides.empty()) choice.sides = sides;
    return choice;
}

} // namespace rigor
