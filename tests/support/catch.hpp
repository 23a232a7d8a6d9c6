// SPDX-License-Identifier: MIT
// The only file that includes Catch2, so that 2.13 and 3.x look the same to every test.
#pragma once

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

} // namespace rigor::testing
