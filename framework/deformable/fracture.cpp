// SPDX-License-Identifier: MIT
#include "deformable/failure.hpp"

namespace rigor {
void fracture(Deformable&, Workspace&, World&) {}
} // namespace rigor
