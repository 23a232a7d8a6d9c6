// SPDX-License-Identifier: MIT
// How often a step is divided into parts, and when the step of the whole world may be.
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// How often a step was divided on the way to one of its parts: in the middle, and at the time of
/// an event, which is an impact or the end of sliding.
struct Divisions {
    int halvings = 0, events = 0;
    bool is_after_bounce = false; // whether the last one was just after a bounce at the start

    int all() const { return halvings + events; }
    Divisions with(bool is_halved) const { return {halvings + is_halved, events + !is_halved}; }
};

/// The limits of `Divisions::all`, which bound the run time. Ten halvings make parts that take a
/// 1024th of the step. In an island of at most `few_bodies` bodies, more divisions are allowed at
/// impacts whose times differ: each such division resolves one more bounce, whose energy would be
/// lost otherwise.
inline constexpr int most_divisions = 10;
inline constexpr int most_divisions_of_few = 400;
/// A share of the step that is so short that no second bounce follows a first one in it.
inline constexpr double alone_in_step = 1e-9;
/// Parts of this depth are not divided at the end of sliding: the step is divided at the predicted
/// time, and its parts at the corrected one.
inline constexpr int most_divisions_of_sliding = 2;

/// Whether at most `few_bodies` bodies move.
bool is_small(const World& world);

/// Whether the step of the whole world may be divided into halves once more. In a world of few
/// bodies, divisions at events do not count, because there may be many.
bool may_be_halved(const World& world, const Divisions& divisions);

/// The time just after the first bounce, if few bodies move and so may meet others after each
/// bounce; otherwise 0 [s]. From this time on, the search for contacts knows how the bodies move
/// on. It is also 0 if a contact carries a load, since the force of a load does not follow well
/// from a very short part.
double after_first_bounce(const World& world, const ContactProblem& problem,
                          const Divisions& divisions);

} // namespace rigor
