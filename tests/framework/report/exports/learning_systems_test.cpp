// SPDX-License-Identifier: MIT
#include "report/exports/learning_systems.hpp"

#include "rows.hpp"
#include "support/catch.hpp"

namespace rigor::testing {

// Canvas takes the first line for a header if its columns are Student, ID, SIS User ID, SIS Login
// ID and Section, in this order; the line after it may have the points that are possible. It finds
// a student by the ID first, then by the login, and then by the name. (`gradebook_importer.rb`,
// which Canvas publishes)
TEST_CASE("canvas: columns and lines as its import wants them", "[report]")
{
    REQUIRE(canvas_grades(some_class(), "Inertia, second part").csv ==
            "Student,ID,SIS User ID,SIS Login ID,Section,\"Inertia, second part\"\r\n"
            "Points Possible,,,,,5\r\n"
            "doejohn,4711,,,,2\r\n"
            "zed,,,zed,,0\r\n");
    REQUIRE(canvas_grades(some_class(), "A").submissions == 2);
}

// Moodle wants the columns Identifier, Grade and Last modified (grade), and takes the number after
// "Participant ". Other columns are found by their names, or passed over.
// (`mod/assign/feedback/offline/importgradeslib.php`, which Moodle publishes)
TEST_CASE("moodle: only submissions that it named itself are in its worksheet", "[report]")
{
    REQUIRE(moodle_grades(some_class()).csv ==
            "Identifier,Full name,Grade,Maximum Grade,Last modified (grade),Feedback comments\r\n"
            "Participant 17,\"Doe, Jane\",5,5,,\r\n");
    REQUIRE(moodle_grades(some_class()).submissions == 1);
    std::vector<Row> rows = {row_of("Jane Doe_12345_assignsubmission_file_", "graded", 2, 0)};
    const std::string line = "Participant 12345,Jane Doe,2,5,,A2.2 not implemented 0/3\r\n";
    REQUIRE(moodle_grades(rows).csv.ends_with(line));
    // If submissions are downloaded without folders, Moodle adds the name of the file.
    rows[0].submission = "Jane Doe_12345_assignsubmission_file_my_inertia";
    REQUIRE(moodle_grades(rows).csv.ends_with(line));
}

TEST_CASE("learning systems: two graded submissions of a student are in no file", "[report]")
{
    std::vector<Row> rows = {row_of("doejane_11_501_a4", "graded", 2, 3),
                             row_of("doejane_LATE_11_617_a4-1", "graded", 2, 0),
                             row_of("roejim_12_502_report", "rejected", 0, 0),
                             row_of("roejim_12_503_inertia", "graded", 2, 0)};
    REQUIRE(canvas_grades(rows, "A").csv == "Student,ID,SIS User ID,SIS Login ID,Section,A\r\n"
                                            "Points Possible,,,,,5\r\n"
                                            "roejim,12,,,,2\r\n");
    REQUIRE(canvas_grades(rows, "A").submissions == 1);
    rows = {row_of("Jane Doe_11_assignsubmission_file_a", "graded", 2, 3),
            row_of("Jane Doe_11_assignsubmission_file_b", "compile_error", 0, 0),
            row_of("Jim Roe_12_assignsubmission_file_b", "graded", 2, 3)};
    REQUIRE(
        moodle_grades(rows).csv.ends_with("Feedback comments\r\nParticipant 12,Jim Roe,5,5,,\r\n"));
}

} // namespace rigor::testing
