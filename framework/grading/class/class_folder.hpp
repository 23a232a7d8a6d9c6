// SPDX-License-Identifier: MIT
// The folder with the results of a class. Its subfolder `.rigor` has the names of the assignment
// and of the submissions, a lock, and a list of the results that no control has confirmed yet. A
// control is a submission whose points are known (control.hpp).
#pragma once

#include "report/exports/row.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The results' folder, locked against other runs while this object lives.
class ClassFolder {
public:
    /// Makes the folder if it is missing.
    /// @param submissions  the names of all submissions of this run
    /// @throws InputError if the folder holds anything but results of the same assignment, has
    ///     results of submissions that this run does not name, is in use by another run, or cannot
    ///     be written. A submission whose folder was removed after a complete run need not be
    ///     named.
    ClassFolder(const std::filesystem::path& folder, const std::string& assignment,
                const std::vector<std::string>& submissions);
    ~ClassFolder();
    ClassFolder(const ClassFolder&) = delete;
    ClassFolder& operator=(const ClassFolder&) = delete;

    const std::filesystem::path& path() const { return folder_; }
    /// The path of a submission's result.json.
    std::filesystem::path result_of(const std::string& submission) const;
    /// The content of result.json; empty if there is no such file, or if it is incomplete.
    std::optional<Row> row_of(const std::string& submission) const;

    /// Whether there are results that no control (a submission whose points are known) has
    /// confirmed. This is so during a run, and after a run that did not reach its end.
    bool has_unconfirmed() const;
    /// Marks results with these fingerprints (hashes of all that they depend on) as unconfirmed, in
    /// addition to those that are unconfirmed already.
    /// @param fingerprints  the fingerprint of each submission's result, by the submission's name
    void begin_unconfirmed(const std::map<std::string, std::string>& fingerprints) const;
    void confirm() const;
    /// Removes the results that no control (a submission whose points are known) has confirmed.
    /// They are recognized by their fingerprints and not by their times, because the clocks of
    /// machines may differ, and jump.
    void drop_unconfirmed() const;

private:
    void lock();
    void check_owner(const std::string& assignment,
                     const std::vector<std::string>& submissions) const;

    std::filesystem::path folder_, state_;
    int descriptor_ = -1;
};

} // namespace rigor
