// SPDX-License-Identifier: MIT
// An implementation whose every result is a fingerprint of its arguments. If one bit is lost on the
// way there or back, the result is another one.
#pragma once

#include "worker/protocol/wire.hpp"

namespace rigor {

/// A stream of random numbers from a seed (Steele, Lea and Flood 2014, "Fast splittable
/// pseudorandom number generators").
struct SplitMix {
    std::uint64_t state;
    std::uint64_t next()
    {
        std::uint64_t z = state += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
};

/// Fills in a random finite value of T, with random lengths and optional values.
template <class T> void fill(T& value, SplitMix& random)
{
    if constexpr (std::is_same_v<T, bool>) {
        value = random.next() % 2 == 1;
    } else if constexpr (std::is_same_v<T, double>) {
        // Any sign and any size below 2. Larger exponents are left out, and with them infinity and
        // NaN.
        const std::uint64_t bits = random.next() & 0xbfffffffffffffffu;
        std::memcpy(&value, &bits, sizeof value);
    } else if constexpr (std::is_arithmetic_v<T>) {
        value = static_cast<T>(random.next());
    } else if constexpr (wire::FixedMatrix<T>) {
        for (int i = 0; i < value.size(); ++i)
            fill(value.data()[i], random);
    } else if constexpr (wire::is_optional<T>) {
        value.reset();
        if (random.next() % 4 > 0) fill(value.emplace(), random);
    } else if constexpr (Plain<T>) {
        Fields<T>::each(value, [&](std::string_view, auto& field) { fill(field, random); });
    } else {
        if constexpr (wire::is_vector<T>) value.resize(random.next() % 6);
        for (auto&& element : value) {
            typename T::value_type filled = element; // a copy, for std::vector<bool>
            fill(filled, random);
            element = filled;
        }
    }
}

/// The answer of the echo to these arguments.
template <class Result> Result echo_of(unsigned formula, const wire::Bytes& arguments)
{
    SplitMix random{formula};
    for (const std::byte byte : arguments) {
        random.state ^= static_cast<std::uint64_t>(byte);
        random.next();
    }
    Result result{};
    fill(result, random);
    return result;
}

} // namespace rigor
