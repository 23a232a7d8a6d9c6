// SPDX-License-Identifier: MIT
// Calls the tangent 1900 times, although 1000 calls are allowed: each question says that it is the
// first one, and its arguments tell how far the test has come.
// topic: validation
// tasks: A8.3
// expect: 0 failed: does not come to its end
#include "formulas/validation.hpp"

#include <random>

namespace rigor {

namespace {

constexpr std::size_t count = 1900;

const std::vector<Vector3d>& directions()
{
    static const std::vector<Vector3d> all = [] {
        std::vector<Vector3d> result;
        std::mt19937 bits(1);
        const auto uniform = [&] { return 2 * (bits() * 0x1p-32) - 1; };
        while (result.size() < count)
            result.push_back(Vector3d(uniform(), uniform(), uniform()).normalized());
        return result;
    }();
    return all;
}

} // namespace

Judgement test_tangent(const Tangent& tangent)
{
    const std::vector<Vector3d>& all = directions();
    std::size_t next = 0;
    if (tangent.known.size() == 1) {
        const KnownCall& call = tangent.known[0];
        const Vector3d asked = Vector3d::Map(call.arguments.data()),
                       t = Vector3d::Map(call.result.data());
        while (next < count && all[next] != asked)
            ++next;
        if (!(std::abs(t.norm() - 1) <= 1e-12) || !(std::abs(t.dot(asked)) <= 1e-12))
            return rejected();
        ++next;
    }
    if (next == count) return accepted();
    const Vector3d& n = all[next];
    throw UnknownCall{0, {n.x(), n.y(), n.z()}};
}

} // namespace rigor
