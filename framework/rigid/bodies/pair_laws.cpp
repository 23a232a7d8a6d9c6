// SPDX-License-Identifier: MIT
// Finds the law of two bodies in a sorted list by bisection. A contact takes the restitution and
// the friction from this law. A value that the law does not set, and both values if there is no
// law, are combined from the materials of the two bodies.
#include "rigid/bodies/pair_laws.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

std::pair<int, int> key_of(const PairLaw& law)
{
    return {law.body1, law.body2};
}

} // namespace

void sort_by_pair(std::vector<PairLaw>& laws)
{
    for (PairLaw& law : laws)
        if (law.body1 > law.body2) std::swap(law.body1, law.body2);
    std::sort(laws.begin(), laws.end(),
              [](const PairLaw& a, const PairLaw& b) { return key_of(a) < key_of(b); });
}

const PairLaw* law_of(std::span<const PairLaw> laws, int body1, int body2)
{
    if (laws.empty()) return nullptr;
    const std::pair<int, int> key = std::minmax(body1, body2);
    const auto found = std::partition_point(laws.begin(), laws.end(),
                                            [&](const PairLaw& law) { return key_of(law) < key; });
    return found != laws.end() && key_of(*found) == key ? &*found : nullptr;
}

Material material_between(std::span<const PairLaw> laws, std::span<const RigidBody> bodies,
                          int body1, int body2)
{
    Material both = combined(bodies[body1].material, bodies[body2].material);
    if (const PairLaw* law = law_of(laws, body1, body2)) {
        both.restitution = law->restitution.value_or(both.restitution);
        both.friction = law->friction.value_or(both.friction);
    }
    return both;
}

std::vector<PairLaw> laws_among(std::span<const PairLaw> laws, std::span<const int> bodies)
{
    std::vector<PairLaw> among;
    if (laws.empty()) return among;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = i + 1; j < bodies.size(); ++j)
            if (const PairLaw* law = law_of(laws, bodies[i], bodies[j])) {
                among.push_back(*law);
                among.back().body1 = static_cast<int>(i);
                among.back().body2 = static_cast<int>(j);
            }
    return among;
}

} // namespace rigor
