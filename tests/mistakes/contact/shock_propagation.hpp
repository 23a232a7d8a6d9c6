// SPDX-License-Identifier: MIT
// Correct shock propagation (A5.4). A mistake replaces the one step that it gets wrong.
#pragma once

#include "mistakes/contact/one_contact.hpp"

#include <functional>

namespace rigor {

/// The integers first, first + 1, …, last.
inline std::vector<int> upwards(int first, int last)
{
    std::vector<int> levels(std::max(0, last - first + 1));
    std::iota(levels.begin(), levels.end(), first);
    return levels;
}

struct ShockPropagation {
    /// The levels to be resolved, in this order.
    std::function<std::vector<int>(int highest)> order = [](int highest) {
        return upwards(1, highest);
    };
    /// The level of a contact, from the levels of its bodies.
    std::function<int(int level1, int level2)> level_of = [](int level1, int level2) {
        return std::max(level1, level2);
    };
    /// Whether a body is held fixed while a level is resolved.
    std::function<bool(const Body& body, int its_level, int level)> is_held =
        [](const Body&, int its_level, int level) { return its_level < level; };
    std::function<void(Body& body)> hold = [](Body& body) {
        body.inverse_mass = 0;
        body.inverse_inertia.setZero();
    };
    /// The number of iterations for a level, if n are requested.
    std::function<int(int n)> iterations = [](int n) { return n; };
    /// Copies the result of a level to a body.
    std::function<void(Body& body, const Body& resolved, bool is_below)> take_over =
        [](Body& body, const Body& resolved, bool is_below) {
            const Body own = body;
            if (!is_below) body = resolved;
            body.inverse_mass = own.inverse_mass;
            body.inverse_inertia = own.inverse_inertia;
        };

    ContactResult operator()(const Bodies& bodies, const Contacts& contacts,
                             const std::vector<int>& levels, int n) const
    {
        ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
        const int highest = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
        for (const int level : order(highest))
            resolve_level(result, contacts, levels, level, n);
        return result;
    }

private:
    void resolve_level(ContactResult& result, const Contacts& contacts,
                       const std::vector<int>& levels, int level, int n) const
    {
        Bodies held = result.bodies;
        for (std::size_t i = 0; i < held.size(); ++i)
            if (is_held(held[i], levels[i], level)) hold(held[i]);
        Contacts chosen;
        std::vector<std::size_t> indices;
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (level_of(levels[contacts[i].body1], levels[contacts[i].body2]) == level) {
                chosen.push_back(contacts[i]);
                indices.push_back(i);
            }
        const ContactResult resolved = resolve_contacts(held, chosen, iterations(n));
        for (std::size_t i = 0; i < indices.size(); ++i)
            result.impulses[indices[i]] = resolved.impulses[i];
        for (std::size_t i = 0; i < held.size(); ++i)
            take_over(result.bodies[i], resolved.bodies[i], levels[i] < level);
    }
};

} // namespace rigor
