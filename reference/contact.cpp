// SPDX-License-Identifier: MIT
#include "formulas/contact.hpp"

#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rigor {

namespace {

using Bodies = std::vector<Body>;
using Contacts = std::vector<BodyContact>;

// K = K₁ + K₂
Matrix3d impulse_matrix_of(const Bodies& bodies, const BodyContact& c)
{
    const Body &b1 = bodies[c.body1], &b2 = bodies[c.body2];
    return impulse_matrix(b1.inverse_mass, b1.inverse_inertia, b1.position, c.point) +
           impulse_matrix(b2.inverse_mass, b2.inverse_inertia, b2.position, c.point);
}

// u = v - s n
Vector3d approach_velocity(const Bodies& bodies, const BodyContact& c)
{
    const Vector3d v = relative_velocity(bodies[c.body1], bodies[c.body2], c.point);
    return v - c.separation_speed * c.normal;
}

// +j on body 1, -j on body 2
void apply(Bodies& bodies, const BodyContact& c, const Vector3d& j)
{
    bodies[c.body1] = apply_impulse(bodies[c.body1], c.point, j);
    bodies[c.body2] = apply_impulse(bodies[c.body2], c.point, -j);
}

// Indices of the contacts, the deepest first.
std::vector<int> by_depth(const Contacts& contacts)
{
    std::vector<int> order(contacts.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return contacts[a].depth > contacts[b].depth; });
    return order;
}

// The larger eigenvalue λ of K across n: of (a d; d c) in two directions across n.
double tangential_eigenvalue(const Matrix3d& K, const Vector3d& n)
{
    const Vector3d t = n.unitOrthogonal(), b = n.cross(t);
    const double a = t.dot(K * t), c = b.dot(K * b), d = t.dot(K * b);
    return (a + c) / 2 + std::hypot((a - c) / 2, d);
}

// The bodies that i and its cycle rest on, directly or through others, as the search for cycles goes
// (Tarjan 1972, "Depth-first search and linear graph algorithms").
class Levels {
public:
    Levels(const std::vector<std::vector<int>>& rests_on, const std::vector<bool>& is_static)
        : rests_on_(rests_on), is_static_(is_static), levels(rests_on.size(), 0),
          order_(rests_on.size(), -1), lowest_(rests_on.size(), 0), is_open_(rests_on.size(), false)
    {
        for (int i = 0; i < static_cast<int>(rests_on.size()); ++i)
            if (order_[i] < 0) visit(i);
    }

private:
    // A body to look at, and how many of those it rests on were looked at.
    struct Visit {
        int body = 0;
        std::size_t next = 0;
    };

    void visit(int first)
    {
        std::vector<Visit> path{open(first)};
        while (!path.empty()) {
            auto& [i, next] = path.back();
            if (!is_static_[i] && next < rests_on_[i].size()) {
                const int below = rests_on_[i][next++];
                if (order_[below] < 0)
                    path.push_back(open(below));
                else if (is_open_[below])
                    lowest_[i] = std::min(lowest_[i], order_[below]);
                continue;
            }
            const int done = i;
            if (lowest_[done] == order_[done]) close(done);
            path.pop_back();
            if (!path.empty())
                lowest_[path.back().body] = std::min(lowest_[path.back().body], lowest_[done]);
        }
    }

    Visit open(int i)
    {
        order_[i] = lowest_[i] = visited_++;
        is_open_[i] = true;
        open_.push_back(i);
        return {i, 0};
    }

    // Of a whole cycle, or a body alone: one more than the highest below it. Those of the cycle
    // itself still have level 0.
    void close(int first)
    {
        const auto begin = std::find(open_.begin(), open_.end(), first);
        int level = 0;
        for (auto i = begin; i != open_.end(); ++i) {
            if (is_static_[*i]) continue;
            level = std::max(level, 1);
            for (int below : rests_on_[*i])
                level = std::max(level, levels[below] + 1);
        }
        for (auto i = begin; i != open_.end(); ++i) {
            levels[*i] = level;
            is_open_[*i] = false;
        }
        open_.erase(begin, open_.end());
    }

    const std::vector<std::vector<int>>& rests_on_;
    const std::vector<bool>& is_static_;

public:
    std::vector<int> levels;

private:
    std::vector<int> order_, lowest_, open_;
    std::vector<bool> is_open_;
    int visited_ = 0;
};

// Bodies below this level can't be moved.
Bodies hold_below(int level, const Bodies& bodies, const std::vector<int>& levels)
{
    Bodies held = bodies;
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (levels[i] >= level) continue;
        held[i].inverse_mass = 0;
        held[i].inverse_inertia.setZero();
    }
    return held;
}

} // namespace

double contact_restitution(int k, int n)
{
    if (n < 1 || k >= n - 1) return 0;

    // ε = (k + 1)/n - 1
    return (std::max(k, 0) + 1.0) / n - 1;
}

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    const std::vector<int> order = by_depth(contacts);
    for (int k = 0; k < n; ++k) {
        const double epsilon = contact_restitution(k, n);
        for (int i : order) {
            const BodyContact& c = contacts[i];
            const Vector3d u = approach_velocity(result.bodies, c);
            if (u.dot(c.normal) >= 0) continue; // separating

            const Matrix3d K = impulse_matrix_of(result.bodies, c);
            const Vector3d j = collision_impulse(K, u, c.normal, epsilon, c.friction);
            apply(result.bodies, c, j);
            result.impulses[i] += j;
        }
    }
    return result;
}

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    return Levels(rests_on, is_static).levels;
}

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    const auto level_of = [&](const BodyContact& c) {
        return std::max(levels[c.body1], levels[c.body2]);
    };
    const int highest = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
    for (int level = 1; level <= highest; ++level) {
        Contacts of_level;
        std::vector<int> indices;
        for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
            if (level_of(contacts[i]) != level) continue;
            of_level.push_back(contacts[i]);
            indices.push_back(i);
        }
        const ContactResult resolved =
            resolve_contacts(hold_below(level, result.bodies, levels), of_level, n);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (levels[i] < level) continue;
            result.bodies[i] = resolved.bodies[i];
        }
        for (std::size_t i = 0; i < indices.size(); ++i)
            result.impulses[indices[i]] = resolved.impulses[i];
    }
    return result;
}

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactResult result{bodies, {}};
    for (const BodyContact& c : contacts) {
        const bool can_move = !bodies[c.body1].is_static() || !bodies[c.body2].is_static();
        result.impulses.push_back(can_move ? c.impulse : Vector3d::Zero());
        apply(result.bodies, c, result.impulses.back());
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const BodyContact& c = contacts[i];
            const Vector3d& n = c.normal;
            const Matrix3d K = impulse_matrix_of(result.bodies, c);
            if (K.isZero(0)) continue; // both static

            const double nKn = n.dot(K * n), lambda = tangential_eigenvalue(K, n);
            const Vector3d v =
                relative_velocity(result.bodies[c.body1], result.bodies[c.body2], c.point);
            const double v_n = v.dot(n);
            const Vector3d v_T = v - v_n * n;
            const Vector3d j = result.impulses[i];

            // jₙ ← max(0, jₙ - (v·n - s) / (nᵀ K n))
            const double j_n = std::max(0.0, j.dot(n) - (v_n - c.separation_speed) / nKn);

            // j_T ← j_T - v_T / λ,  shortened to |j_T| = μ jₙ where it is longer
            Vector3d j_T = j - j.dot(n) * n - v_T / lambda;
            if (j_T.norm() > c.friction * j_n) j_T *= c.friction * j_n / j_T.norm();

            result.impulses[i] = j_n * n + j_T;
            apply(result.bodies, c, result.impulses[i] - j);
        }
    return result;
}

} // namespace rigor
