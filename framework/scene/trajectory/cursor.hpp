// SPDX-License-Identifier: MIT
// Helpers that the readers of a trajectory's records share: errors, checks and a cursor.
#pragma once

#include "errors/input_error.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace rigor {

[[noreturn]] inline void fail(const std::string& where, const std::string& wanted,
                              const std::string& found)
{
    throw InputError(fmt::format("{}: expected {}, found {}", where, wanted, found));
}

inline void check_finite(double number, const std::string& where, std::string_view quantity)
{
    if (!std::isfinite(number))
        fail(where, fmt::format("a finite {}", quantity), fmt::format("{}", number));
}

template <class Derived>
void check_finite(const Eigen::MatrixBase<Derived>& numbers, const std::string& where,
                  std::string_view quantity)
{
    for (int i = 0; i < numbers.size(); ++i)
        check_finite(numbers.derived().data()[i], where, quantity);
}

inline std::size_t count_of(const std::string& where, std::string_view what, std::size_t count,
                            std::size_t most)
{
    if (count > most)
        fail(where, fmt::format("at most {} {}", most, what), fmt::format("{}", count));
    return count;
}

/// Reads values one after the other from bytes. It does not check that there are enough bytes; the
/// caller has to check that before, because bytes beyond the end would be read otherwise.
class ByteCursor {
public:
    explicit ByteCursor(std::span<const std::byte> bytes) : bytes_(bytes) {}

    void raw(void* data, std::size_t size)
    {
        std::memcpy(data, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }
    template <class T> T take()
    {
        T value;
        if constexpr (std::is_arithmetic_v<T>)
            raw(&value, sizeof value);
        else
            raw(value.data(), sizeof(double) * static_cast<std::size_t>(value.size()));
        return value;
    }
    std::size_t left() const { return bytes_.size(); }

private:
    std::span<const std::byte> bytes_;
};

} // namespace rigor
