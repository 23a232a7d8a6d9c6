// SPDX-License-Identifier: MIT
// A5.2, A5.4 and A5.5, contact by contact as their definitions say, with every kind of body and
// contact: static bodies that move and turn, rods, point masses, gaps, equal depths, any separation
// speed, any levels, and numbers of iterations up to tens of thousands. There is no friction, so
// that an impulse changes continuously with the velocities and the definition leaves no choice.
#include "contact_laws.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <numeric>

namespace rigor::testing::contact_definition_test {

namespace {

Body any_body(Random& random)
{
    if (random.bits() % 4 == 0) {
        Body body = static_body(random);
        if (random.bits() % 3 == 0) body.velocity.setZero();
        if (random.bits() % 3 == 0) body.angular_velocity.setZero();
        if (random.bits() % 3 == 0) body.position.setZero();
        return body;
    }
    Body body = random.body();
    const Vector3d d = random.unit_vector();
    if (random.bits() % 4 == 0)
        body.inverse_inertia = 3 * (Matrix3d::Identity() - d * d.transpose());
    if (random.bits() % 4 == 0) body.inverse_inertia.setZero();
    return body;
}

// Makes a contact a relative of another one, which has the same bodies: the same contact seen from
// the other body, or one with another normal, or with its point on the opposite side of a body.
BodyContact relative_of(BodyContact c, const Bodies& bodies, Random& random)
{
    switch (random.bits() % 4) {
    case 0:
        std::swap(c.body1, c.body2);
        c.normal = -c.normal;
        break;
    case 1:
        c.normal = random.bits() % 2 == 0 ? Vector3d(-c.normal) : random.unit_vector();
        break;
    case 2:
        c.point = 2 * bodies[random.bits() % 2 == 0 ? c.body1 : c.body2].position - c.point;
        break;
    default:
        break; // the same contact again
    }
    return c;
}

// A place whose coordinates are short numbers, so that their differences are exact.
Vector3d short_numbers(const Vector3d& x)
{
    return (0x1p16 * x).array().round() / 0x1p16;
}

// Three to six bodies with two contacts for each of them, in every eighth case ten. Some of them
// have the same depth, and some the same point, and some are relatives of the one before them. In
// half of the cases they are sorted by their depths, up or down, where only equal depths show an
// order that is not that of the list.
ContactCase any_case(Random& random)
{
    ContactCase result;
    const std::size_t count = 3 + random.bits() % 4;
    for (std::size_t i = 0; i < count; ++i) {
        result.bodies.push_back(any_body(random));
        result.bodies.back().position = short_numbers(result.bodies.back().position);
    }
    const std::size_t contacts = (random.bits() % 8 == 0 ? 10 : 2) * count;
    const Vector3d shared_point = short_numbers(random.vector());
    for (std::size_t i = 0; i < contacts; ++i) {
        const int body1 = random_index(random, count);
        const int body2 = (body1 + 1 + random_index(random, count - 1)) % static_cast<int>(count);
        BodyContact c = touch(body1, body2, random.uniform(-1, 1), short_numbers(random.vector()));
        if (random.bits() % 3 == 0) c.depth = std::round(2 * c.depth) / 2;
        if (random.bits() % 3 == 0) c.point = shared_point;
        c.normal = random.unit_vector();
        if (random.bits() % 3 != 0) c.separation_speed = random.uniform(-1, 1);
        if (i > 0 && random.bits() % 3 == 0)
            c = relative_of(result.contacts.back(), result.bodies, random);
        result.contacts.push_back(c);
    }
    const double up = static_cast<double>(random.bits() % 4) - 1; // -1, 0, 1 or 2
    if (std::abs(up) == 1)
        std::stable_sort(result.contacts.begin(), result.contacts.end(),
                         [&](const BodyContact& a, const BodyContact& b) {
                             return up * a.depth < up * b.depth;
                         });
    return result;
}

double approach(const Bodies& bodies, const BodyContact& c)
{
    return velocity_of(bodies, c).dot(c.normal) - c.separation_speed; // uₙ
}

// The change of uₙ by a unit impulse. @param is_held  for each body
double softness(const Bodies& bodies, const BodyContact& c, const std::vector<bool>& is_held)
{
    double nKn = 0;
    for (const int i : {c.body1, c.body2})
        if (!is_held[i]) nKn += c.normal.dot(response_at(bodies[i], c.point) * c.normal);
    return nKn;
}

// The impulse j acts along the normal of contact i.
void push(ContactResult& state, const ContactCase& problem, std::size_t i, double j,
          const std::vector<bool>& is_held)
{
    const BodyContact& c = problem.contacts[i];
    const Vector3d impulse = j * c.normal;
    if (!is_held[c.body1]) state.bodies[c.body1] = kicked(state.bodies[c.body1], c.point, impulse);
    if (!is_held[c.body2]) state.bodies[c.body2] = kicked(state.bodies[c.body2], c.point, -impulse);
    state.impulses[i] += impulse;
}

// Resolves the contacts of this list one at a time, the deepest first, in n iterations.
void resolve(ContactResult& state, const ContactCase& problem, std::vector<std::size_t> list,
             const std::vector<bool>& is_held, int n)
{
    std::stable_sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
        return problem.contacts[a].depth > problem.contacts[b].depth;
    });
    for (int k = 0; k < n; ++k)
        for (const std::size_t i : list) {
            const double u_n = approach(state.bodies, problem.contacts[i]);
            const double nKn = softness(state.bodies, problem.contacts[i], is_held);
            if (u_n < 0 && nKn > 0) push(state, problem, i, -(k + 1.0) / n * u_n / nKn, is_held);
        }
}

ContactResult start_of(const ContactCase& problem)
{
    return {problem.bodies, std::vector<Vector3d>(problem.contacts.size(), Vector3d::Zero())};
}

ContactResult one_at_a_time(const ContactCase& problem, int n)
{
    ContactResult state = start_of(problem);
    std::vector<std::size_t> all(problem.contacts.size());
    std::iota(all.begin(), all.end(), 0);
    resolve(state, problem, all, std::vector<bool>(problem.bodies.size(), false), n);
    return state;
}

int higher_level(const BodyContact& c, const std::vector<int>& levels)
{
    return std::max(levels[c.body1], levels[c.body2]);
}

ContactResult level_by_level(const ContactCase& problem, const std::vector<int>& levels, int n)
{
    ContactResult state = start_of(problem);
    const int highest = *std::max_element(levels.begin(), levels.end());
    for (int level = 1; level <= highest; ++level) {
        std::vector<std::size_t> list;
        for (std::size_t i = 0; i < problem.contacts.size(); ++i)
            if (higher_level(problem.contacts[i], levels) == level) list.push_back(i);
        std::vector<bool> is_held;
        for (const int body_level : levels)
            is_held.push_back(body_level < level);
        resolve(state, problem, list, is_held, n);
    }
    return state;
}

// The warm starts along the normals, and then the sweeps.
ContactResult simultaneously(const ContactCase& problem, int sweeps)
{
    ContactResult state = start_of(problem);
    const std::vector<bool> is_held(problem.bodies.size(), false);
    const auto between_static = [&](const BodyContact& c) {
        return problem.bodies[c.body1].is_static() && problem.bodies[c.body2].is_static();
    };
    for (std::size_t i = 0; i < problem.contacts.size(); ++i)
        if (const BodyContact& c = problem.contacts[i]; !between_static(c))
            push(state, problem, i, c.impulse.dot(c.normal), is_held);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
            const BodyContact& c = problem.contacts[i];
            if (between_static(c)) continue;
            const double before = state.impulses[i].dot(c.normal);
            const double nKn = softness(state.bodies, c, is_held);
            const double j_n = std::max(0.0, before - approach(state.bodies, c) / nKn);
            push(state, problem, i, j_n - before, is_held);
        }
    return state;
}

// An impact without friction never brings two motions farther apart, measured by their kinetic
// energy, so the rounding of the visits adds up.
void check_impulses(const ContactCase& problem, const ContactResult& result,
                    const ContactResult& expected, int visits)
{
    check_count(result.impulses.size(), expected.impulses.size(), "impulses, one for each contact");
    const double size = impulse_size(problem, expected);
    REQUIRE_THAT(result.impulses, IsClose(expected.impulses, Rounding(64.0 * (1 + visits), size)));
}

int visits(const ContactCase& problem, int n)
{
    return n * static_cast<int>(problem.contacts.size());
}

// A light body on the ground and a heavy one on it fall at 1 m/s. The heavy body is n times as
// heavy, so that about n iterations are needed to stop both.
//
// @param resolve, definition  compute the ContactResult from a ContactCase and n
template <class Resolve, class Definition>
void check_many_iterations(const Resolve& resolve, const Definition& definition)
{
    for (const int n : {30, 120, 600, 3000, 25'000}) {
        CAPTURE(n);
        const ContactCase problem = stack({1, static_cast<double>(n)});
        check_impulses(problem, resolve(problem, n), definition(problem, n), visits(problem, n));
    }
}

} // namespace

TEST_CASE("contact: one at a time as the definition says", "[A5.2][contact]")
{
    for (Random random : seeds(150)) {
        const ContactCase problem = any_case(random);
        for (const int n : {1, 2, 3, 10}) {
            CAPTURE(n);
            const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, n);
            check_impulses(problem, result, one_at_a_time(problem, n), visits(problem, n));
            check_bookkeeping(problem, result, visits(problem, n));
        }
    }
}

TEST_CASE("contact: level by level as the definition says", "[A5.4][contact]")
{
    for (Random random : seeds(150)) {
        const ContactCase problem = any_case(random);
        std::vector<int> levels; // any from 0 to 3, also for static bodies
        for (std::size_t i = 0; i < problem.bodies.size(); ++i)
            levels.push_back(random_index(random, 4));
        CAPTURE(levels);
        for (const int n : {1, 2, 3, 10}) {
            CAPTURE(n);
            const ContactResult result =
                shock_propagation(problem.bodies, problem.contacts, levels, n);
            check_impulses(problem, result, level_by_level(problem, levels, n), visits(problem, n));
            check_bookkeeping(problem, result, visits(problem, n),
                              [&](int body, const BodyContact& c) {
                                  const int level = higher_level(c, levels);
                                  return level > 0 && levels[body] == level;
                              });
        }
    }
}

TEST_CASE("contact: simultaneously as the definition says", "[A5.5][contact]")
{
    for (Random random : seeds(150)) {
        ContactCase problem = any_case(random);
        for (BodyContact& c : problem.contacts)
            if (random.bits() % 2 == 0) c.impulse = random.uniform(-0.5, 0.5) * c.normal;
        for (const int sweeps : {0, 1, 2, 10}) {
            CAPTURE(sweeps);
            const ContactResult result =
                resolve_simultaneously(problem.bodies, problem.contacts, sweeps);
            const int all = visits(problem, sweeps + 1);
            check_impulses(problem, result, simultaneously(problem, sweeps), all);
            check_bookkeeping(problem, result, all);
        }
    }
}

TEST_CASE("contact: one at a time any number of iterations counts", "[A5.2][contact]")
{
    check_many_iterations(
        [](const ContactCase& problem, int n) {
            return resolve_contacts(problem.bodies, problem.contacts, n);
        },
        one_at_a_time);
}

TEST_CASE("contact: on one level any number of iterations counts", "[A5.4][contact]")
{
    const std::vector<int> levels = {0, 1, 1};
    check_many_iterations(
        [&](const ContactCase& problem, int n) {
            return shock_propagation(problem.bodies, problem.contacts, levels, n);
        },
        [&](const ContactCase& problem, int n) { return level_by_level(problem, levels, n); });
}

TEST_CASE("contact: simultaneously any number of sweeps counts", "[A5.5][contact]")
{
    check_many_iterations(
        [](const ContactCase& problem, int n) {
            return resolve_simultaneously(problem.bodies, problem.contacts, n);
        },
        simultaneously);
}

} // namespace rigor::testing::contact_definition_test
