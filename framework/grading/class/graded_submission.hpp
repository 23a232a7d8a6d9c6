// SPDX-License-Identifier: MIT
// Grades one submission, from its archive to the files that are written about it.
#pragma once

#include "grading/intake/found_submissions.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace rigor {

/// The files about a submission: their texts by their names. All names are always in the map; an
/// empty text means that this file must not exist.
using ResultFiles = std::map<std::string, std::string>;

/// Reads the files about a submission from its folder.
ResultFiles result_files_in(const std::filesystem::path& folder);

/// Converts the files to a text that can be sent to another process, and back.
std::string packed(const ResultFiles& files);
ResultFiles unpacked(const std::string& text);

/// Takes the files of a submission, builds a worker from them and runs the tests.
/// @param place  a new folder, for the files of the submission
/// @throws std::runtime_error with the reason if a fault of the framework prevents grading, or if
///     somebody removes or changes the files in `place` or the worker meanwhile
ResultFiles graded_submission(const Selection& selection, const Submission& submission,
                              const GradingRun& run, const std::filesystem::path& place,
                              const std::string& fingerprint);

/// The files about a submission that could not be graded because of a fault of the framework. They
/// have no fingerprint, so the next run grades the submission again.
ResultFiles faulty_submission(const Selection& selection, const Submission& submission,
                              const GradingRun& run, const std::string& fault);

} // namespace rigor
