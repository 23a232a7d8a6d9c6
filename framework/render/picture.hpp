// SPDX-License-Identifier: MIT
// What to draw: plain lists of solids, arrows and texts. It knows no OpenGL and no physics.
#pragma once

#include <Eigen/Dense>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

using Eigen::Matrix3f;
using Eigen::Vector3f;
using Eigen::Vector4f;

/// A unit solid put somewhere: its point p goes to axes p + position. The columns of `axes` are
/// orthogonal and carry the size: half edges of a box, radius or semi-axes of a ball.
struct Instance {
    Matrix3f axes = Matrix3f::Identity();
    Vector3f position = Vector3f::Zero(); // [m]
    Vector4f color = Vector4f::Ones();    // linear red, green, blue, opacity
};

/// A corner of a triangle.
struct SurfaceVertex {
    Vector3f position, normal;
    Vector3f edges =
        Vector3f::Constant(1e6F); // distances to the triangle's sharp edges; else large
};

/// Triangles about the middle of their bounds, three vertices each.
struct Surface {
    std::vector<SurfaceVertex> triangles;
    float contrast = 0; // between octants in two tones, to see a spin by where there are no edges
    Vector3f center = Vector3f::Zero(); // where the middle is in the frame it was made from [m]
    float radius = 0;                   // around the middle [m]
};

/// One surface wherever it is. The axes of its instances are rotations.
struct Model {
    std::shared_ptr<const Surface> surface;
    std::vector<Instance> instances;
};

/// A corner of a triangle of a surface that deforms, in the world.
struct DeformedVertex {
    Vector3f position, normal;                 // [m]
    Vector3f edges = Vector3f::Constant(1e6F); // as of a surface
    Vector4f color = Vector4f::Ones();         // linear red, green, blue, opacity
};

/// What colors mean: a bar with numbers in a strip at the right border. The scene is drawn smaller,
/// to the left of it.
struct ColorScale {
    std::string title;            // with the unit
    std::vector<Vector4f> colors; // from the low end up, linear
    struct Tick {
        float place = 0; // 0 at the low end, 1 at the high one
        std::string text;
    };
    std::vector<Tick> ticks;
};

/// A plane through `position`, its normal the y axis, with a grid of lines.
struct Ground {
    Matrix3f axes = Matrix3f::Identity(); // a rotation
    Vector3f position = Vector3f::Zero(); // [m]
    bool solid = true;                    // or only its lines, for a scene with nothing to land on
    bool grid = true;
};

/// A line of text, by a point of the scene or in the corner at the top left.
struct Text {
    std::string text; // UTF-8
    Vector4f color = Vector4f(0, 0, 0, 1);
    bool large = false;
    std::optional<Vector3f> point; // centered above it; without it the next line in the corner
};

struct Picture {
    Vector3f eye = Vector3f(4, 3, 6), target = Vector3f::Zero(); // [m]
    float field_of_view = 40;                                    // vertical [degrees]
    float grid_spacing = 1;                                      // [m]
    bool shadows = true;

    std::vector<Instance> boxes, balls;             // the bodies; they cast shadows
    std::vector<Model> models;                      // the other bodies; they cast shadows
    std::vector<Instance> ghost_boxes, ghost_balls; // translucent
    std::vector<Model> ghost_models;
    std::vector<DeformedVertex> deformed;       // deformable solids, three a triangle; cast shadows
    std::vector<DeformedVertex> ghost_deformed; // translucent
    // Overlays: cylinders and cones with base 0 and tip z = 1, small balls. Their opacity is that
    // of what lies behind a body; the rest is opaque.
    std::vector<Instance> rods, cones, dots;
    std::vector<Ground> grounds;
    std::vector<Text> texts;
    std::optional<ColorScale> color_scale;
};

/// Linear light of an sRGB color, opaque unless said.
Vector4f linear_color(double red, double green, double blue, double opacity = 1);

/// A rod of this radius between two points.
void add_rod(Picture& picture, const Vector3f& from, const Vector3f& to, float radius,
             const Vector4f& color);

/// An arrow from `from` to `to`: a rod and a cone. Nothing if it has no length.
void add_arrow(Picture& picture, const Vector3f& from, const Vector3f& to, float radius,
               const Vector4f& color);

} // namespace rigor
