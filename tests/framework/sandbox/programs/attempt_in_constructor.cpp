// SPDX-License-Identifier: MIT
// Opens a socket before the first constructor that a C++ compiler orders.
#include "attempts.hpp"

#include <cstdio>

namespace {

void try_it()
{
    rigor::testing::attempt("socket", "");
}

// The C library calls the functions of this table before all constructors.
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_all)() = try_it;

} // namespace

int main()
{
    std::puts("main");
}
