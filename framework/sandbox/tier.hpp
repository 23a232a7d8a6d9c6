// SPDX-License-Identifier: MIT
// How strong the sandbox around a student's program is on this machine, for this user. The parts of
// the sandbox are called walls.
//
// | tier | walls                                                                      |
// |------|----------------------------------------------------------------------------|
// | A    | namespaces, filter of system calls, Landlock, for root also another user   |
// | B    | filter of system calls, Landlock, for root also another user               |
// | C    | limits on resources only                                                   |
//
// Landlock is a part of Linux that denies access to files. If the machine lacks it, tier A is still
// possible, provided that the grader can learn which call was blocked. Tier B always needs
// Landlock, because nothing else would keep the compiler of a submission from reading the reference
// or the hidden tests. Another user is a user id that nobody has; only root can start a program
// with it.
//
// All tiers have limits on resources, and in all tiers nothing that the program starts outlives it.
// The results of the grading name the tier. A tier below the strongest possible one is used only if
// the environment variable RIGOR_TIER names it.
#pragma once

#include <string>

namespace rigor {

enum class Tier { a, b, c };

/// A set of walls, the parts of a sandbox: those that this machine and this user allow, or those of
/// a tier.
struct Walls {
    enum class Namespaces { none, plain, user } namespaces = Namespaces::none;
    bool another_user = false;
    bool filter = false;   // whether system calls can be filtered (seccomp)
    bool listener = false; // whether the grader learns which call was blocked
    bool landlock = false; // whether access to files can be denied
};

/// The walls (parts of the sandbox) that this machine and this user allow, determined once by
/// trying each. @throws std::system_error if the launcher, which tries them, cannot be started
const Walls& possible_walls();

/// Whether these walls (parts of the sandbox) are enough for this tier.
bool is_possible(Tier tier, const Walls& walls);

/// The strongest tier for which these walls (parts of the sandbox) are enough.
Tier strongest(const Walls& walls);

/// The tier for what students wrote: the strongest, or a weaker one that the environment variable
/// RIGOR_TIER (A, B or C) names.
/// @throws InputError if RIGOR_TIER is none of them or is not possible here
Tier usual_tier();

/// Whether the sandbox is too weak to hide what students must not see. This is so if only tier C,
/// limits on resources, is possible here and RIGOR_TIER does not ask for tier C.
bool has_too_weak_walls();

/// The walls (parts of the sandbox) of a tier on this machine. Walls that only a stronger tier has
/// are left out.
Walls walls_of(Tier tier);

/// The tier and its walls in words, such as `A: namespaces, uid, seccomp, Landlock` or `B: seccomp,
/// no Landlock`.
std::string description(Tier tier);

/// A user id that nobody has, drawn at random from a range that systems assign to nobody.
unsigned unused_user();

} // namespace rigor
