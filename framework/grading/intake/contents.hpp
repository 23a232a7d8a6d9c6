// SPDX-License-Identifier: MIT
// The files of a submission as names and texts, before it is decided which of them are needed.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace rigor {

/// The most that a submission may hold. A solution has a few files of about 10 kB; build folders
/// and pictures beside it should not matter.
struct IntakeLimits {
    std::size_t entries = 10'000;                       // number of files and folders
    std::size_t archive_bytes = std::size_t{64} << 20;  // size of an archive [bytes]
    std::size_t unpacked_bytes = std::size_t{64} << 20; // size of what is unpacked [bytes]
    std::size_t unpacked_ratio = 200;                   // unpacked bytes / bytes of the archive
    /// Up to this unpacked size, any ratio is allowed [bytes].
    std::size_t bytes_at_any_ratio = std::size_t{1} << 20;
    std::size_t source_bytes = std::size_t{16} << 20; // total size of all sources [bytes]
};

/// Files by their names, such as "alice/collision.cpp". Only sources have a text.
class Contents {
public:
    explicit Contents(const IntakeLimits& limits) : limits_(limits) {}

    /// Counts a folder or a file. @param given  its name, as the submission has it
    /// @return the name without "./", with "/" in place of "\"; empty for the submission's own
    ///     folder
    /// @throws Refused if the name leads out of the submission or cannot be shown, or if there are
    ///     too many files and folders
    std::string add_name(std::string_view given);
    /// @throws Refused if there is another file of this name, if the file cannot be written to a
    ///     disk together with the others, or if all sources together are too large
    void add_source(const std::string& name, std::string text);
    void add_other(const std::string& name);

    const std::map<std::string, std::string>& sources() const { return sources_; }
    /// Names of all other files.
    const std::set<std::string>& others() const { return others_; }

private:
    void require_new(const std::string& name) const;
    void require_place(const std::string& name) const;

    IntakeLimits limits_;
    std::size_t entries_ = 0, source_bytes_ = 0;
    std::map<std::string, std::string> sources_;
    std::set<std::string> others_;
};

/// @throws Refused because all sources together are larger than the limit
[[noreturn]] void refuse_too_many_sources(const IntakeLimits& limits);

/// Whether a file is a C++ source or header.
bool is_source(std::string_view name);

/// Whether a program made this file or folder and not the student: its name or that of a folder
/// above it begins with a dot, or is `__MACOSX`.
bool is_by_product(std::string_view name);

} // namespace rigor
