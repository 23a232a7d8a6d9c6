// SPDX-License-Identifier: MIT
// Reduces many contacts to a few that are spread over the contact region. The code starts with the
// outermost of the deepest contacts and then repeatedly adds the contact that is farthest from
// those already chosen, weighted by depth. Last, each chosen contact is replaced by the deepest of
// the contacts that are nearer to it than to any other chosen contact.
#include "rigid/detection/shapes/reduce_contacts.hpp"

#include "geometry/bounds/bounds.hpp"

#include <algorithm>
#include <span>

namespace rigor {

namespace {

// Contacts are equally deep if their gaps differ by less than this multiple of the extent of the
// contact region. Rounding and solver errors have this size.
constexpr double as_deep = 1e-5;
// Two distances count as equal if they differ by less than this fraction. Then the first contact is
// taken, so that rounding does not decide.
constexpr double equal_distance = 1e-9;
// Weight of the squared difference of two normals in the squared distance of two contacts. The
// other part, with weight 1, is the squared distance of their points divided by the square of the
// extent of all contact points. So opposite normals count as much as points at opposite ends of the
// contact region.
constexpr double normal_weight = 0.25;
constexpr double least_extent = 1e-300; // avoids 0/0 if all points are equal [m]
constexpr double not_chosen = 1e300;    // distance to the nearest chosen contact if there is none

// Chooses the contacts that are kept.
class Selection {
public:
    Selection(std::span<const Contact> contacts, double reach)
        : contacts_(contacts), reach_(reach), nearest_chosen_(contacts.size(), 0),
          distance_(contacts.size(), not_chosen)
    {
        Bounds bounds;
        deepest_ = contacts[0].gap;
        for (const Contact& t : contacts) {
            bounds.include({t.point, t.point});
            deepest_ = std::min(deepest_, t.gap);
            middle_ += t.point / static_cast<double>(contacts.size());
        }
        extent_ = std::max((bounds.high - bounds.low).norm(), least_extent);
    }

    std::vector<int> choose(std::size_t count)
    {
        add(outermost_of_deepest());
        while (chosen_.size() < count) {
            int best = -1;
            double farthest = 0;
            for (int i = 0; i < size(); ++i) {
                const double score = weight(i) * distance_[i];
                if (score <= farthest) continue;
                farthest = score;
                best = i;
            }
            if (best < 0) break;
            add(best);
        }
        replace_by_deeper();
        return chosen_;
    }

private:
    int size() const { return static_cast<int>(contacts_.size()); }

    // 1 for the deepest contact, 0 for a gap equal to the reach.
    double weight(int i) const
    {
        const double range = reach_ - deepest_;
        return range > 0 ? (reach_ - contacts_[i].gap) / range : 1;
    }

    // The distance of two contacts, without unit. It grows with the distance of their points,
    // divided by the extent, and with the difference of their normals.
    double difference(int i, int j) const
    {
        const Contact &a = contacts_[i], &b = contacts_[j];
        return std::sqrt((a.point - b.point).squaredNorm() / (extent_ * extent_) +
                         normal_weight * (a.normal - b.normal).squaredNorm());
    }

    int outermost_of_deepest() const
    {
        int best = -1;
        double farthest = -1;
        for (int i = 0; i < size(); ++i) {
            if (contacts_[i].gap > deepest_ + as_deep * extent_) continue;
            const double d = (contacts_[i].point - middle_).norm();
            if (d <= farthest * (1 + equal_distance)) continue; // the first of equal ones is kept
            farthest = d;
            best = i;
        }
        return best;
    }

    void add(int i)
    {
        for (int j = 0; j < size(); ++j) {
            const double d = difference(i, j);
            if (d >= distance_[j]) continue;
            distance_[j] = d;
            nearest_chosen_[j] = static_cast<int>(chosen_.size());
        }
        chosen_.push_back(i);
    }

    // Each contact belongs to the nearest chosen contact. A chosen contact is replaced by a contact
    // that belongs to it and is clearly deeper.
    void replace_by_deeper()
    {
        for (int i = 0; i < size(); ++i) {
            int& standing = chosen_[nearest_chosen_[i]];
            if (contacts_[i].gap < contacts_[standing].gap - as_deep * extent_) standing = i;
        }
    }

    std::span<const Contact> contacts_;
    double reach_, deepest_ = 0, extent_ = 0;
    Vector3d middle_ = Vector3d::Zero();
    std::vector<int> chosen_;
    // For each contact, the chosen contact nearest to it: its index in `chosen_`, and its distance.
    std::vector<int> nearest_chosen_;
    std::vector<double> distance_;
};

} // namespace

void reduce_contacts(std::vector<Contact>& contacts, std::size_t first, double reach,
                     std::size_t most)
{
    if (contacts.size() - first <= most) return;
    const std::span<const Contact> found(contacts.data() + first, contacts.size() - first);
    std::vector<Contact> kept;
    for (const int i : Selection(found, reach).choose(most))
        kept.push_back(found[i]);
    contacts.resize(first);
    contacts.insert(contacts.end(), kept.begin(), kept.end());
}

} // namespace rigor
