// SPDX-License-Identifier: MIT
// The compiler lets each function of the reference call `__cyg_profile_func_enter` first
// (-finstrument-functions). If it is the chosen formula, it misbehaves there, whoever called it: a
// test, the engine, or another formula.
#include "misbehaviour.hpp"

#include "formulas/table.hpp"

#include <csignal>
#include <cstdlib>
#include <ctime>

extern "C" {
void __cyg_profile_func_enter(void* function, void* caller);
void __cyg_profile_func_exit(void* function, void* caller);
}

namespace {

using namespace rigor;
using costs::Kind;

// Volatile, since the compiler must not take the values for constants.
volatile costs::Choice chosen = {"rigor: what misbehaves:", 0, Kind::nothing};

#define RIGOR_ROW(tag, topic, function, ...) reinterpret_cast<void*>(&rigor::function),
void* const functions[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

double processor_time()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void misbehave(Kind kind)
{
    switch (kind) {
    case Kind::nothing:
        return;
    case Kind::ends:
        std::exit(0);
    case Kind::crashes:
        std::raise(SIGSEGV);
        return;
    case Kind::loops:
        for (volatile int i = 0;; i = i + 1) {
        }
    case Kind::lingers:
        for (const double start = processor_time(); processor_time() < start + 1.9;) {
        }
        return;
    }
}

} // namespace

void __cyg_profile_func_enter(void* function, void*)
{
    if (chosen.kind != Kind::nothing && function == functions[chosen.formula])
        misbehave(chosen.kind);
}

void __cyg_profile_func_exit(void*, void*) {}
