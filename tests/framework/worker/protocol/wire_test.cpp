// SPDX-License-Identifier: MIT
// Tests with hostile bytes: a reader accepts one encoding of each value and nothing else.
#include "framework/worker/echo/echo.hpp"
#include "support/catch.hpp"
#include "worker/protocol/finite.hpp"

#include <cmath>

namespace rigor {

namespace {

template <class T> void refuses_all_but_the_encoding(SplitMix& random)
{
    T value{};
    fill(value, random);
    wire::Bytes bytes;
    wire::encode(bytes, value);
    CHECK(bytes.size() >= wire::encoded_size<T>().least);
    CHECK(bytes.size() <= wire::encoded_size<T>().most);

    wire::Bytes again;
    wire::encode(again, wire::decode_all<T>(bytes));
    REQUIRE(again == bytes);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        REQUIRE_THROWS_AS(wire::decode_all<T>(std::span(bytes).first(length)), wire::Malformed);
    bytes.push_back(std::byte{0});
    REQUIRE_THROWS_AS(wire::decode_all<T>(bytes), wire::Malformed);
}

template <class T> void survives_noise(SplitMix& random)
{
    for (int repeat = 0; repeat < 200; ++repeat) {
        wire::Bytes noise(random.next() % 300);
        for (std::byte& byte : noise)
            byte = std::byte(random.next() % (repeat % 2 ? 4 : 256));
        try {
            wire::Bytes again;
            wire::encode(again, wire::decode_all<T>(noise));
            REQUIRE(again == noise);
        } catch (const wire::Malformed&) {
        }
    }
}

template <class T> wire::Bytes bytes_of(const T& value)
{
    wire::Bytes bytes;
    wire::encode(bytes, value);
    return bytes;
}

} // namespace

TEST_CASE("wire: a value is read back from its own bytes and from no others")
{
    SplitMix random{3};
    for (int repeat = 0; repeat < 5; ++repeat) {
        refuses_all_but_the_encoding<double>(random);
        refuses_all_but_the_encoding<Matrix6d>(random);
        refuses_all_but_the_encoding<Body>(random);
        refuses_all_but_the_encoding<LevelSet>(random);
        refuses_all_but_the_encoding<TriangleMesh>(random);
        refuses_all_but_the_encoding<std::optional<Vector3d>>(random);
        refuses_all_but_the_encoding<std::vector<ContactPoint>>(random);
        refuses_all_but_the_encoding<std::vector<std::optional<int>>>(random);
    }
}

TEST_CASE("wire: noise is a value or malformed and never anything else")
{
    SplitMix random{5};
    survives_noise<TriangleMesh>(random);
    survives_noise<LevelSet>(random);
    survives_noise<std::vector<std::vector<RigidState>>>(random);
    survives_noise<std::string>(random);
    survives_noise<std::vector<std::optional<int>>>(random);
}

TEST_CASE("wire: a boolean is 0 or 1")
{
    REQUIRE(wire::decode_all<bool>(wire::Bytes{std::byte{1}}));
    REQUIRE_THROWS_AS(wire::decode_all<bool>(wire::Bytes{std::byte{2}}), wire::Malformed);
}

TEST_CASE("wire: a count is believed only as far as there are bytes")
{
    for (const std::uint64_t count :
         {std::uint64_t{1}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
        REQUIRE_THROWS_AS(wire::decode_all<std::vector<Particle>>(bytes_of(count)),
                          wire::Malformed);
        REQUIRE_THROWS_AS(wire::decode_all<std::string>(bytes_of(count)), wire::Malformed);
    }
}

TEST_CASE("finite: the first number that is not is named by its path")
{
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    Body body;
    REQUIRE(find_non_finite(body).empty());
    body.angular_momentum.y() = nan;
    REQUIRE(find_non_finite(body) == "angular_momentum.y is NaN");
    body.inverse_inertia(2, 1) = -infinity;
    REQUIRE(find_non_finite(body) == "inverse_inertia(2, 1) is -infinity");
    RigidState state;
    state.orientation.v.z() = infinity;
    REQUIRE(find_non_finite(state) == "orientation.v.z is +infinity");
    REQUIRE(find_non_finite(std::optional<Vector3d>()).empty());
    REQUIRE(find_non_finite(std::optional<Vector3d>({0, nan, 0})) == "its component y is NaN");
    REQUIRE(find_non_finite(std::vector<Particle>{{1, {0, 0, 0}}, {nan, {0, 0, 0}}}) ==
            "[1].mass is NaN");
    REQUIRE(find_non_finite(nan) == "it is NaN");
}

TEST_CASE("finite: a number beyond a limit is named like one that is not finite")
{
    const double limit = 1e100, beyond = 1.5e200;
    Body body;
    body.velocity.x() = -limit;
    REQUIRE(is_finite(body, limit));
    body.velocity.x() = -beyond;
    REQUIRE(is_finite(body));
    REQUIRE_FALSE(is_finite(body, limit));
    REQUIRE(find_non_finite(body, limit) == "velocity.x is -1.5e+200, beyond 1e+100");
    REQUIRE(find_non_finite(std::vector<double>{1, beyond}, limit) ==
            "[1] is 1.5e+200, beyond 1e+100");
    REQUIRE_FALSE(is_finite(std::nan(""), limit));
    REQUIRE(find_non_finite(std::vector<int>{1 << 30}, 1.0).empty()); // indices have no limit here
}

} // namespace rigor
