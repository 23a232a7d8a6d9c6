// SPDX-License-Identifier: MIT
#include "grading/intake/downloaded_name.hpp"

#include "support/catch.hpp"

namespace rigor::testing::downloaded_name_test {

TEST_CASE("downloaded name: student and file of what Canvas and Moodle name", "[intake]")
{
    const auto student = [](const std::string& name) {
        const auto found = downloaded_name(name);
        return found ? found->student() + " | " + found->file : "none";
    };
    REQUIRE(student("doejane_11_501_collision.cpp") == "doejane_11 | collision.cpp");
    REQUIRE(student("doejane_LATE_11_501_my_file.zip") == "doejane_11 | my_file.zip");
    REQUIRE(student("Jane Doe_15_assignsubmission_file_a.cpp") == "Jane Doe_15 | a.cpp");
    REQUIRE(student("doejane_11_501_") == "doejane_11 | ");
    for (const char* name :
         {"Jane Doe_15_assignsubmission_file_", "Jane Doe_15_assignsubmission_file",
          "Jane Doe_15_assignsubmission_onlinetext"})
        REQUIRE(student(name) == "Jane Doe_15 | ");
    for (const char* name : {"collision.cpp", "jane_doe.cpp", "a_1_b.cpp", "group_2024_11",
                             "_1_2_a.cpp", "Jane Doe_15_assignsubmission_"})
        REQUIRE(student(name) == "none");
}

TEST_CASE("downloaded name: the student's name for a file names no other student", "[intake]")
{
    const auto student = [](const std::string& name) { return downloaded_name(name)->student(); };
    const std::string like_moodle = "x_42_assignsubmission_file_a.cpp";
    CHECK(student("doejane_11_501_" + like_moodle) == "doejane_11");
    CHECK(student("doejane_LATE_11_501_" + like_moodle) == "doejane_11");
    CHECK(student("doejane_11_501_eve_42_99_a.cpp") == "doejane_11");
    CHECK(downloaded_name("doejane_11_501_" + like_moodle)->system == LearningSystem::canvas);
}

TEST_CASE("downloaded name: with Moodle's words in it twice it is none from Moodle", "[intake]")
{
    for (const char* name :
         {"Jane Doe_15_assignsubmission_file_x_42_assignsubmission_file_a.cpp", // name of a file
          "Jane Doe_15_assignsubmission_onlinetext_x_42_assignsubmission_file",
          "x_42_assignsubmission_file_ Jane Doe_15_assignsubmission_file", // a student
          "x_42_assignsubmission_file_15_assignsubmission_file"})
        CHECK_FALSE(downloaded_name(name));
}

TEST_CASE("downloaded name: a number that Canvas adds is no part of the file's name", "[intake]")
{
    REQUIRE(is_called("collision.cpp", "collision.cpp"));
    REQUIRE(is_called("collision-12.cpp", "collision.cpp"));
    for (const char* name : {"collision-.cpp", "collision-x.cpp", "collision1.cpp", "collision.hpp",
                             "my_collision.cpp", "", "collision"})
        REQUIRE_FALSE(is_called(name, "collision.cpp"));
}

} // namespace rigor::testing::downloaded_name_test
