// SPDX-License-Identifier: MIT
#include "rigid/bodies/non_finite.hpp"

#include "framework/rigid/worlds.hpp"

#include <limits>
#include <optional>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();

// The quantity that is named as not finite, or nothing.
std::optional<std::string> found_in(const RigidState& state)
{
    RigidBody body;
    body.name = "crate";
    try {
        require_finite(body, state, 1.5);
    } catch (const NonFiniteState& error) {
        CHECK(error.body == "crate");
        CHECK(error.time == 1.5);
        return error.quantity;
    }
    return {};
}

// References to the numbers of a state, in the order X, q, V, L.
std::vector<double*> numbers_of(RigidState& s)
{
    std::vector<double*> all;
    const auto add = [&all](Vector3d& v) {
        for (int k = 0; k < 3; ++k)
            all.push_back(&v[k]);
    };
    add(s.position);
    all.push_back(&s.orientation.s);
    add(s.orientation.v);
    add(s.velocity);
    add(s.angular_momentum);
    return all;
}

} // namespace

TEST_CASE("non finite: each number of a state is checked and named by its quantity", "[rigid]")
{
    const std::string quantities = "XXXqqqqVVVLLL"; // the letter that the name ends with
    for (std::size_t i = 0; i < quantities.size(); ++i)
        for (const double bad : {not_a_number, infinite, -infinite}) {
            CAPTURE(i, bad);
            RigidState state;
            REQUIRE(numbers_of(state).size() == quantities.size());
            *numbers_of(state)[i] = bad;
            CHECK(found_in(state).value().back() == quantities[i]);
        }
}

TEST_CASE("non finite: of several quantities the first is named", "[rigid]")
{
    RigidState state;
    const char* names[] = {"angular momentum L", "velocity V", "orientation q", "position X"};
    Vector3d* const vectors[] = {&state.angular_momentum, &state.velocity, &state.orientation.v,
                                 &state.position};
    for (int k = 0; k < 4; ++k) {
        vectors[k]->y() = not_a_number;
        CHECK(found_in(state) == names[k]);
    }
}

TEST_CASE("non finite: every state in range is accepted", "[rigid]")
{
    RigidState state;
    CHECK(found_in(state) == std::nullopt);
    for (const double extreme :
         {largest_in_scene, -largest_in_scene, std::numeric_limits<double>::denorm_min(), -0.0}) {
        for (double* number : numbers_of(state))
            *number = extreme;
        CHECK(found_in(state) == std::nullopt);
    }
}

TEST_CASE("non finite: a number out of range is refused though it is finite", "[rigid]")
{
    const double most = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < 13; ++i)
        for (const double far : {1.1 * largest_in_scene, -1e198, most, -most}) {
            CAPTURE(i, far);
            RigidState state;
            *numbers_of(state)[i] = far;
            CHECK(found_in(state).has_value());
        }
    try {
        require_in_range({0, 1e198, 0}, "crate", "velocity V", 0.25);
        FAIL("no exception");
    } catch (const NonFiniteState& error) {
        CHECK(std::string(error.what()) ==
              "body 'crate': velocity V is beyond 1e100 at t = 0.250000 s");
    }
}

TEST_CASE("non finite: the message is one line with body and quantity and time", "[rigid]")
{
    CHECK(std::string(NonFiniteState("crate", "inertia", 0.25).what()) ==
          "body 'crate': inertia is not finite at t = 0.250000 s");
}
