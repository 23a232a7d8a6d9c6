// SPDX-License-Identifier: MIT
// A worker: one implementation of the formulas. It answers calls of formulas and runs scenes.
#include "rigid/parallel/keep_memory.hpp"
#include "worker/main/server.hpp"

// The build says whether the formulas are the reference's, so that no other implementation can
// claim to be the reference.
#ifdef RIGOR_REFERENCE
constexpr bool is_reference = true;
#else
constexpr bool is_reference = false;
#endif

int main()
{
    rigor::keep_freed_memory();
    return rigor::run_worker(is_reference);
}
