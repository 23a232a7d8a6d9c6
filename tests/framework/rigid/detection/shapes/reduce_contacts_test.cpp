// SPDX-License-Identifier: MIT
#include "framework/rigid/contact_shapes.hpp"
#include "rigid/detection/shapes/reduce_contacts.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE(
    "reduce contacts: of many touches eight stay that span them and one of them is the deepest",
    "[rigid]")
{
    for (unsigned seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        std::vector<Contact> touches(1, Contact{{9, 9, 9}, {0, 1, 0}, -1}); // must be left alone
        double least = 1;
        for (int i = 0; i < 200; ++i) {
            const Vector3d p = random.vector();
            touches.push_back({{p.x(), 0, p.z()}, {0, 1, 0}, 0.1 * p.y() * p.y() - 0.02});
            least = std::min(least, touches.back().gap);
        }
        reduce_contacts(touches, 1, 0.1);
        REQUIRE(touches.size() == 1 + most_contacts);
        REQUIRE(touches[0].gap == -1);
        touches.erase(touches.begin());
        REQUIRE(deepest(touches) <= least + 1e-4);
        for (const double x : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) { // some contact is kept near each corner
                double nearest = 1e9;
                for (const Contact& t : touches)
                    nearest = std::min(nearest, (t.point - Vector3d(x, 0, z)).norm());
                REQUIRE(nearest < 1.2); // the square has side 2
            }
    }
}
