// SPDX-License-Identifier: MIT
#pragma once

namespace rigor::testing {

/// The number of random cases of a law that holds for every formula: n, or under sanitizers, which
/// take twenty times as long, a quarter of them.
constexpr unsigned sampled(unsigned n)
{
#ifdef RIGOR_SANITIZED
    return (n + 3) / 4;
#else
    return n;
#endif
}

/// Which cases of a long sweep are run: all, or under sanitizers, which take twenty times as long,
/// every eleventh. (No loop of a sweep has eleven turns, so the cases taken differ in every loop.)
class Sweep {
public:
    bool takes_next()
    {
#ifdef RIGOR_SANITIZED
        return next_++ % 11 == 0;
#else
        return true;
#endif
    }

private:
    [[maybe_unused]] int next_ = 0;
};

} // namespace rigor::testing
