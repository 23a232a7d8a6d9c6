// SPDX-License-Identifier: MIT
// The only file that includes Catch2, so that 2.13 and 3.x look the same to every test.
#pragma once

#include <charconv>
#include <ostream>
#include <string_view>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#define RIGOR_CATCH_3
#else
#include <catch2/catch.hpp>
#endif

namespace rigor::testing {

#ifdef RIGOR_CATCH_3
template <class T> using Matcher = Catch::Matchers::MatcherBase<T>;
#else
template <class T> using Matcher = Catch::MatcherBase<T>;
#endif

/// A captured number. It is printed with the digits that it needs, and with a power of ten where
/// that is shorter. Catch2 itself prints only ten decimals, so 1e-12 as 0.0.
struct CapturedNumber {
    double value;

    friend std::ostream& operator<<(std::ostream& out, const CapturedNumber& number)
    {
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, number.value).ptr;
        return out << std::string_view(text, static_cast<std::size_t>(end - text));
    }
};

inline CapturedNumber captured(const double& value)
{
    return {value};
}
template <class T> const T& captured(const T& value)
{
    return value;
}

/// Hands the values of a `CAPTURE` to Catch2.
template <class... T> void capture(Catch::Capturer& capturer, const T&... values)
{
    capturer.captureValues(0, captured(values)...);
}

} // namespace rigor::testing

#undef CAPTURE
#define RIGOR_CAPTURE(name, ...)                                                                   \
    Catch::Capturer name("CAPTURE", CATCH_INTERNAL_LINEINFO, Catch::ResultWas::Info,               \
                         #__VA_ARGS__);                                                            \
    rigor::testing::capture(name, __VA_ARGS__)
#define CAPTURE(...) RIGOR_CAPTURE(INTERNAL_CATCH_UNIQUE_NAME(capturer), __VA_ARGS__)
