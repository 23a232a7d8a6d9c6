// SPDX-License-Identifier: MIT
// One sorted list of contacts, Tarjan's recursion, copies with held bodies, an eigenvalue solver.
// Contacts are sorted once by depth. Levels come from strongly connected components (Tarjan 1972).
// Shock propagation works on copies in which the bodies below are static.
#include "formulas/contact.hpp"

#include "formulas/collision.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rigor {

namespace {

// K of a contact: the change of its velocity by a unit impulse, summed over both bodies.
Matrix3d softness(const Body& body1, const Body& body2, const Vector3d& x)
{
    return impulse_matrix(body2.inverse_mass, body2.inverse_inertia, body2.position, x) +
           impulse_matrix(body1.inverse_mass, body1.inverse_inertia, body1.position, x);
}

void push(std::vector<Body>& bodies, const BodyContact& c, const Vector3d& j)
{
    bodies[c.body2] = apply_impulse(bodies[c.body2], c.point, -j);
    bodies[c.body1] = apply_impulse(bodies[c.body1], c.point, j);
}

// Strongly connected components (Tarjan 1972) and their levels. A component is closed after all
// those that its edges lead to.
class Components {
public:
    Components(const std::vector<std::vector<int>>& edges, const std::vector<bool>& is_static)
        : edges_(edges), is_static_(is_static), levels(edges.size(), 0), order_(edges.size(), 0),
          lowest_(edges.size(), 0)
    {
        for (int i = 0; i < static_cast<int>(edges.size()); ++i)
            if (order_[i] == 0) visit(i);
    }

private:
    const std::vector<std::vector<int>>& edges_;
    const std::vector<bool>& is_static_;

public:
    std::vector<int> levels;

private:
    void visit(int i)
    {
        order_[i] = lowest_[i] = ++count_;
        open_.push_back(i);
        if (!is_static_[i])
            for (int to : edges_[i]) {
                if (order_[to] == 0) visit(to);
                if (order_[to] != done) lowest_[i] = std::min(lowest_[i], lowest_[to]);
            }
        if (lowest_[i] == order_[i]) close(i);
    }

    // closes the component whose first body is `first`
    void close(int first)
    {
        const auto begin = std::find(open_.rbegin(), open_.rend(), first).base() - 1;
        int level = is_static_[first] ? 0 : 1;
        for (auto i = begin; i != open_.end(); ++i)
            if (!is_static_[*i])
                for (int to : edges_[*i])
                    if (order_[to] == done) level = std::max(level, 1 + levels[to]);
        for (auto i = begin; i != open_.end(); ++i) {
            levels[*i] = level;
            order_[*i] = done;
        }
        open_.erase(begin, open_.end());
    }

    static constexpr int done = -1;
    std::vector<int> order_, lowest_, open_;
    int count_ = 0;
};

} // namespace

double contact_restitution(int k, int n)
{
    if (n < 1 || k > n - 1) return 0;
    return -static_cast<double>(n - 1 - std::max(k, 0)) / n;
}

ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int n)
{
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        order.emplace_back(-contacts[i].depth, i);
    std::sort(order.begin(), order.end());

    ContactResult result = {bodies, std::vector<Vector3d>(contacts.size(), {0, 0, 0})};
    for (int k = 0; k < n; ++k)
        for (const auto& [depth, i] : order) {
            const BodyContact& c = contacts[i];
            const Body &body1 = result.bodies[c.body1], &body2 = result.bodies[c.body2];
            const Vector3d v = relative_velocity(body1, body2, c.point);
            const Vector3d j = collision_impulse(softness(body1, body2, c.point),
                                                 v - c.normal * c.separation_speed, c.normal,
                                                 contact_restitution(k, n), c.friction);
            push(result.bodies, c, j);
            result.impulses[i] += j;
        }
    return result;
}

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    return Components(rests_on, is_static).levels;
}

ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n)
{
    ContactResult result = {bodies, std::vector<Vector3d>(contacts.size(), {0, 0, 0})};
    for (const int level : std::set<int>(levels.begin(), levels.end())) {
        if (level == 0) continue;

        // the contacts of this level, between copies of the bodies in which lower ones cannot move
        std::vector<Body> copies = result.bodies;
        for (std::size_t i = 0; i < copies.size(); ++i)
            if (levels[i] < level) {
                copies[i].inverse_mass = 0;
                copies[i].inverse_inertia = Matrix3d::Zero();
            }
        std::vector<std::size_t> own;
        std::vector<BodyContact> chosen;
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (std::max(levels[contacts[i].body1], levels[contacts[i].body2]) == level) {
                own.push_back(i);
                chosen.push_back(contacts[i]);
            }
        const ContactResult resolved = resolve_contacts(copies, chosen, n);
        for (std::size_t i = 0; i < own.size(); ++i)
            result.impulses[own[i]] = resolved.impulses[i];
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (levels[i] >= level) result.bodies[i] = resolved.bodies[i];
    }
    return result;
}

ContactResult resolve_simultaneously(const std::vector<Body>& bodies,
                                     const std::vector<BodyContact>& contacts, int sweeps)
{
    ContactResult result = {bodies, std::vector<Vector3d>(contacts.size(), {0, 0, 0})};
    for (int sweep = 0; sweep <= sweeps || sweep == 0; ++sweep)
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const BodyContact& c = contacts[i];
            const Body &body1 = result.bodies[c.body1], &body2 = result.bodies[c.body2];
            if (body1.inverse_mass == 0 && body2.inverse_mass == 0) continue;
            Vector3d& j = result.impulses[i];
            Vector3d j_new = c.impulse; // the guess is applied before the first sweep
            if (sweep > 0) {
                // P = δ - n nᵀ removes the part along n; λ is the largest eigenvalue of P K P
                const Vector3d& n = c.normal;
                const Matrix3d K = softness(body1, body2, c.point);
                const Matrix3d P = Matrix3d::Identity() - n * n.transpose();
                const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(P * K * P,
                                                                     Eigen::EigenvaluesOnly);
                const double lambda = solver.eigenvalues()[2];
                const Vector3d v = relative_velocity(body1, body2, c.point);

                const double push_new = j.dot(n) - (v.dot(n) - c.separation_speed) / n.dot(K * n);
                const double j_n = push_new > 0 ? push_new : 0;
                const Vector3d across = P * (j - v / lambda);
                const double length = across.norm(), most = c.friction * j_n;
                j_new = j_n * n + (length > most ? most / length : 1) * across;
            }
            push(result.bodies, c, j_new - j);
            j = j_new;
        }
    return result;
}

} // namespace rigor
