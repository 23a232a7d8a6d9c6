// SPDX-License-Identifier: MIT
// The fingerprint of a result is a hash of all that it depends on. As long as the fingerprint is
// the same, the submission is not graded again.
#pragma once

#include "grading/build/toolchain.hpp"
#include "grading/intake/found_submissions.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace rigor {

/// What the results of all submissions depend on: a hash of each part, by what the part is called
/// in a message.
using SharedParts = std::map<std::string, std::uint64_t>;

/// The assignment, this program, the tests, the reference and what else is linked into a worker,
/// the files of student/, which stand in for missing files of submissions, the scenes, the seed,
/// the secret, the compiler and the sandbox. The compiler's command is that with which this process
/// began.
SharedParts shared_parts(const Selection& selection, const GradingRun& run);

/// A hash of what a result depends on besides the submission.
std::uint64_t fingerprint_of(const SharedParts& parts);

/// @param before  what `shared_parts` returned before
/// @throws InputError that names the parts that have changed since then, if there are any
void require_unchanged(const SharedParts& before, const Selection& selection,
                       const GradingRun& run);

/// The part of it for a folder with headers and sources, continued from `hash`: the names and
/// contents of all files that a topic's file may include.
std::uint64_t hash_of_sources(const std::filesystem::path& folder, std::uint64_t hash);

/// The part of it for how submissions are compiled and linked, continued from `hash`: the compiler,
/// both commands, and the header that is included before each file.
std::uint64_t hash_of_tools(const Toolchain& tools, std::uint64_t hash);

/// The fingerprint of a submission's result: two hashes of 16 hexadecimal digits, first
/// `all_but_the_submission`, then a hash of this number and of the submission. An archive is hashed
/// as it is, without unpacking it; of one that is larger than the intake accepts, only the size.
std::string fingerprint_of(const Submission& submission, std::uint64_t all_but_the_submission);

/// Whether the result with this fingerprint was made with the same tests, points, seeds and
/// sandbox, whatever its submission: whether the first hash of the fingerprint is
/// `all_but_the_submission`.
bool is_of_the_same_tests(const std::string& fingerprint, std::uint64_t all_but_the_submission);

} // namespace rigor
