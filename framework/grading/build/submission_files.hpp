// SPDX-License-Identifier: MIT
// The files of a submission, copied to a private folder of the grader. Only regular files are
// taken, with limits for their number and size; nothing is opened that could make the grader wait,
// such as a pipe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rigor {

struct SubmissionFiles {
    std::vector<std::string> topics;            // the topics whose file was copied
    std::map<std::string, std::string> refused; // by topic, why its file was not copied
    /// The headers and other sources that were not copied, sorted, each with the reason.
    std::vector<std::string> left_out;
    /// A hash of the names of all copied files, and of the contents of those that are no topic's.
    std::uint64_t hash = 0;
    std::string digest; // SHA-256 of names and contents of all copied files
};

/// Copies the topics' files of a folder, and its headers and other sources that these may include,
/// to the folder `into`, which has nothing else afterwards. Links are not followed.
SubmissionFiles take_files(const std::filesystem::path& folder, const std::filesystem::path& into);

/// Whether a file has the ending of a header or a source, so that the file of a topic may include
/// it.
bool is_code(const std::filesystem::path& file);

/// A hash of `text` that continues from `start` (FNV-1a of Fowler, Noll and Vo). It gives private
/// folders their names and shows what is out of date. It is not cryptographic, but a student who
/// constructs a collision can only spoil the build of his own folder.
inline std::uint64_t hash_of(std::string_view text, std::uint64_t start = 0xcbf29ce484222325)
{
    for (const char c : text)
        start = (start ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return start;
}

} // namespace rigor
