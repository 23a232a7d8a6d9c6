// SPDX-License-Identifier: MIT
// A5: inputs that a special case easily swallows: normals along an axis, starting impulses without
// a normal part or with one that pulls, many supports.
#include "contact_cases.hpp"
#include "formulas/contact.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"

namespace contact_special_inputs_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("contact: all at once, a normal may point along any axis", "[A5.5][contact]")
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1, -1}) {
            CAPTURE(axis, sign);
            const Vector3d n = sign * Vector3d::Unit(axis), t = Vector3d::Unit((axis + 1) % 3);
            ContactCase problem = {{Body(), ball(1, 7 * t - n, 0.1 * n)},
                                   {touch(1, 0, 0.01, {0, 0, 0}, 0.5)}};
            problem.contacts[0].normal = n;
            const ContactResult result =
                resolve_simultaneously(problem.bodies, problem.contacts, 1);
            REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(n - 0.5 * t), Rounding(64)));
        }
}

TEST_CASE("contact: all at once, any starting impulse is applied", "[A5.5][contact]")
{
    // a start without a normal part, on a ball that separates
    ContactCase problem = {{Body(), ball(1, up)}, {touch(1, 0, 0.01, {0, 0, 0}, 0.5)}};
    problem.contacts[0].impulse = {1, 0, 0};
    const ContactResult start = resolve_simultaneously(problem.bodies, problem.contacts, 0),
                        swept = resolve_simultaneously(problem.bodies, problem.contacts, 1);
    REQUIRE_THAT(start.impulses[0], IsExactly(Vector3d(1, 0, 0)));
    REQUIRE_THAT(start.bodies[1].velocity, IsClose(Vector3d(1, 1, 0), Rounding(16)));
    REQUIRE_THAT(swept.impulses[0], IsClose(Vector3d(0, 0, 0), Rounding(32, 1)));
    REQUIRE_THAT(swept.bodies[1].velocity, IsClose(up, Rounding(32, 1)));

    // a start that pulls: it stops the lower ball, so the floor has nothing to do
    problem = {{Body(), ball(1, -up), ball(1, -up, {0, 0.3, 0})},
               {touch(1, 0, 0.01), touch(2, 1, 0.01, {0, 0.2, 0})}};
    problem.contacts[1].impulse = -up;
    const ContactResult pulled = resolve_simultaneously(problem.bodies, problem.contacts, 1);
    REQUIRE_THAT(pulled.impulses[0], IsClose(Vector3d(0, 0, 0), Rounding(32, 1)));
    REQUIRE_THAT(pulled.impulses[1], IsClose(Vector3d(0, 0, 0), Rounding(32, 1)));
}

TEST_CASE("contact: the highest of many supports decides, wherever it is listed", "[A5.3][contact]")
{
    for (const int count : {3, 7, 20, 70, 300, 1000, 66000})
        for (const int place : {0, count / 2, count})
            for (const bool is_reversed : {false, true}) {
                CAPTURE(count, place, is_reversed);
                // 0 is static, 1 rests on 0, 2 on 1; `count` bodies have level 1; one rests on all
                std::vector<std::vector<int>> rests_on = {{}, {0}, {1}};
                std::vector<int> supports;
                for (int i = 0; i < count; ++i) {
                    supports.push_back(static_cast<int>(rests_on.size()));
                    rests_on.push_back({0});
                }
                supports.insert(supports.begin() + place, 2);
                rests_on.push_back(supports);
                const int last = static_cast<int>(rests_on.size()) - 1;
                if (is_reversed) { // so that the body is reached before its supports
                    std::reverse(rests_on.begin(), rests_on.end());
                    for (std::vector<int>& below : rests_on)
                        for (int& body : below)
                            body = last - body;
                }
                std::vector<bool> is_static(rests_on.size(), false);
                is_static[is_reversed ? last : 0] = true;
                const std::vector<int> levels = contact_levels(rests_on, is_static);
                check_count(is_reversed ? levels.front() : levels.back(), 3, "levels");
            }
}

TEST_CASE("contact: a cycle is above what any of its bodies rests on", "[A5.3][contact]")
{
    for (const int count : {3, 12, 70, 300})
        for (const int which : {0, count / 2, count - 1}) {
            CAPTURE(count, which);
            // 0 is static, 1 rests on 0, 2 on 1; then a ring of bodies, one of which rests on 2
            std::vector<std::vector<int>> rests_on = {{}, {0}, {1}};
            for (int i = 0; i < count; ++i)
                rests_on.push_back({3 + (i + 1) % count});
            rests_on[3 + which].push_back(2);
            std::vector<bool> is_static(rests_on.size(), false);
            is_static[0] = true;
            const std::vector<int> levels = contact_levels(rests_on, is_static);
            for (int i = 0; i < count; ++i)
                check_count(levels[3 + i], 3, "levels");
        }
}

} // namespace contact_special_inputs_test
