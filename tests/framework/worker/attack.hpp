// SPDX-License-Identifier: MIT
// Helpers that the tests of hostile implementations share.
#pragma once

#include "worker/proxy/proxy.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace rigor {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

inline std::filesystem::path attack(const std::string& name)
{
    return std::filesystem::path(RIGOR_BINARY_DIR) / "attacks" / ("worker_attack_" + name);
}

inline Limits tight()
{
    Limits limits;
    limits.call = Seconds(0.6);
    limits.memory = std::size_t{160} << 20;
    return limits;
}

inline bool next_call_is_answered()
{
    return kinetic_energy(2, {1, 0, 0}, Matrix3d::Zero(), {0, 0, 0}) == 1.0;
}

inline Matrix3d attacked()
{
    return cross_matrix(Vector3d(1, 2, 3));
}

inline bool is_alive(int pid)
{
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string number, name, state;
    return stat >> number >> name >> state && state != "Z" && state != "X";
}

inline bool dies_soon(int pid)
{
    for (int i = 0; i < 200 && is_alive(pid); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return !is_alive(pid);
}

} // namespace rigor
