// SPDX-License-Identifier: MIT
#include "rigid/bodies/non_finite.hpp"

#include <cmath>
#include <utility>

namespace rigor {

namespace {

std::string sentence(const std::string& body, const std::string& quantity, double time)
{
    std::string digits = std::to_string(time);
    return "body '" + body + "': " + quantity + " is not finite at t = " + digits + " s";
}

} // namespace

NonFiniteState::NonFiniteState(std::string body_name, std::string quantity_name, double at_time)
    : std::runtime_error(sentence(body_name, quantity_name, at_time)), body(std::move(body_name)),
      quantity(std::move(quantity_name)), time(at_time)
{
}

void require_finite(const RigidBody& body, const RigidState& state, double time)
{
    if (!state.position.allFinite()) throw NonFiniteState(body.name, "position X", time);
    if (!std::isfinite(state.orientation.s) || !state.orientation.v.allFinite())
        throw NonFiniteState(body.name, "orientation q", time);
    if (!state.velocity.allFinite()) throw NonFiniteState(body.name, "velocity V", time);
    if (!state.angular_momentum.allFinite())
        throw NonFiniteState(body.name, "angular momentum L", time);
}

} // namespace rigor
