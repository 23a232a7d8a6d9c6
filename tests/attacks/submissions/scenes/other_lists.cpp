// SPDX-License-Identifier: MIT
// Returns more bodies, impulses and levels than there are, or none at all.
// topic: contact
// tasks: A5.2 A5.3 A5.4 A5.5
// expect: 0 failed|crashed
#include "formulas/contact.hpp"

#include <climits>

namespace rigor {

namespace {

ContactResult other(std::vector<Body> bodies, std::size_t impulses)
{
    return {std::move(bodies), std::vector<Vector3d>(impulses, Vector3d::Ones())};
}

} // namespace

ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int)
{
    return other(std::vector<Body>(bodies.size() + 1000), contacts.size());
}

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>&)
{
    return std::vector<int>(rests_on.size() % 2 == 0 ? 0 : rests_on.size(), INT_MIN);
}

ContactResult shock_propagation(const std::vector<Body>& bodies, const std::vector<BodyContact>&,
                                const std::vector<int>&, int)
{
    return other(bodies, 1 << 20);
}

ContactResult resolve_simultaneously(const std::vector<Body>&, const std::vector<BodyContact>&, int)
{
    return other({}, 0);
}

} // namespace rigor
