// SPDX-License-Identifier: MIT
// Warm start of the contacts by the impulses of the previous step. For each pair of bodies, the
// code computes the distances between old and new contacts, and matches the nearest ones first. An
// old contact may have moved with either body: with the ground below a wheel, or with a block that
// slides over the ground. A new contact starts from the impulse of its old contact, projected onto
// the friction cone of the new contact. Under a face that slides, the loads are first spread
// evenly.
#include "rigid/contact/warm_start.hpp"

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/inlined_product.hpp"

#include <algorithm>
#include <optional>
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

// Whether a contact that carries a load has friction and starts from an impulse at its limit.
bool starts_sliding(const ContactConstraint& c)
{
    const Vector3d& j = c.initial_impulse;
    return c.friction > 0 && j.dot(c.normal) > 0 && is_at_friction_limit(c, j);
}

// The closed contacts of a pair, if they are those of a face that slides: if they are at least
// four, with the same normal, and all that carry a load start at their friction limits. Otherwise
// the list is empty.
std::vector<ContactConstraint*> sliding_face(std::span<ContactConstraint> contacts)
{
    constexpr std::size_t least_contacts = 4; // the equilibrium determines the loads of fewer
    constexpr double same_normal = 1e-9;      // largest difference of two normals
    if (contacts.size() < least_contacts) return {};
    for (const ContactConstraint& c : contacts) {
        if (c.initial_impulse.isZero(0)) continue;
        const bool is_closed = c.gap <= nearly_touching_gap * c.radius;
        if (!is_closed || !starts_sliding(c)) return {};
    }
    std::vector<ContactConstraint*> face;
    for (ContactConstraint& c : contacts)
        if (c.gap <= nearly_touching_gap * c.radius) face.push_back(&c);
    const bool is_flat = std::all_of(face.begin(), face.end(), [&](const ContactConstraint* c) {
        return (c->normal - face.front()->normal).norm() <= same_normal;
    });
    return is_flat && face.size() >= least_contacts ? face : std::vector<ContactConstraint*>{};
}

// Normal impulses that are a linear function of the place x on a face: j = j₀ + s · x.
struct LinearLoad {
    Vector3d middle = Vector3d::Zero(); // mean of the contact points, where x = 0 [m]
    Vector3d slope = Vector3d::Zero();  // s, along the face [N s/m]
    double mean = 0;                    // j₀ [N s]

    double at(const Vector3d& point) const { return mean + slope.dot(point - middle); }
};

// The linear load with the sum and the moments of the initial impulses.
// @return nothing if the contacts lie nearly on a line
std::optional<LinearLoad> linear_load(const std::vector<ContactConstraint*>& face)
{
    // The least determinant of the second moments, if their trace is 1.
    constexpr double least_determinant = 1e-3;
    const Vector3d n = face.front()->normal, t1 = n.unitOrthogonal(), t2 = n.cross(t1);
    const auto count = static_cast<double>(face.size());
    LinearLoad load;
    for (const ContactConstraint* c : face) {
        load.middle += c->point / count;
        load.mean += c->initial_impulse.dot(n) / count;
    }
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero(); // second moments of the places [m²]
    Eigen::Vector2d first = Eigen::Vector2d::Zero();  // moments of the impulses [N s m]
    for (const ContactConstraint* c : face) {
        const Vector3d r = c->point - load.middle;
        const Eigen::Vector2d x(r.dot(t1), r.dot(t2));
        second += x * x.transpose();
        first += c->initial_impulse.dot(n) * x;
    }
    const double trace = second.trace();
    if (!(second.determinant() > least_determinant * trace * trace)) return std::nullopt;
    const Eigen::Vector2d slope = second.inverse() * first;
    load.slope = slope.x() * t1 + slope.y() * t2;
    return load;
}

// Spreads the load of a pair that slides on a face evenly over its contacts. As on an elastic
// foundation (Winkler 1867), the normal impulse becomes a linear function of the place, with the
// same moments. The equilibrium of the body leaves the loads of four contacts open, so errors of
// earlier steps could add up in them. Where contacts slide, an uneven load makes the friction
// uneven, which turns the body.
// @param sum  the normal impulses of the last step, also of contacts that were not found again,
//             [N s]
void spread_evenly(std::span<ContactConstraint> contacts, double sum)
{
    const std::vector<ContactConstraint*> face = sliding_face(contacts);
    if (face.empty()) return;
    const std::optional<LinearLoad> load = linear_load(face);
    if (!load || std::any_of(face.begin(), face.end(),
                             [&](const ContactConstraint* c) { return load->at(c->point) <= 0; }))
        return;
    const double larger = sum / (load->mean * static_cast<double>(face.size()));
    for (ContactConstraint* c : face) {
        const double before = c->initial_impulse.dot(c->normal),
                     spread = larger * load->at(c->point);
        c->initial_impulse = before > 0 ? Vector3d(spread / before * c->initial_impulse)
                                        : Vector3d(spread * c->normal);
    }
}

// Gives the contacts of one pair of bodies their initial impulses. The nearest contacts are matched
// first; otherwise a contact that carries no load could take the impulse of its neighbor.
// @param matches  working memory, reused to save allocations; its old content is not used
// @return the number of contacts that were matched
std::uint64_t start_pair_warm(std::span<const WarmContact> before, const std::vector<Pose>& poses,
                              double time_step, std::span<ContactConstraint> contacts,
                              std::vector<Match>& matches)
{
    if (before.empty()) return 0;
    const Pose &pose1 = poses[contacts.front().body1], &pose2 = poses[contacts.front().body2];
    matches.clear();
    for (std::size_t k = 0; k < before.size(); ++k) {
        const Vector3d x1 = optimised::product(pose1.R, before[k].point1) + pose1.X,
                       x2 = optimised::product(pose2.R, before[k].point2) + pose2.X;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Vector3d& x = contacts[i].point;
            const double farthest = near_fraction * contacts[i].radius;
            const double distance = std::min((x1 - x).squaredNorm(), (x2 - x).squaredNorm());
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
    if (made == matches.begin()) return 0;
    double sum = 0; // normal impulses [N s]
    for (const WarmContact& warm : before)
        sum += time_step * warm.mean_force.dot(contacts.front().normal);
    spread_evenly(contacts, sum);
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
        const auto in_object_space = [&](const Pose& pose) -> Vector3d {
            return pose.R.transpose() * Vector3d(c.point - pose.X);
        };
        warm.push_back({c.body1, c.body2, in_object_space(poses[c.body1]),
                        in_object_space(poses[c.body2]), c.contact_impulse / time_step});
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
