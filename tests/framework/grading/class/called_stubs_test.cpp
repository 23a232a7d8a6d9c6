// SPDX-License-Identifier: MIT
#include "grading/class/called_stubs.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing::called_stubs_test {

using Topics = std::vector<std::string>;

TEST_CASE("called stubs: the files that a right solution of a topic needs beside its own",
          "[class]")
{
    REQUIRE(called_stubs(RIGOR_SOURCE_DIR, "pipeline").empty());
    REQUIRE(called_stubs(RIGOR_SOURCE_DIR, "collision") == Topics{"kinematics"});
    REQUIRE(called_stubs(RIGOR_SOURCE_DIR, "contact") == Topics{"kinematics", "collision"});
}

TEST_CASE("called stubs: a solved file in student is none, and no reference no message", "[class]")
{
    const TemporaryFolder tree;
    const std::string stub = "throw NotImplemented(\"kinematics::point_velocity\");";
    tree.write("student/kinematics.cpp", stub);
    REQUIRE(called_stubs(tree.path(), "collision").empty());
    tree.write("reference/collision.cpp", "#include \"formulas/collision.hpp\"\n");
    tree.write("reference/collision_more.hpp", "#include \"formulas/kinematics.hpp\"\n");
    REQUIRE(called_stubs(tree.path(), "collision") == Topics{"kinematics"});
    tree.write("student/kinematics.cpp", "return v;");
    REQUIRE(called_stubs(tree.path(), "collision").empty());
}

} // namespace rigor::testing::called_stubs_test
