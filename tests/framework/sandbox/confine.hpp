// SPDX-License-Identifier: MIT
// Helpers that the tests of walls share: which tiers there are, and a run of a small program.
#pragma once

#include "sandbox/blocked_calls.hpp"
#include "sandbox/run_confined.hpp"

#include <string>
#include <vector>

namespace rigor::testing {

inline std::string program(const std::string& name)
{
    return std::string(RIGOR_BINARY_DIR) + "/confined/" + name;
}

/// The tiers that are possible here, from the strongest to the weakest.
inline std::vector<Tier> possible_tiers()
{
    std::vector<Tier> tiers;
    for (const Tier tier : {Tier::a, Tier::b, Tier::c})
        if (is_possible(tier, possible_walls())) tiers.push_back(tier);
    return tiers;
}

/// The tiers with walls.
inline std::vector<Tier> walled_tiers()
{
    std::vector<Tier> tiers = possible_tiers();
    tiers.pop_back();
    return tiers;
}

inline Confinement confinement(Profile profile, Tier tier)
{
    Confinement walls{profile, tier};
    walls.limits.address_space = std::uint64_t{1} << 30;
    return walls;
}

inline RunLimits ample_time()
{
    RunLimits limits;
    limits.time = std::chrono::minutes(1); // the machine may be busy
    return limits;
}

inline ConfinedRun run_attempt(const Confinement& walls, const std::string& name,
                               const std::string& about = "")
{
    return run_confined(walls, {program("attempt"), name, about}, ample_time());
}

/// What the run tried that was blocked, or "nothing".
inline std::string blocked(const ConfinedRun& run)
{
    return run.blocked_call ? words_for_blocked_call(*run.blocked_call) : "nothing";
}

} // namespace rigor::testing
