// SPDX-License-Identifier: MIT
// What an implementation finds beside itself in its worker: no name that it could call or replace,
// and no faster form of a formula.
#include "support/catch.hpp"

#include <cstdio>
#include <memory>
#include <string>

namespace {

// The names in an object that is linked into workers, one line each, as nm lists them.
std::string names_of(const std::string& object, const std::string& options = "")
{
    const std::string command =
        "/usr/bin/nm --defined-only " + options + " " RIGOR_BINARY_DIR "/framework/" + object;
    const std::unique_ptr<FILE, int (*)(FILE*)> list(popen(command.c_str(), "r"), &pclose);
    REQUIRE(list);
    std::string text;
    char block[4096];
    while (const std::size_t n = fread(block, 1, sizeof block, list.get()))
        text.append(block, n);
    return text;
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("worker: the only name of ours that an implementation can see is main")
{
    for (const char* object : {"students_worker.o", "reference_worker.o"})
        REQUIRE(names_of(object, "--extern-only --format=just-symbols") == "main\n");
}

TEST_CASE("worker: the engine beside a student's formulas has no faster form of any")
{
    const std::string with = names_of("reference_worker.o"),
                      without = names_of("students_worker.o");
    REQUIRE(contains(with, "OptimisedSweeps")); // otherwise the name has changed
    REQUIRE_FALSE(contains(without, "OptimisedSweeps"));
    REQUIRE(contains(without, "collision_law_sweeps")); // the engine is there
}
