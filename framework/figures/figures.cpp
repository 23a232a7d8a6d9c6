// SPDX-License-Identifier: MIT
#include "figures/figures.hpp"

#include "figures/collision_figures.hpp"
#include "figures/contact_figures.hpp"
#include "figures/fracture_figures.hpp"
#include "figures/inertia_figures.hpp"
#include "figures/level_set_figures.hpp"
#include "figures/motion_figures.hpp"
#include "figures/plasticity_figures.hpp"
#include "figures/rotation_figures.hpp"
#include "figures/validation_figures.hpp"

namespace rigor::figures {

std::vector<Figure> all_figures()
{
    std::vector<Figure> all;
    for (const auto part : {motion_figures(), inertia_figures(), rotation_figures(),
                            level_set_figures(), collision_figures(), contact_figures(),
                            plasticity_figures(), fracture_figures(), validation_figures()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace rigor::figures
