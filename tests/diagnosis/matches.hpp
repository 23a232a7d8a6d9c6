// SPDX-License-Identifier: MIT
// Answers that are the right ones for changed arguments.
#pragma once

#include "diagnosis/evidence.hpp"
#include "diagnosis/relations.hpp"
#include "diagnosis/transforms.hpp"

#include <map>

namespace rigor::diagnosis {

using Cases = std::vector<const Case*>;

/// The right answers to changed arguments, each asked for once.
class ChangedAnswers {
public:
    explicit ChangedAnswers(const Evidence& evidence)
        : evidence_(evidence), transforms_(transforms(evidence.arguments))
    {
    }

    const std::vector<Transform>& all() const { return transforms_; }

    /// The right answer to the changed arguments of a case; nothing if there is none.
    const std::optional<Value>& right_for(std::size_t transform, const Case& c);

    /// Whether all answers at these places are the right ones to the changed arguments.
    bool explains(std::size_t transform, const Cases& cases, const std::vector<int>& roles);

    /// The same for two changes, one after the other.
    bool explains(std::size_t first, std::size_t second, const Cases& cases,
                  const std::vector<int>& roles);

    /// The relation of the answers to the right ones for the changed arguments, at each of these
    /// places, where the relation is the same or the answer is already right. Empty without one.
    std::string related(std::size_t transform, const Cases& cases, const std::vector<int>& roles);

private:
    bool is_right(const std::optional<Value>& right, const Case& c, const std::vector<int>& roles);

    const Evidence& evidence_;
    std::vector<Transform> transforms_;
    std::map<std::pair<std::size_t, const Case*>, std::optional<Value>> known_;
};

} // namespace rigor::diagnosis
