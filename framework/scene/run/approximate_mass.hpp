// SPDX-License-Identifier: MIT
// Mass properties of a body by a method other than the closed forms.
#pragma once

#include "scene/description/scene.hpp"

namespace rigor {

/// Mass properties of the body's parts by its `mass_method`, in the frame of the scene file. Where
/// parts overlap, the matter counts twice, as it does in the closed forms.
MassProperties approximate_mass(const BodyDescription& body);

} // namespace rigor
