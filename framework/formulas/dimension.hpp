// SPDX-License-Identifier: MIT
#pragma once

namespace rigor {

/// massᵐ lengthˡ timeᵗ: the exponents of a unit. A force, kg m/s², has {1, 1, -2}.
struct Dimension {
    int mass = 0, length = 0, time = 0;
    constexpr bool operator==(const Dimension&) const = default;
    constexpr Dimension operator*(const Dimension& d) const
    {
        return {mass + d.mass, length + d.length, time + d.time};
    }
};

} // namespace rigor
