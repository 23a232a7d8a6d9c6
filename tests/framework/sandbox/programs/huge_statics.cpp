// SPDX-License-Identifier: MIT
// A program with more static variables than it may have memory.
#include <cstdio>

namespace {
char huge[std::size_t{3} << 29];
}

int main(int argc, char**)
{
    huge[argc] = 1;
    std::printf("%d\n", huge[std::size_t{argc > 1} << 30]);
}
