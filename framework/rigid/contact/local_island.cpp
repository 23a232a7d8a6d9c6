// SPDX-License-Identifier: MIT
// Converts an island to the input of the formulas of topic `contact`. The bodies that have active
// contacts are numbered from 0, then the bodies and the contacts are copied. The copied depths are
// rounded, so that depths that differ only by rounding become equal. The result of a formula is
// checked for its size and then stored in the problem.
#include "rigid/contact/local_island.hpp"

#include "rigid/bodies/height_order.hpp"

#include <algorithm>
#include <stdexcept>

namespace rigor {

LocalIsland local_island(const ContactProblem& problem, std::span<const int> active)
{
    LocalIsland local;
    std::vector<int> touched;
    for (int i : active) {
        const ContactConstraint& c = problem.contacts[i];
        touched.push_back(c.body1);
        touched.push_back(c.body2);
    }
    local.indices = touched;
    std::sort(local.indices.begin(), local.indices.end());
    local.indices.erase(std::unique(local.indices.begin(), local.indices.end()),
                        local.indices.end());
    const auto local_index = [&](int body) {
        return static_cast<int>(std::lower_bound(local.indices.begin(), local.indices.end(), body) -
                                local.indices.begin());
    };
    for (int i : local.indices)
        local.bodies.push_back(problem.bodies[i]);
    const RoundedLength rounded(
        active, [&](int i) -> const Vector3d& { return problem.contacts[i].point; });
    for (int i : active) {
        const ContactConstraint& c = problem.contacts[i];
        local.contacts.push_back({local_index(c.body1), local_index(c.body2), c.point, c.normal,
                                  -rounded(c.gap), c.friction, c.target_speed, c.initial_impulse});
    }
    return local;
}

void check_size(const LocalIsland& local, const ContactResult& result, const char* formula)
{
    if (result.bodies.size() == local.bodies.size() &&
        result.impulses.size() == local.contacts.size())
        return;
    throw std::out_of_range(std::string(formula) + " returned " +
                            std::to_string(result.bodies.size()) + " bodies and " +
                            std::to_string(result.impulses.size()) + " impulses for " +
                            std::to_string(local.bodies.size()) + " bodies and " +
                            std::to_string(local.contacts.size()) + " contacts");
}

void take_result(ContactProblem& problem, const LocalIsland& local, std::span<const int> active,
                 const ContactResult& result, const char* formula)
{
    check_size(local, result, formula);
    for (std::size_t i = 0; i < local.indices.size(); ++i) {
        Body& body = problem.bodies[local.indices[i]];
        if (body.is_static()) continue;
        body.velocity = result.bodies[i].velocity;
        body.angular_velocity = result.bodies[i].angular_velocity;
        body.angular_momentum = result.bodies[i].angular_momentum;
    }
    for (std::size_t k = 0; k < active.size(); ++k)
        problem.contacts[active[k]].contact_impulse = result.impulses[k];
}

} // namespace rigor
