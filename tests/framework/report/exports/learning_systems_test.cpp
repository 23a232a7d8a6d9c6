// SPDX-License-Identifier: MIT
#include "report/exports/learning_systems.hpp"

#include "rows.hpp"
#include "support/catch.hpp"

namespace rigor::testing {

// Canvas takes the first line for a header if its columns are Student, ID, SIS User ID, SIS Login
// ID and Section, in this order; the line after it may have the points that are possible. It finds
// a student by the ID first and then by the login. (Instructor Guide, "How do I import grades in
// the Gradebook?")
TEST_CASE("canvas: columns and lines as its import wants them", "[report]")
{
    REQUIRE(canvas_csv(some_class(), "Inertia, second part") ==
            "Student,ID,SIS User ID,SIS Login ID,Section,\"Inertia, second part\"\r\n"
            "Points Possible,,,,,5\r\n"
            "\"Doe, Jane_17_assignsubmission_file\",,,\"Doe, Jane_17_assignsubmission_file\",,5\r\n"
            "doejohn,4711,,,,2\r\n"
            "zed,,,zed,,0\r\n");
}

// Moodle wants the columns Identifier, Grade and Last modified (grade), and takes the number after
// "Participant ". Other columns are found by their names. (Moodle Docs, "Offline grading
// worksheet")
TEST_CASE("moodle: only submissions that it named itself are in its worksheet", "[report]")
{
    REQUIRE(moodle_csv(some_class()) ==
            "Identifier,Full name,Grade,Maximum Grade,Last modified (grade),Feedback comments\r\n"
            "Participant 17,\"Doe, Jane\",5,5,,\r\n");
    std::vector<Row> rows = {row_of("Jane Doe_12345_assignsubmission_file_", "graded", 2, 0)};
    REQUIRE(
        moodle_csv(rows).ends_with("Participant 12345,Jane Doe,2,5,,A2.2 not_implemented 0/3\r\n"));
}

} // namespace rigor::testing
