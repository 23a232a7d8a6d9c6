// SPDX-License-Identifier: MIT
// Results that another folder has already, in place of grading them.
#pragma once

#include "grading/class/class_folder.hpp"
#include "grading/class/engine.hpp"

namespace rigor {

/// Takes each result from the known folder that has the wanted fingerprint, and lets another engine
/// grade the other submissions.
class KnownResults : public Engine {
public:
    /// @param known  the folder with the results; those that no control has confirmed do not count
    /// @param engine  grades the others; if null, a missing result is an InputError
    KnownResults(const ClassFolder& known, Engine* engine) : known_(known), engine_(engine) {}

    std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                      const OnGraded& on_graded, const OnWait& on_wait) override;

private:
    const ClassFolder& known_;
    Engine* engine_;
};

} // namespace rigor
