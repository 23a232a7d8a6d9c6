// SPDX-License-Identifier: MIT
// Slips that a student makes without meaning harm, as sources: each is put into a file of a
// solution that is right otherwise.
#pragma once

#include <string>
#include <vector>

namespace rigor::slips {

/// What a slip may cost.
enum class Cost { nothing, its_task, its_file };

/// The place of a slip in a topic: a formula, and another one of the same file, which must keep its
/// points unless the slip spoils the whole file.
struct Place {
    std::string topic;
    std::string result, name, parameters; // the declaration of the formula
    std::string neighbour;                // empty if the topic has one formula only
};

struct Slip {
    std::string name;
    Cost cost;
    /// The text that stands for the formula's definition; empty for a slip of the whole file.
    std::string (*definition)(const Place& place);
    /// What a slip of the whole file makes of the right text.
    std::string (*file)(const std::string& right) = nullptr;
};

/// A place in each topic.
const std::vector<Place>& places_of_slips();

/// The call of the right definition, under its other name, with the formula's own parameters:
/// `right_conjugate(q)`.
std::string right_call(const Place& place);
const std::vector<Slip>& all_slips();

} // namespace rigor::slips
