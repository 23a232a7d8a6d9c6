// SPDX-License-Identifier: MIT
// Looks up the address of the shared memory, which any attacker can do.
#pragma once

#include "worker/protocol/channel.hpp"

#include <cstdio>
#include <cstring>

namespace rigor {

inline Channel& find_channel()
{
    std::FILE* maps = std::fopen("/proc/self/maps", "r");
    char line[512];
    unsigned long begin = 0;
    while (maps && std::fgets(line, sizeof line, maps))
        if (std::strstr(line, "memfd:worker")) std::sscanf(line, "%lx", &begin);
    return *reinterpret_cast<Channel*>(begin);
}

} // namespace rigor
