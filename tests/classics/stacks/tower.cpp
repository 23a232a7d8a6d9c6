// SPDX-License-Identifier: MIT
// Each joint of a tower bears the weight above it (Stevin 1586, "De beghinselen der weeghconst"),
// however the masses are ordered.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: each joint of a tower bears the weight above it", "[classics]")
{
    const double h = 0.01;
    for (const std::vector<double>& masses : {std::vector<double>{1, 1, 1, 1, 1, 1},
                                              {32, 16, 8, 4, 2, 1},
                                              {1, 2, 4, 8, 16, 32},
                                              {1, 100, 1, 100, 1, 100}}) {
        CAPTURE(masses);
        std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const double y = 0.3 * static_cast<double>(i) + 0.15;
            RigidBody block = body_of(Box{{0.5, 0.3, 0.4}}, {0, y, 0}, {0, 0.5});
            set_mass(block, masses[i], block.inertia * (masses[i] / block.mass));
            bodies.push_back(block);
        }
        World world = solved(bodies);
        world.settings.optimisations.sleep = false;
        run(world, 50, h);
        std::vector<double> borne(masses.size(), 0);
        for (const ContactRecord& contact : step(world, h))
            borne[std::min(contact.body1, contact.body2)] += std::abs(contact.impulse.y()) / h;
        double above = 0;
        for (std::size_t i = masses.size(); i-- > 0;) {
            above += masses[i] * g;
            CHECK_THAT(borne[i], IsClose(above, Order(1e-5 * above)));
        }
    }
}
