// SPDX-License-Identifier: MIT
#include "release/withheld.hpp"

namespace rigor {

namespace {

constexpr JudgedFile engine_files[] = {
    {"framework/release/withheld.cpp", "all", "replaced: names the files that tell",
     "framework/release/students/withheld.cpp.txt"},
    {"framework/rigid/bodies/optimised_forms.hpp", "A4.3 A4.4 A4.10",
     "replaced: three formulas under their own names, inlined",
     "framework/release/students/optimised_forms.hpp.txt"},
    {"framework/rigid/contact/solvers/optimised_sweeps.cpp", "A5.5",
     "replaced: its contact law is the update of the formula, line by line",
     "framework/release/students/optimised_sweeps.cpp.txt"},
    {"framework/rigid/bodies/two_bodies.hpp", "A4.3 A4.10",
     "kept: two bodies in one register; its lines need rewriting to be one body's, and what they "
     "compute stands in the header of the formulas",
     ""},
    {"framework/rigid/contact/position_correction.cpp", "A5.5",
     "kept: displacements along the normal only, without friction", ""},
    {"framework/rigid/contact/solvers/newton_contact.cpp", "A5.5",
     "kept: another method, Newton's, on the engine's own data", ""},
    {"framework/rigid/contact/solvers/newton_row.hpp", "A5.5",
     "kept: the projection onto the cone with its derivative; no sweep", ""},
    {"framework/rigid/contact/solvers/one_at_a_time.cpp", "A5.2 A5.3 A5.4",
     "kept: finds who rests on whom, and calls the formulas for the rest", ""},
    {"framework/rigid/motion/free_flight.cpp", "A3.15",
     "kept: the header of the formula has the same four lines", ""},
    {"framework/rigid/motion/constant_wrench_step.cpp", "A3.16",
     "kept: a method of fourth order; the terms of second order stand in the header", ""},
    {"framework/rigid/motion/naive_rotation.cpp", "A3.3", "kept: the inverse, angles of a matrix",
     ""},
    {"framework/geometry/shapes/pose.cpp", "A3.7 A3.9",
     "kept: calls Eigen's own conversion, which students may call too", ""},
    {"framework/rigid/bodies/mass.cpp", "A2.6 A2.7 A2.8",
     "kept: closed forms of shapes that no task asks for", ""},
    {"framework/geometry/meshes/mesh_checks.cpp", "A2.13",
     "kept: the volume of a mesh, without center and inertia", ""},
    {"framework/scene/trajectory/statistics.cpp", "A0.1",
     "kept: the energy by L·ω; the header has the formula by I", ""},
    {"framework/deformable/elasticity/flow.cpp", "A6.1 A6.6",
     "kept: one line, which the header of the formula has too", ""},
    {"framework/deformable/surface/clipped_element.cpp", "A7.6 A7.7",
     "kept: clips polygons to draw them; it makes no elements and joins no vertices", ""},
};

constexpr JudgedFile tests_that_tell[] = {
    {"tests/support/mass_properties.hpp", "A2.1", "the sum over particles", ""},
    {"tests/graded/collision/colliding_pair.hpp", "A4.3 A4.4 A4.10",
     "the mechanics of a collision without the formulas", ""},
    {"tests/graded/kinematics/kinematics_modes_test.cpp", "A1.1", "w* by cross products", ""},
    {"tests/graded/kinematics/kinematics_ranges_test.cpp", "A1.1", "w* by cross products", ""},
    {"tests/graded/kinematics/kinematics_test.cpp", "A1.1", "w* by cross products", ""},
};

} // namespace

std::span<const JudgedFile> judged_files()
{
    return engine_files;
}

std::span<const JudgedFile> telling_tests()
{
    return tests_that_tell;
}

std::string_view replacement_of(std::string_view path)
{
    for (const JudgedFile& file : engine_files)
        if (file.path == path) return file.replacement;
    return "";
}

} // namespace rigor
