// SPDX-License-Identifier: MIT
// The recorded motion of a scene. A worker writes it; it can be sent as a stream or stored, and it
// can be read while it is still being written.
//
// The format is little-endian binary. u8, u32 and u64 are unsigned integers with this number of
// bits, i32 and i64 signed ones, f32 and f64 floats. After a count, or a group of counts, follow
// the items that were counted:
//     "RIGORTRJ"  u32 version: 1 without deformable solids, 2 with
//     u32 bytes, name of the scene       u32 bytes, scene file as text
//     u32 bodies, each: u8 is_static, f64 mass, 3 f64 center of mass, 9 f64 inertia (I_body by
//         columns)
//     version 2: u32 solids
// Then follow records until the end:
//     'F'  i64 step, f64 time, bodies × 13 f64 (X, q = s x y z, V, L),
//          u32 contacts, each: i32 body1, i32 body2, f64 depth, 9 f64 (point, normal, impulse)
//          version 2, each solid: u8 whether its mesh differs from the frame before; if it does,
//              u32 nodes, u32 elements, u32 surface points, u32 surface triangles, u32 pieces,
//              elements × 4 i32 (nodes), points × (i32 element, 4 f32 weights),
//              triangles × (3 i32 points, i32 element, u8 is_crack);
//              then 13 f64 (mass, volume, kinetic energy, elastic energy, momentum, angular
//              momentum, center of mass), nodes × 6 f64 (x, v),
//              elements × 2 f32 (von Mises stress [Pa], equivalent plastic strain √(2/3) ‖ε_p‖)
//     'E'  u32 counters, each: u64, in the order of Counters. This record ends a complete run.
// A file without a record 'E' contains the run up to the last record.
#pragma once

#include "deformable/elasticity/totals.hpp"
#include "deformable/surface/surface.hpp"
#include "scene/description/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string_view>
#include <vector>

namespace rigor {

/// The mesh of a deformable solid, as far as it is needed for drawing. It changes only when the
/// solid cracks or when elements that stay inverted are separated from it.
struct SolidTopology {
    std::size_t nodes = 0;
    std::vector<std::array<int, 4>> elements; // the nodes of each element
    EmbeddedSurface surface;                  // the file stores its weights as floats
    std::size_t pieces = 0;                   // number of separate parts, which share no vertex
};

/// A deformable solid at one moment.
struct SolidFrame {
    std::shared_ptr<const SolidTopology> topology; // not null
    bool is_new_topology = true; // whether `topology` differs from that of the frame before
    DeformableTotals totals;
    std::vector<Vector3d> positions;    // one for each node, world space [m]
    std::vector<Vector3d> velocities;   // one for each node [m/s]
    std::vector<float> stresses;        // one for each element, von Mises [Pa]
    std::vector<float> plastic_strains; // one for each element, equivalent: √(2/3) ‖ε_p‖
};

/// The world at one moment.
struct Frame {
    std::int64_t step = 0;
    double time = 0; // [s]
    std::vector<RigidState> bodies;
    std::vector<ContactRecord> contacts; // contacts of the step that ends at `time`
    std::vector<SolidFrame> solids = {};
};

/// Mass and inertia of a body, as computed by the process that runs the scene (the worker).
struct RecordedBody {
    bool is_static = false;
    double mass = 0;                            // [kg], 0 if static
    Vector3d center_of_mass = Vector3d::Zero(); // in the body's frame of the scene file [m]
    Matrix3d inertia = Matrix3d::Zero();        // I_body [kg m²]
};

struct Trajectory {
    Scene scene;
    std::vector<RecordedBody> bodies;
    std::vector<Frame> frames;
    Counters counters;
    bool complete = false; // whether the record 'E' was read
};

/// The counters with their names, in the order of the record 'E'.
struct CounterField {
    std::string_view name;
    std::uint64_t Counters::*member;
};
inline constexpr CounterField counter_fields[] = {
    {"steps", &Counters::steps},
    {"substeps", &Counters::substeps},
    {"pairs possible", &Counters::pairs_possible},
    {"pairs tested", &Counters::pairs_tested},
    {"pair searches saved", &Counters::pair_searches_saved},
    {"contacts", &Counters::contacts},
    {"collision impulses", &Counters::collision_impulses},
    {"contact impulses", &Counters::contact_impulses},
    {"isotropic shortcuts", &Counters::isotropic_shortcuts},
    {"free flights", &Counters::free_flights},
    {"static skipped", &Counters::static_skipped},
    {"islands", &Counters::islands},
    {"bodies asleep", &Counters::bodies_asleep},
    {"warm starts", &Counters::warm_starts},
    {"contact sweeps", &Counters::contact_sweeps},
    {"early exits", &Counters::early_exits},
    {"Newton solves", &Counters::newton_solves},
    {"corrected contacts", &Counters::corrected_contacts},
    {"level sets built", &Counters::level_sets_built},
    {"level set samples", &Counters::level_set_samples},
    {"deformable substeps", &Counters::deformable_substeps},
    {"system solves", &Counters::system_solves},
    {"solver iterations", &Counters::solver_iterations},
    {"node impulses", &Counters::node_impulses},
    {"elements flowed", &Counters::elements_flowed},
    {"flow skipped", &Counters::flow_skipped},
    {"eigenvalues", &Counters::eigenvalues},
    {"eigenvalues skipped", &Counters::eigenvalues_skipped},
    {"cracks", &Counters::cracks},
    {"mesh changes", &Counters::mesh_changes},
};
static_assert(sizeof(Counters) == sizeof(std::uint64_t) * std::size(counter_fields));

} // namespace rigor
