// SPDX-License-Identifier: MIT
#include "rigid/bodies/non_finite.hpp"

#include <utility>

namespace rigor {

namespace {

std::string sentence(const std::string& body, const std::string& quantity, double time,
                     bool is_finite)
{
    const char* fault = is_finite ? " is beyond 1e100" : " is not finite";
    return "body '" + body + "': " + quantity + fault + " at t = " + std::to_string(time) + " s";
}

} // namespace

NonFiniteState::NonFiniteState(std::string body_name, std::string quantity_name, double at_time,
                               bool is_finite)
    : std::runtime_error(sentence(body_name, quantity_name, at_time, is_finite)),
      body(std::move(body_name)), quantity(std::move(quantity_name)), time(at_time)
{
}

void require_in_range(const Vector3d& v, const std::string& name, const char* quantity, double time)
{
    // Written so that NaN is refused.
    if ((v.array().abs() <= largest_in_scene).all()) return;
    throw NonFiniteState(name, quantity, time, v.allFinite());
}

void require_finite(const RigidBody& body, const RigidState& state, double time)
{
    require_in_range(state.position, body.name, "position X", time);
    const double s = state.orientation.s;
    require_in_range({s, s, s}, body.name, "orientation q", time);
    require_in_range(state.orientation.v, body.name, "orientation q", time);
    require_in_range(state.velocity, body.name, "velocity V", time);
    require_in_range(state.angular_momentum, body.name, "angular momentum L", time);
}

} // namespace rigor
