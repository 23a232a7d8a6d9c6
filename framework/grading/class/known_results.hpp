// SPDX-License-Identifier: MIT
// Takes results from another results folder, instead of grading the submissions again.
#pragma once

#include "grading/class/class_folder.hpp"
#include "grading/class/engine.hpp"

namespace rigor {

/// Takes those results of a known folder that are up to date: their fingerprints are equal to those
/// in `ClassWork::fingerprints`. Another engine grades the other submissions.
class KnownResults : public Engine {
public:
    /// @param known  the folder with the results; if a control has not confirmed some of them yet
    ///     (class_folder.hpp), no result is taken
    /// @param engine  grades the other submissions. With nullptr, `grade` throws InputError if
    ///     there are other submissions.
    KnownResults(const ClassFolder& known, Engine* engine) : known_(known), engine_(engine) {}

    std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                      const OnGraded& on_graded, const OnWait& on_wait) override;

private:
    const ClassFolder& known_;
    Engine* engine_;
};

} // namespace rigor
