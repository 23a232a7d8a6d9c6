// SPDX-License-Identifier: MIT
#include "grading/build/includes.hpp"
#include "grading/places.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing::includes_test {

namespace {

// What is said of a file that includes `path`, by a list as compilers write it.
std::string said_of(const std::string& path)
{
    const TemporaryFolder out, own;
    own.write("inertia.cpp", "");
    own.write("mine.hpp", "");
    out.write("inertia.d", "inertia.o: inertia.cpp \\\n " + path + "\n");
    return forbidden_include(out.path() / "inertia.d", own.path());
}

} // namespace

TEST_CASE("includes: a solution may include the contract and its own files", "[build]")
{
    const std::string source = places().source.string();
    CHECK(said_of(source + "/framework/formulas/rotation.hpp").empty());
    CHECK(said_of("mine.hpp").empty());
    CHECK(said_of("./mine.hpp").empty());
    CHECK(said_of("/usr/include/../include/stdio.h").empty());
    CHECK(said_of(source + "/framework/formulas/../../framework/formulas/rotation.hpp").empty());
    CHECK_FALSE(said_of(source + "/CMakeLists.txt").empty());
    CHECK_FALSE(said_of("none.hpp").empty());
}

TEST_CASE("includes: no path tells by a detour which folders there are", "[build]")
{
    const std::string source = places().source.string(), build = places().build.string();
    for (const std::string& folder :
         {source + "/framework/grading", source + "/assignments", build + "/bin"}) {
        CAPTURE(folder);
        CHECK_FALSE(said_of(folder + "/../" + (folder.starts_with(build) ? "../../" : "") +
                            "framework/formulas/rotation.hpp")
                        .empty());
    }
}

} // namespace rigor::testing::includes_test
