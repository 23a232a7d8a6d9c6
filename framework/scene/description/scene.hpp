// SPDX-License-Identifier: MIT
// A scene as its file describes it, with its meshes. No mass and no motion has been computed yet,
// and no formula has been called.
#pragma once

#include "deformable/solid/deformable.hpp"
#include "deformable/step/deformable_world.hpp"
#include "geometry/shapes/shape.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// How the mass, the center of mass and the inertia of a body are found from its parts. The names
/// in backticks are formulas in formulas/inertia.hpp.
enum class MassMethod {
    exact,        ///< the closed forms of the parts, added by `combine`
    particles,    ///< `particle_mass_properties`, with points on a grid
    grid,         ///< `grid_mass_properties`
    samples,      ///< `sampled_mass_properties`, with random points
    bounding_box, ///< `bounding_box_mass_properties`, with the exact mass
    thin_rod,     ///< `thin_rod`, only for a cylinder
};

/// The orientation of a body shortly after the start, as seen in a film. It determines the initial
/// angular velocity.
struct LaterOrientation {
    double after = 0; // time since the start [s]
    Quaternion orientation;
};

struct BodyDescription {
    std::string name;
    std::vector<Part> parts; // in the body's own frame, as in the file
    Material material;
    Drag drag;
    std::string group; // bodies of the same group pass through each other; empty for no group
    // The only axis about which the body can turn, in world space. With the zero vector, the body
    // never turns. Without a value, it can turn about every axis.
    std::optional<Vector3d> only_axis;
    bool is_static = false;
    std::optional<Drive> drive; // the prescribed motion; such a body counts as static
    // The mass [kg], if the file has the inertia too. Otherwise the parts have densities.
    std::optional<double> mass;
    // The inertia about the center of mass [kg m²], if the file has it together with a mass. The
    // center of mass is then the origin of the frame.
    std::optional<Matrix3d> inertia;
    MassMethod mass_method = MassMethod::exact;
    // For `samples` the number of random points, for `grid` and `particles` the number of cells
    // along the longest edge of the bounding box; 0 for the default in approximate_mass.cpp.
    int mass_samples = 0;
    Vector3d position = Vector3d::Zero(); // the frame's origin in world space [m]
    Quaternion orientation;
    Vector3d velocity = Vector3d::Zero();         // velocity of the center of mass [m/s]
    Vector3d angular_velocity = Vector3d::Zero(); // world space [rad/s]
    std::optional<LaterOrientation> later;        // in the file instead of `angular_velocity`
    std::optional<Vector3d> color;                // red, green, blue in 0 … 1
};

/// A deformable solid.
struct SolidDescription {
    std::string name;
    std::shared_ptr<const TetrahedralMesh> mesh; // in the solid's own frame, as in the file
    SolidMaterial material;
    NodeIntegrator integrator = NodeIntegrator::implicit_step;
    FractureMethod fracture_method = FractureMethod::faces;
    YieldTest yield_test = YieldTest::strain;
    FlowTime flow_time = FlowTime::in_step;
    Vector3d position = Vector3d::Zero(); // the frame's origin in world space [m]
    Quaternion orientation;
    Vector3d velocity = Vector3d::Zero();         // velocity of the center of mass [m/s]
    Vector3d angular_velocity = Vector3d::Zero(); // world space [rad/s]
    std::optional<Vector3d> color;                // red, green, blue in 0 … 1
    std::vector<Handle> handles;                  // in world space, unlike the mesh
    std::vector<NodeLoad> loads;                  // in world space, unlike the mesh
};

struct Camera {
    Vector3d position = Vector3d(4, 3, 6); // [m]
    Vector3d target = Vector3d::Zero();    // the point that the camera looks at [m]
    double field_of_view = 40;             // vertical angle [degrees]
};

/// The quantity that the colors of deformable solids show.
enum class SolidColors { color, stress, plastic_strain };

/// What is drawn in addition to the bodies and solids.
struct Overlays {
    bool axes = false, angular_velocity = false, angular_momentum = false, contacts = false,
         labels = false, grid = true;
    SolidColors solids = SolidColors::color;
    // The values at the two ends of the color scale [Pa for stress, no unit for strain].
    std::optional<std::array<double, 2>> solids_range;
};

/// The settings of a scene whose file does not change them: gravity along -y.
inline Settings settings_on_earth()
{
    Settings settings;
    settings.gravity = {0, -9.81, 0}; // [m/s²]
    return settings;
}

struct Scene {
    std::string name;        // name of the file, without `.json`
    std::string description; // one sentence about what there is to see
    std::string text;        // text of the file, with the texts of its mesh files added
    std::vector<BodyDescription> bodies;
    std::vector<SolidDescription> solids;
    std::vector<Spring> springs;             // points in the frame of their body, or in the world
    std::vector<AppliedForce> forces;        // points in the bodies' frames, but see `world_forces`
    std::vector<int> world_forces;           // indices of `forces` with points in world space
    std::vector<PairLaw> pairs;              // for pairs of bodies, sorted by the bodies' indices
    Settings settings = settings_on_earth(); // the settings of the world
    double time_step = 0.01;                 // [s]
    double end = 1;                          // [s]
    double frames_per_second = 30;
    Camera camera;
    Overlays overlays;
};

/// The number of time steps until the end of the scene.
std::int64_t step_count(const Scene& scene);

/// The number of frames of the scene. The first frame, number 0, is at time 0.
std::int64_t frame_count(const Scene& scene);

/// The number of the time step whose end is nearest to the time of a frame.
std::int64_t frame_step(const Scene& scene, std::int64_t frame);

} // namespace rigor
