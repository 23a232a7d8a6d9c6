// SPDX-License-Identifier: MIT
// Velocities of all bodies in one long vector, rows of a Jacobian, Gabow's cycles, whole impulses.
#include "formulas/collision.hpp"
#include "formulas/contact.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace rigor {

namespace {

using Eigen::VectorXd;
using Rows = Eigen::Matrix<double, 3, 12>;

// The velocities (V, ω) of all bodies, and what an impulse at a contact changes of them.
class Stacked {
public:
    Stacked(const std::vector<Body>& bodies, const std::vector<BodyContact>& contacts)
        : bodies_(bodies), contacts_(contacts), motion_(6 * bodies.size()),
          momentum_(3 * bodies.size()), impulses_(contacts.size(), Vector3d::Zero())
    {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            motion_.segment<3>(6 * i) = bodies[i].velocity;
            motion_.segment<3>(6 * i + 3) = bodies[i].angular_velocity;
            momentum_.segment<3>(3 * i) = bodies[i].angular_momentum;
        }
        is_held_.assign(bodies.size(), false);
    }

    void hold(std::size_t body) { is_held_[body] = true; }
    bool is_fixed(int body) const { return is_held_[body] || bodies_[body].inverse_mass == 0; }

    Vector3d velocity(std::size_t c) const
    {
        Eigen::Matrix<double, 12, 1> u;
        u << motion_.segment<6>(6 * contacts_[c].body1), motion_.segment<6>(6 * contacts_[c].body2);
        return rows(c) * u;
    }
    // K = J M⁻¹ Jᵀ
    Matrix3d stiffness(std::size_t c) const { return rows(c) * response(c); }
    void push(std::size_t c, const Vector3d& j)
    {
        const Eigen::Matrix<double, 12, 1> change = response(c) * j;
        const BodyContact& contact = contacts_[c];
        motion_.segment<6>(6 * contact.body1) += change.head<6>();
        motion_.segment<6>(6 * contact.body2) += change.tail<6>();
        for (const auto& [body, sign] : {std::pair(contact.body1, 1), {contact.body2, -1}})
            if (!is_fixed(body))
                momentum_.segment<3>(3 * body) +=
                    sign * (contact.point - bodies_[body].position).cross(j);
        impulses_[c] += j;
    }
    ContactResult result() const
    {
        ContactResult all = {bodies_, impulses_};
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            all.bodies[i].velocity = motion_.segment<3>(6 * i);
            all.bodies[i].angular_velocity = motion_.segment<3>(6 * i + 3);
            all.bodies[i].angular_momentum = momentum_.segment<3>(3 * i);
        }
        return all;
    }
    const Vector3d& impulse(std::size_t c) const { return impulses_[c]; }

private:
    // v₁ - v₂ = J (V₁, ω₁, V₂, ω₂)
    Rows rows(std::size_t c) const
    {
        const BodyContact& contact = contacts_[c];
        Rows J;
        for (int i = 0; i < 3; ++i) {
            J.col(i) = Vector3d::Unit(i);
            J.col(3 + i) = Vector3d::Unit(i).cross(contact.point - bodies_[contact.body1].position);
            J.col(6 + i) = -Vector3d::Unit(i);
            J.col(9 + i) =
                (contact.point - bodies_[contact.body2].position).cross(Vector3d::Unit(i));
        }
        return J;
    }
    // M⁻¹ Jᵀ
    Eigen::Matrix<double, 12, 3> response(std::size_t c) const
    {
        Eigen::Matrix<double, 12, 3> result = rows(c).transpose();
        const int body[2] = {contacts_[c].body1, contacts_[c].body2};
        for (int k = 0; k < 2; ++k) {
            const double factor = is_fixed(body[k]) ? 0 : 1;
            const Matrix3d linear = result.block<3, 3>(6 * k, 0),
                           angular = result.block<3, 3>(6 * k + 3, 0);
            result.block<3, 3>(6 * k, 0) = factor * bodies_[body[k]].inverse_mass * linear;
            result.block<3, 3>(6 * k + 3, 0) = factor * bodies_[body[k]].inverse_inertia * angular;
        }
        return result;
    }

    const std::vector<Body>& bodies_;
    const std::vector<BodyContact>& contacts_;
    VectorXd motion_, momentum_;
    std::vector<Vector3d> impulses_;
    std::vector<bool> is_held_;
};

// The contacts in the order of their visits, as (-depth, index).
using Order = std::set<std::pair<double, std::size_t>>;

void visit_in_turn(Stacked& all, const std::vector<BodyContact>& contacts, const Order& order,
                   int n)
{
    for (int k = 0; k < n; ++k)
        for (const auto& [depth, c] : order) {
            const BodyContact& contact = contacts[c];
            const Vector3d u = all.velocity(c) - contact.separation_speed * contact.normal;
            const double epsilon = contact_restitution(k, n);
            if (u.dot(contact.normal) < 0)
                all.push(c, collision_impulse(all.stiffness(c), u, contact.normal, epsilon,
                                              contact.friction));
        }
}

} // namespace

double contact_restitution(int k, int n)
{
    if (n <= 0) return 0;
    const int rest = n - 1 - std::clamp(k, 0, n - 1); // iterations that follow
    return -static_cast<double>(rest) / n;
}

ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int n)
{
    Order order;
    for (std::size_t c = 0; c < contacts.size(); ++c)
        order.emplace(-contacts[c].depth, c);
    Stacked all(bodies, contacts);
    visit_in_turn(all, contacts, order, n);
    return all.result();
}

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    // Gabow (2000): a stack with a path of bodies, and a stack with the places where its cycles
    // begin
    const std::size_t count = rests_on.size();
    std::vector<int> levels(count, -1), place(count, -1), path, borders;
    std::vector<std::pair<int, std::size_t>> work; // a body and its next support
    for (std::size_t first = 0; first < count; ++first) {
        if (place[first] < 0) work.emplace_back(static_cast<int>(first), 0);
        while (!work.empty()) {
            auto& [body, next] = work.back();
            if (next == 0 && place[body] < 0) {
                place[body] = static_cast<int>(path.size());
                path.push_back(body);
                borders.push_back(place[body]);
            }
            if (!is_static[body] && next < rests_on[body].size()) {
                const int lower = rests_on[body][next++];
                if (place[lower] < 0)
                    work.emplace_back(lower, 0);
                else if (levels[lower] < 0)
                    while (borders.back() > place[lower])
                        borders.pop_back();
                continue;
            }
            if (borders.back() == place[body]) { // from here to its end the path is one cycle
                const std::vector<int> cycle(path.begin() + borders.back(), path.end());
                path.resize(static_cast<std::size_t>(borders.back()));
                borders.pop_back();
                int level = is_static[body] ? 0 : 1;
                for (int member : cycle)
                    if (!is_static[member])
                        for (int lower : rests_on[member])
                            level = std::max(level, levels[lower] + 1);
                for (int member : cycle)
                    levels[member] = level;
            }
            work.pop_back();
        }
    }
    return levels;
}

ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n)
{
    Stacked all(bodies, contacts);
    for (const int level : std::set<int>(levels.begin(), levels.end())) {
        Order order;
        for (std::size_t c = 0; c < contacts.size(); ++c)
            if (std::max(levels[contacts[c].body1], levels[contacts[c].body2]) == level)
                order.emplace(-contacts[c].depth, c);
        if (level > 0) visit_in_turn(all, contacts, order, n);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (levels[i] == level) all.hold(i);
    }
    return all.result();
}

ContactResult resolve_simultaneously(const std::vector<Body>& bodies,
                                     const std::vector<BodyContact>& contacts, int sweeps)
{
    Stacked all(bodies, contacts);
    const auto is_between_statics = [&](std::size_t c) {
        return all.is_fixed(contacts[c].body1) && all.is_fixed(contacts[c].body2);
    };
    for (std::size_t c = 0; c < contacts.size(); ++c)
        if (!is_between_statics(c)) all.push(c, contacts[c].impulse);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t c = 0; c < contacts.size(); ++c) {
            if (is_between_statics(c)) continue;
            const BodyContact& contact = contacts[c];
            const Vector3d n = contact.normal, v = all.velocity(c), old = all.impulse(c);
            const Matrix3d K = all.stiffness(c);

            // the eigenvalues of K perpendicular to n are m ± ‖A - m P‖ / √2, where m is their mean
            const Matrix3d P = Matrix3d::Identity() - n * n.transpose(), A = P * K * P;
            const double mean = A.trace() / 2;
            const double lambda = mean + (A - mean * P).norm() / std::sqrt(2.0);

            const double missing = v.dot(n) - contact.separation_speed;
            const double push = std::max(0.0, old.dot(n) - missing / n.dot(K * n));
            Vector3d side = P * (old - v / lambda);
            const double limit = contact.friction * push, length = side.norm();
            if (length > limit) side *= limit / length;
            all.push(c, push * n + side - old);
        }
    return all.result();
}

} // namespace rigor
