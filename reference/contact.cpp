// SPDX-License-Identifier: MIT
// Solutions of assignment A5: the impulses of many contacts between many bodies. A5.1 to A5.4
// resolve one contact after the other, the deepest first, and then level by level from the ground
// up (Guendelman, Bridson and Fedkiw 2003). A5.5 resolves all contacts together by projected
// Gauss–Seidel (Jean 1999).
#include "formulas/contact.hpp"

#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace rigor {

namespace {

using Bodies = std::vector<Body>;
using Contacts = std::vector<BodyContact>;

// v = v₁ - v₂ at the contact's point
Vector3d velocity_of(const Bodies& bodies, const BodyContact& c)
{
    return relative_velocity(bodies[c.body1], bodies[c.body2], c.point);
}

// K = K₁ + K₂ at the contact's point
Matrix3d impulse_matrix_of(const Bodies& bodies, const BodyContact& c)
{
    const Body &b1 = bodies[c.body1], &b2 = bodies[c.body2];
    return impulse_matrix(b1.inverse_mass, b1.inverse_inertia, b1.position, c.point) +
           impulse_matrix(b2.inverse_mass, b2.inverse_inertia, b2.position, c.point);
}

// Applies the impulse j to body 1 and -j to body 2.
void apply(Bodies& bodies, const BodyContact& c, const Vector3d& j)
{
    bodies[c.body1] = apply_impulse(bodies[c.body1], c.point, j);
    bodies[c.body2] = apply_impulse(bodies[c.body2], c.point, -j);
}

// The bodies unchanged, with zero impulses.
ContactResult untouched(const Bodies& bodies, const Contacts& contacts)
{
    return {bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
}

// Indices of the contacts, the deepest first. Contacts of equal depth keep their order.
std::vector<int> by_depth(const Contacts& contacts)
{
    std::vector<int> order(contacts.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return contacts[a].depth > contacts[b].depth; });
    return order;
}

// Resolves the contacts one at a time, in this order, in n iterations.
void resolve_in_order(ContactResult& result, const Contacts& contacts,
                      const std::vector<int>& order, int n)
{
    for (int k = 0; k < n; ++k) {
        const double epsilon = contact_restitution(k, n);
        for (int i : order) {
            const BodyContact& c = contacts[i];

            // u = v - s n
            const Vector3d u = velocity_of(result.bodies, c) - c.separation_speed * c.normal;
            if (u.dot(c.normal) >= 0) continue; // separating fast enough

            const Matrix3d K = impulse_matrix_of(result.bodies, c);
            const Vector3d j = collision_impulse(K, u, c.normal, epsilon, c.friction);
            apply(result.bodies, c, j);
            result.impulses[i] += j;
        }
    }
}

using Edges = std::vector<std::vector<int>>; // for each body, the bodies that its edges lead to

// The edges without those of static bodies: what a static body rests on is ignored.
Edges without_statics(Edges rests_on, const std::vector<bool>& is_static)
{
    for (std::size_t i = 0; i < rests_on.size(); ++i)
        if (is_static[i]) rests_on[i].clear();
    return rests_on;
}

Edges reversed(const Edges& edges)
{
    Edges result(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (int to : edges[i])
            result[to].push_back(static_cast<int>(i));
    return result;
}

// A body on the path of a search.
struct Visit {
    int body;
    std::size_t next; // the index of the edge to follow next
};

// Depth-first search from `first`. Appends to `found`, in post-order, each body that can be reached
// from `first` and was not seen yet, including `first` itself. The path is kept in a list, because
// a tall stack of bodies could exceed the depth of recursion.
void search(int first, const Edges& edges, std::vector<bool>& is_seen, std::vector<int>& found)
{
    if (is_seen[first]) return;
    std::vector<Visit> path = {{first, 0}};
    is_seen[first] = true;
    while (!path.empty()) {
        auto& [body, next] = path.back();
        if (next == edges[body].size()) {
            found.push_back(body);
            path.pop_back();
            continue;
        }
        const int to = edges[body][next++];
        if (is_seen[to]) continue;
        is_seen[to] = true;
        path.push_back({to, 0});
    }
}

// The bodies of one level, and the contacts whose higher body has this level, the deepest first.
struct Level {
    std::vector<int> bodies, contacts;
};

// The larger eigenvalue λ of K in the plane perpendicular to n [1/kg]. In the directions t and b of
// this plane, K is the matrix (a d; d c).
double tangential_eigenvalue(const Matrix3d& K, const Vector3d& n)
{
    const Vector3d t = n.unitOrthogonal(), b = n.cross(t);
    const double a = t.dot(K * t), c = b.dot(K * b), d = t.dot(K * b);
    return (a + c) / 2 + std::hypot((a - c) / 2, d);
}

struct Stiffness {
    double normal, tangential; // nᵀ K n and λ [1/kg]
};

// The total impulse of a contact after it is visited once in a sweep. Before, the total impulse was
// j and the relative velocity v.
Vector3d projected_impulse(const BodyContact& c, const Stiffness& stiffness, const Vector3d& j,
                           const Vector3d& v)
{
    const auto [nKn, lambda] = stiffness;
    const Vector3d& n = c.normal;
    const double mu = c.friction, s = c.separation_speed, v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;

    // jₙ ← max(0, jₙ - (v·n - s) / (nᵀ K n))
    const double j_n = std::max(0.0, j.dot(n) - (v_n - s) / nKn);

    // j_T ← j_T - v_T / λ,  shortened to |j_T| = μ jₙ where it is longer
    Vector3d j_T = j - j.dot(n) * n - v_T / lambda;
    if (j_T.norm() > mu * j_n) j_T *= mu * j_n / j_T.norm();

    return j_n * n + j_T;
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
    ContactResult result = untouched(bodies, contacts);
    resolve_in_order(result, contacts, by_depth(contacts), n);
    return result;
}

std::vector<int> contact_levels(const Edges& rests_on, const std::vector<bool>& is_static)
{
    const int count = static_cast<int>(rests_on.size());
    const Edges below = without_statics(rests_on, is_static), above = reversed(below);

    // This order goes from the top down: a body comes after all bodies that rest on it, unless they
    // are in a cycle.
    std::vector<int> downwards;
    std::vector<bool> is_seen(count, false);
    for (int i = 0; i < count; ++i)
        search(i, above, is_seen, downwards);

    // Going from the ground up, a body below that has no level yet is in a cycle with the body
    // above it (Sharir 1981, "A strong-connectivity algorithm and its applications in data flow
    // analysis").
    std::vector<int> levels(count, 0), cycle;
    is_seen.assign(count, false);
    for (auto i = downwards.rbegin(); i != downwards.rend(); ++i) {
        cycle.clear();
        search(*i, below, is_seen, cycle);
        int level = is_static[*i] ? 0 : 1;
        for (int member : cycle)
            for (int lower : below[member])
                level = std::max(level, levels[lower] + 1);
        for (int member : cycle)
            levels[member] = level;
    }
    return levels;
}

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    std::map<int, Level> upwards;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        upwards[levels[i]].bodies.push_back(static_cast<int>(i));
    for (int i : by_depth(contacts))
        upwards[std::max(levels[contacts[i].body1], levels[contacts[i].body2])].contacts.push_back(
            i);

    ContactResult result = untouched(bodies, contacts);
    for (const auto& [level, of_level] : upwards) {
        if (level > 0) resolve_in_order(result, contacts, of_level.contacts, n);
        for (int i : of_level.bodies) { // from now on they count as static
            result.bodies[i].inverse_mass = 0;
            result.bodies[i].inverse_inertia.setZero();
        }
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        result.bodies[i].inverse_mass = bodies[i].inverse_mass;
        result.bodies[i].inverse_inertia = bodies[i].inverse_inertia;
    }
    return result;
}

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactResult result = untouched(bodies, contacts);
    std::vector<Stiffness> stiffness;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const BodyContact& c = contacts[i];
        const Matrix3d K = impulse_matrix_of(bodies, c);
        stiffness.push_back({c.normal.dot(K * c.normal), tangential_eigenvalue(K, c.normal)});
        if (stiffness[i].normal == 0) continue; // both static

        result.impulses[i] = c.impulse; // the warm start
        apply(result.bodies, c, c.impulse);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            if (stiffness[i].normal == 0) continue; // both static
            const Vector3d v = velocity_of(result.bodies, contacts[i]), old = result.impulses[i];
            result.impulses[i] = projected_impulse(contacts[i], stiffness[i], old, v);
            apply(result.bodies, contacts[i], result.impulses[i] - old);
        }
    return result;
}

} // namespace rigor
