// SPDX-License-Identifier: MIT
// The smallest program: it prints a word.
#include <cstdio>

int main()
{
    std::puts("hello");
}
