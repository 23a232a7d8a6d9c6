// SPDX-License-Identifier: MIT
// Points as files that the learning platforms Canvas and Moodle read. Submissions without a grade
// are left out, since an empty cell would erase a grade that the system has already. If a student
// has several submissions with a grade, all of them are left out, since it is not known which one
// counts.
#pragma once

#include "report/exports/row.hpp"

#include <string>
#include <vector>

namespace rigor {

/// A file of points for a learning platform.
struct GradeFile {
    std::string csv;
    int submissions = 0; ///< how many submissions have a line in `csv`
    int logins = 0;      ///< how many of these have no name from the platform, but a login
};

/// For the import of grades in Canvas: the columns Student, ID, SIS User ID, SIS Login ID and
/// Section, then the assignment; the second line has the points that are possible. If Canvas has
/// named a submission, such as `doejane_12345_678_collision.zip`, the number 12345 tells Canvas
/// which student it is. Names from Moodle are left out, and any other name is taken for the login.
GradeFile canvas_grades(const std::vector<Row>& rows, const std::string& assignment_title);

/// For the upload of a grading worksheet in Moodle: the columns Identifier, Full name, Grade,
/// Maximum Grade, Last modified (grade) and Feedback comments. If Moodle has named a submission,
/// such as `Jane Doe_12345_assignsubmission_file`, it finds the student by the number 12345. Any
/// other submission is left out, since Moodle could take its line for another student's. The date
/// is empty, so Moodle replaces a grade that it already has only if the instructor allows it at the
/// upload.
GradeFile moodle_grades(const std::vector<Row>& rows);

} // namespace rigor
