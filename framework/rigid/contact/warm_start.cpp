// SPDX-License-Identifier: MIT
// Warm start of the contacts by the impulses of the previous step. For each pair of bodies, the
// code computes the distances between old and new contacts in world space, and matches the nearest
// ones first. A new contact starts from the impulse of its old contact, projected onto the friction
// cone of the new contact.
#include "rigid/contact/warm_start.hpp"

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/inlined_product.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

// Largest distance between an old and a new contact that are matched, divided by the radius of the
// new contact (`ContactConstraint::radius`). A larger value would match contacts that are not the
// same; a smaller value would lose the impulses of contacts that move over a surface.
constexpr double near_fraction = 0.1;

template <class C> std::pair<int, int> bodies_of(const C& contact)
{
    return {contact.body1, contact.body2};
}

// The impulse projected onto the friction cone of c: its tangential part is shortened to the
// friction limit if it is longer. An impulse that pulls becomes zero.
Vector3d projected_to_cone(const ContactConstraint& c, const Vector3d& impulse)
{
    const Vector3d& n = c.normal;
    const double j_n = impulse.dot(n);
    if (j_n <= 0) return Vector3d::Zero();
    Vector3d j_T = impulse - j_n * n;
    const double length = j_T.norm();
    if (length > c.friction * j_n) j_T *= c.friction * j_n / length;
    return j_n * n + j_T;
}

// The warm contacts of the previous step, sorted by `body1`, then `body2`. Calls of
// `between_bodies_of` have to ask for the pairs in the same order, because each call searches only
// from the place where the previous call ended.
class WarmPairs {
public:
    explicit WarmPairs(std::span<const WarmContact> all) : rest_(all) {}

    // The warm contacts between the bodies of this contact. The first call uses binary search; each
    // later call continues where the previous call ended.
    std::span<const WarmContact> between_bodies_of(const ContactConstraint& c)
    {
        const std::pair pair = bodies_of(c);
        const auto is_before = [&](const WarmContact& warm) { return bodies_of(warm) < pair; };
        const auto first = is_first_ ? std::partition_point(rest_.begin(), rest_.end(), is_before)
                                     : std::find_if_not(rest_.begin(), rest_.end(), is_before);
        const auto last = std::find_if_not(
            first, rest_.end(), [&](const WarmContact& warm) { return bodies_of(warm) == pair; });
        is_first_ = false;
        rest_ = {last, rest_.end()};
        return {first, last};
    }

private:
    std::span<const WarmContact> rest_;
    bool is_first_ = true;
};

// A contact, a contact of the previous step, and the square of the distance between them.
struct Match {
    double distance = 0;                 // squared [m²]
    std::size_t contact = 0, before = 0; // indices of the new and of the old contact

    auto operator<=>(const Match&) const = default;
};

// Gives the contacts of one pair of bodies their initial impulses. The nearest contacts are matched
// first; otherwise a contact that carries no load could take the impulse of its neighbor.
// @param matches  working memory, reused to save allocations; its old content is not used
// @return the number of contacts that were matched
std::uint64_t start_pair_warm(std::span<const WarmContact> before, const std::vector<Pose>& poses,
                              double time_step, std::span<ContactConstraint> contacts,
                              std::vector<Match>& matches)
{
    if (before.empty()) return 0;
    const auto& [R, X] = poses[contacts.front().body1];
    matches.clear();
    for (std::size_t k = 0; k < before.size(); ++k) {
        const Vector3d x = optimised::product(R, before[k].point) + X;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const double farthest = near_fraction * contacts[i].radius;
            const double distance = (x - contacts[i].point).squaredNorm();
            if (distance <= farthest * farthest) matches.push_back({distance, i, k});
        }
    }
    std::sort(matches.begin(), matches.end());
    auto made = matches.begin();
    for (const Match& match : matches) {
        if (std::any_of(matches.begin(), made, [&](const Match& other) {
                return other.contact == match.contact || other.before == match.before;
            }))
            continue;
        ContactConstraint& c = contacts[match.contact];
        c.initial_impulse = projected_to_cone(c, time_step * before[match.before].mean_force);
        *made++ = match;
    }
    return static_cast<std::uint64_t>(made - matches.begin());
}

} // namespace

std::uint64_t start_warm(std::span<const WarmContact> before, const std::vector<Pose>& poses,
                         double time_step, std::span<const ContactPair> pairs,
                         std::span<ContactConstraint> contacts)
{
    std::vector<Match> matches;
    std::uint64_t count = 0;
    WarmPairs warm(before);
    for (const ContactPair& pair : pairs) {
        const std::span<ContactConstraint> of_pair = contacts.subspan(pair.first, pair.count());
        count += start_pair_warm(warm.between_bodies_of(of_pair.front()), poses, time_step, of_pair,
                                 matches);
    }
    return count;
}

std::vector<WarmContact> warm_contacts(const std::vector<Pose>& poses,
                                       std::span<const ContactConstraint> contacts,
                                       double time_step)
{
    std::vector<WarmContact> warm;
    if (!(time_step > 0)) return warm; // with a time step of 0, the forces j/h would be infinite
    warm.reserve(contacts.size());
    for (const ContactConstraint& c : contacts) {
        if (c.contact_impulse.isZero(0)) continue;
        const auto& [R, X] = poses[c.body1];
        warm.push_back({c.body1, c.body2, R.transpose() * Vector3d(c.point - X),
                        c.contact_impulse / time_step});
    }
    return warm;
}

void sort_by_bodies(std::vector<WarmContact>& contacts)
{
    std::stable_sort(
        contacts.begin(), contacts.end(),
        [](const WarmContact& a, const WarmContact& b) { return bodies_of(a) < bodies_of(b); });
}

} // namespace rigor
