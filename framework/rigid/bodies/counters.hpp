// SPDX-License-Identifier: MIT
// Counters of a run. The table lists most skips: kinds of work that are left out where a scene does
// not need them. Some counters count the work that was left out. The others count the work that was
// done: `islands`, `warm_starts`, `level_sets_built`, and `pairs_tested` out of `pairs_possible`. A
// switch is the key in "optimisations" of a scene file that turns a skip off. `rigor bench skips`
// measures how much time the skips save.
// "Decided by" names the source file below framework/rigid (for deformable/: below framework), then
// the function or the reason.
//
// counter               switch in a scene     decided by
// isotropic_shortcuts                         motion/free_flight, `fly` and `fly_all`: constant I
//  (not counted)                              step/single_body, `is_single_body`: no contacts
// static_skipped                              motion/free_flight, `fly_all`
// bodies_asleep         sleep                 step/sleep, `fall_asleep`
// pairs_tested                                detection/contact_candidates, `run_narrow_phase`
// pair_searches_saved                         detection/broad_phase, `is_valid`: fat bounds
// islands               islands               contact/islands, `islands_of`
// warm_starts           warm_start            contact/make_problem, `find_islands`
// early_exits           early_exit            contact/solvers/run_sweeps
//  (not counted)        optimised_formulas    bodies/settings, `uses_optimised_formulas`
// level_sets_built                            detection/shapes/distance_field: built when needed
// flow_skipped                                deformable/elasticity/flow
// eigenvalues_skipped   stress_bound          deformable/fracture/fracture
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace rigor {

/// Counts of the work that was done since the start of the run, and of the work that was skipped
/// because the scene did not need it.
struct Counters {
    std::uint64_t steps = 0;
    std::uint64_t substeps = 0; // substeps of free flights that were divided (motion/free_flight)
    std::uint64_t pairs_possible = 0, pairs_tested = 0, pair_searches_saved = 0, contacts = 0;
    std::uint64_t collision_impulses = 0, contact_impulses = 0;
    std::uint64_t isotropic_shortcuts = 0, free_flights = 0, static_skipped = 0;
    std::uint64_t islands = 0, bodies_asleep = 0, warm_starts = 0; // sums over all steps
    std::uint64_t contact_sweeps = 0, early_exits = 0, newton_solves = 0;
    std::uint64_t corrected_contacts = 0;
    std::uint64_t level_sets_built = 0, level_set_samples = 0;
    // Counters of deformable solids.
    std::uint64_t deformable_substeps = 0, system_solves = 0, solver_iterations = 0;
    std::uint64_t node_impulses = 0, elements_flowed = 0, flow_skipped = 0;
    std::uint64_t eigenvalues = 0, eigenvalues_skipped = 0, cracks = 0, mesh_changes = 0;

    /// Adds every count.
    Counters& operator+=(const Counters& other)
    {
        using Counts = std::array<std::uint64_t, sizeof(Counters) / sizeof(std::uint64_t)>;
        Counts sums = std::bit_cast<Counts>(*this);
        const Counts more = std::bit_cast<Counts>(other);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += more[i];
        return *this = std::bit_cast<Counters>(sums);
    }
};

} // namespace rigor
