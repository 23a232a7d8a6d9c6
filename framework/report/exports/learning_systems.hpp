// SPDX-License-Identifier: MIT
// Points as files that learning management systems read. Submissions without a grade are left out,
// since an empty cell would erase a grade that is there. So are all of a student who has several
// with a grade: which one counts is not known.
#pragma once

#include "report/exports/row.hpp"

#include <string>
#include <vector>

namespace rigor {

/// For the import of grades in Canvas: the columns Student, ID, SIS User ID, SIS Login ID and
/// Section, then the assignment; the second line has the points that are possible. Canvas finds a
/// submission that it named itself, `doejane_12345_678_collision.zip`, by the number 12345. Any
/// other name is taken for the login.
std::string canvas_csv(const std::vector<Row>& rows, const std::string& assignment_title);

/// For the upload of a grading worksheet in Moodle: the columns Identifier, Full name, Grade,
/// Maximum Grade, Last modified (grade) and Feedback comments. Moodle finds a submission that it
/// named itself, `Jane Doe_12345_assignsubmission_file`, by the number 12345. Any other is left
/// out, since its line could be taken for that of somebody else. The date is empty, so Moodle
/// replaces a grade that it already has only if the instructor allows it at the upload.
std::string moodle_csv(const std::vector<Row>& rows);

} // namespace rigor
