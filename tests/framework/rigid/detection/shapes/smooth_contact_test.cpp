// SPDX-License-Identifier: MIT
#include "framework/rigid/contact_shapes.hpp"
#include "rigid/detection/shapes/smooth_contact.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("smooth contact: an ellipsoid over a plane field touches at its lowest point", "[rigid]")
{
    Counters counters;
    const Shape ground = Box{{20, 2, 20}}; // its top is at y = 1
    const DistanceField field(ground, counters);
    const Ellipsoid egg{{0.5, 0.25, 0.35}};
    for (unsigned seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Pose pose{random.rotation(), {0, 0, 0}};
        const double below = reach_along(egg, -pose.R.row(1).transpose());
        pose.X.y() = 1 + below + 0.01;
        std::vector<Contact> contacts;
        find_smooth_contacts(egg, pose, field, 0.05, contacts);
        REQUIRE(contacts.size() == 1);
        REQUIRE_THAT(contacts[0].gap, IsClose(0.01, Order(1e-9)));
        REQUIRE_THAT(contacts[0].normal, IsClose(Vector3d(0, 1, 0), Order(1e-6)));
        REQUIRE_THAT(contacts[0].point.y(), IsClose(1.005, Order(1e-9)));
        contacts.clear();
        find_smooth_contacts(egg, pose, field, 0.009, contacts);
        REQUIRE(contacts.empty());
    }
}
