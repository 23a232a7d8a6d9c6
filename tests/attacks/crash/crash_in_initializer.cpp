// SPDX-License-Identifier: MIT
// A program that crashes before main.
#include <cstdint>

namespace {

const int crash = *reinterpret_cast<volatile int*>(std::uintptr_t{64});

} // namespace
