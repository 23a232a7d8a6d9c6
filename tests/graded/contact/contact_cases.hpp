// SPDX-License-Identifier: MIT
// Bodies that touch, made by hand and at random: the cases of the tests of topic `contact`.
#pragma once

#include "formulas/contact.hpp"
#include "graded/collision/sliding_pair.hpp"

#include <array>

namespace rigor::testing {

using Bodies = std::vector<Body>;
using Contacts = std::vector<BodyContact>;

struct ContactCase {
    Bodies bodies;
    Contacts contacts;
};

/// A body that an impulse can push but not turn, for motion along one line.
inline Body block(double mass, const Vector3d& V = {0, 0, 0}, const Vector3d& X = {0, 0, 0})
{
    Body body;
    body.inverse_mass = 1 / mass;
    body.position = X;
    body.velocity = V;
    return body;
}

/// A uniform ball of radius 0.1 that does not spin. With the contact at its lowest point, K is
/// diag(3.5, 1, 3.5)/M.
inline Body ball(double mass, const Vector3d& V, const Vector3d& X = {0, 0.1, 0})
{
    Body body = block(mass, V, X);
    body.inverse_inertia = Matrix3d::Identity() / (0.4 * mass * 0.01);
    return body;
}

/// A thin rod along x about the origin, with M = 1 and its ends at x = ±1; I = 1/3 across it. An
/// upward impulse j at one end changes the velocity of this end by 4 j, and that of the other end
/// by -2 j.
inline Body rod(const Vector3d& V)
{
    Body body = block(1, V);
    body.inverse_inertia.diagonal() = Vector3d(0, 3, 3);
    return body;
}

inline BodyContact touch(int body1, int body2, double depth, const Vector3d& point = {0, 0, 0},
                         double friction = 0)
{
    BodyContact contact;
    contact.body1 = body1;
    contact.body2 = body2;
    contact.depth = depth;
    contact.point = point;
    contact.friction = friction;
    return contact;
}

/// Body 0 is the ground. Bodies 1, 2, … of these masses form a stack that falls at 1 m/s.
inline ContactCase stack(const std::vector<double>& masses)
{
    ContactCase stack{{Body()}, {}};
    for (double mass : masses) {
        const int above = static_cast<int>(stack.bodies.size());
        stack.contacts.push_back(touch(above, above - 1, 0.01, above * up));
        stack.bodies.push_back(block(mass, -up, (above + 0.5) * up));
    }
    return stack;
}

/// A seesaw that falls at 1 m/s. A plank with M = 2 and I = 1 about z lies on a ridge below its
/// middle. A block of 6 kg is on its left end and one of 2 kg on its right end, both 1 m from the
/// middle.
///
/// No block leaves the plank, so all three turn as one about the ridge:
/// ω = (m₁ - m₂) a v / (I + (m₁ + m₂) a²) = 4/9, with v = 1 m/s and a = 1 m.
inline ContactCase seesaw()
{
    Body plank = block(2, -up);
    plank.inverse_inertia.diagonal() = Vector3d(0, 0, 1);
    return {{Body(), plank, block(6, -up, {-1, 0.5, 0}), block(2, -up, {1, 0.5, 0})},
            {touch(1, 0, 0.03), touch(2, 1, 0.02, {-1, 0, 0}), touch(3, 1, 0.01, {1, 0, 0})}};
}

/// The bodies of the seesaw after the impact.
inline Bodies tilting_seesaw()
{
    Bodies bodies = seesaw().bodies;
    bodies[1].velocity.setZero();
    bodies[1].angular_velocity = bodies[1].angular_momentum = Vector3d(0, 0, 4.0 / 9);
    bodies[2].velocity = -4.0 / 9 * up;
    bodies[3].velocity = 4.0 / 9 * up;
    return bodies;
}

inline Vector3d velocity_of(const Bodies& bodies, const BodyContact& c)
{
    return velocity_at(bodies[c.body1], c.point) - velocity_at(bodies[c.body2], c.point);
}

inline Matrix3d impulse_matrix_of(const Bodies& bodies, const BodyContact& c)
{
    return response_at(bodies[c.body1], c.point) + response_at(bodies[c.body2], c.point);
}

/// Three to six random bodies, and twice as many contacts at random points with distinct depths.
/// Friction is so small, μ² λ ≤ nᵀ K n, that no contact can jam or raise the energy by friction
/// (the handout proves it: "What friction may do"). Both eigenvalues across n add up to
/// Tr(K) - nᵀ K n, so λ is at most that.
inline ContactCase random_case(unsigned seed, bool with_statics)
{
    Random random(seed);
    ContactCase result;
    const int count = 3 + static_cast<int>(seed % 4);
    for (int i = 0; i < count; ++i)
        result.bodies.push_back(with_statics && i < 2 ? Body() : random.body());
    for (int i = 0; i < 2 * count; ++i) {
        BodyContact c;
        c.body1 = static_cast<int>(random.uniform(0, count));
        c.body2 = (c.body1 + 1 + static_cast<int>(random.uniform(0, count - 1))) % count;
        c.point = random.vector();
        c.normal = random.unit_vector();
        c.depth = random.uniform(0, 1);
        const Matrix3d K = impulse_matrix_of(result.bodies, c);
        const double share = random.uniform(0, 1);
        const double nKn = c.normal.dot(K * c.normal);
        if (nKn > 0) c.friction = share * std::sqrt(nKn / (K.trace() - nKn));
        result.contacts.push_back(c);
    }
    return result;
}

/// A pile of balls of different sizes, some of which touch each other, and a static body. For balls
/// K does not couple normal and tangential motion, so the impulse does not jump where a contact
/// starts to slide.
inline ContactCase pile_of_balls(unsigned seed)
{
    Random random(seed);
    ContactCase pile;
    std::vector<double> radii;
    for (int i = 0; i < 6; ++i) {
        radii.push_back(random.uniform(0.5, 1));
        pile.bodies.push_back(random.body());
        pile.bodies[i].inverse_inertia =
            2.5 * pile.bodies[i].inverse_mass / (radii[i] * radii[i]) * Matrix3d::Identity();
        pile.bodies[i].angular_momentum = pile.bodies[i].angular_velocity *
                                          (0.4 * radii[i] * radii[i] / pile.bodies[i].inverse_mass);
    }
    pile.bodies[0] = Body();
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < i; ++j) {
            const Vector3d d = pile.bodies[i].position - pile.bodies[j].position;
            if (d.norm() > radii[i] + radii[j]) continue;
            BodyContact c = touch(i, j, radii[i] + radii[j] - d.norm());
            c.normal = d.normalized();
            c.point = pile.bodies[j].position + d * radii[j] / (radii[i] + radii[j]);
            c.friction = random.uniform(0, 1);
            pile.contacts.push_back(c);
        }
    return pile;
}

/// A rod that falls at 1 m/s and touches the ground at x = a and x = b, its ends by default. The
/// contact at a is deeper, so it is visited first.
inline ContactCase rod_on_both_ends(double a = -1, double b = 1)
{
    return {{Body(), rod(-up)}, {touch(1, 0, 0.02, {a, 0, 0}), touch(1, 0, 0.01, {b, 0, 0})}};
}

/// The sums of the upward impulses at a and b after n iterations of A5.2, whose restitution rises
/// to 0. An impulse j at x changes the velocity at y by (1 + 3 x y) j: at an end by 4 j, and at the
/// other end by -2 j.
inline std::array<double, 2> impulses_on_both_ends(int n, double a = -1, double b = 1)
{
    const double x[2] = {a, b};
    double v[2] = {-1, -1};
    std::array<double, 2> sums = {0, 0};
    for (int k = 0; k < n; ++k)
        for (int i = 0; i < 2; ++i)
            if (v[i] < 0) {
                const double j = -(k + 1.0) / n * v[i] / (1 + 3 * x[i] * x[i]);
                v[i] += (1 + 3 * x[i] * x[i]) * j;
                v[1 - i] += (1 + 3 * a * b) * j;
                sums[i] += j;
            }
    return sums;
}

/// How a case is seen from elsewhere: turned by R, moved by `shift`, and in other units.
struct View {
    Matrix3d R = Matrix3d::Identity();
    Vector3d shift = Vector3d::Zero();
    double length = 1, mass = 1, speed = 1; // the new values of 1 m, 1 kg and 1 m/s

    Vector3d velocity(const Vector3d& V) const { return speed * (R * V); }
    Vector3d impulse(const Vector3d& j) const { return mass * velocity(j); }
};

inline View random_view(Random& random)
{
    return {random.rotation(), random.vector(), random.uniform(0.5, 2), random.uniform(0.5, 2),
            random.uniform(0.5, 2)};
}

/// The whole case, seen from elsewhere.
inline ContactCase turned(ContactCase problem, const View& view)
{
    const auto& [R, shift, length, mass, speed] = view;
    for (Body& body : problem.bodies) {
        body.inverse_mass /= mass;
        body.inverse_inertia =
            (R * body.inverse_inertia * R.transpose() / (mass * length * length)).eval();
        body.position = length * (R * body.position + shift);
        body.velocity = view.velocity(body.velocity);
        body.angular_velocity = view.velocity(body.angular_velocity) / length;
        body.angular_momentum = view.impulse(body.angular_momentum) * length;
    }
    for (BodyContact& c : problem.contacts) {
        c.point = length * (R * c.point + shift);
        c.normal = (R * c.normal).eval();
        c.depth *= length;
        c.separation_speed *= speed;
        c.impulse = view.impulse(c.impulse);
    }
    return problem;
}

} // namespace rigor::testing
