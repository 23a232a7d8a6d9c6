// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/contact_problem.hpp"

#include <functional>

namespace rigor {

/// A contact holds along one normal for the whole step. Bodies may slide any distance along it, but a
/// body that turns by θ leaves it by up to θ² r/2; and sweeps that ended early leave some speed. Where
/// that makes two bodies overlap anew, by more than 1/200 of the thinner one where they turn, else by
/// 1/20, their island's step is done again in two halves, and so on.
///
/// Only islands of up to 32 bodies that nothing but gravity pulls at.
class Halving {
public:
    /// A step of a world. @return its contacts
    using Step = std::function<std::vector<ContactRecord>(World& world, double time_step)>;

    Halving(const World& world, const std::vector<bool>& pulled, const Neighbourhood& near)
        : world_(world), pulled_(pulled), near_(near)
    {
    }

    /// Does again what needs it. The impulses of those islands are taken out of the problem.
    void step_in_halves(ContactProblem& problem, std::vector<RigidState>& states, const Step& step);

    std::vector<ContactRecord> records; // of what was done again
    std::vector<WarmContact> warm;

private:
    bool overlaps_anew(const ContactProblem& problem, const Island& island,
                       const std::vector<RigidState>& states);

    bool overlaps_anew(const ContactProblem& problem, const ContactPair& pair,
                       const std::vector<RigidState>& states);

    const World& world_;
    const std::vector<bool>& pulled_;
    const Neighbourhood& near_;
    std::vector<Pose> poses_; // after the step, of the pair that is looked at
};

} // namespace rigor
