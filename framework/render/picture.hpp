// SPDX-License-Identifier: MIT
// What to draw: lists of solids, arrows and texts, without OpenGL and without physics.
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

/// A unit solid at its place in the scene: its point p goes to axes p + position. The columns of
/// `axes` are orthogonal. Their lengths scale the solid: for example, they are half the edges of a
/// box, or the semi-axes of a ball.
struct Instance {
    Matrix3f axes = Matrix3f::Identity();
    Vector3f position = Vector3f::Zero(); // [m]
    Vector4f color = Vector4f::Ones();    // linear red, green, blue, opacity
};

/// Cosine of 30 degrees. The edge between two triangles is sharp if their normals differ by more.
inline constexpr double smooth = 0.866;

/// A corner of a triangle.
struct SurfaceVertex {
    Vector3f position, normal;
    /// Distances to the three sides of the triangle [m]; a large number for a side that is not
    /// sharp. Side i runs from corner i to the next corner.
    Vector3f edges = Vector3f::Constant(1e6F);
};

/// Triangles with three vertices each. Positions are relative to the middle of the bounding box.
struct Surface {
    std::vector<SurfaceVertex> triangles;
    /// A surface has two tones, which alternate from octant to octant and show the rotation of a
    /// round body. This is the contrast between them. If it is 0, both tones are the same.
    float contrast = 0;
    Vector3f center = Vector3f::Zero(); // middle of the bounding box in the shape's frame [m]
    float radius = 0;                   // largest distance of a vertex from `center` [m]
};

/// One surface and all its instances. The axes of the instances are rotations.
struct Model {
    std::shared_ptr<const Surface> surface;
    std::vector<Instance> instances;
};

/// A corner of a triangle of a surface that deforms, in world space.
struct DeformedVertex {
    Vector3f position, normal;                 // [m]
    Vector3f edges = Vector3f::Constant(1e6F); // as in SurfaceVertex
    Vector4f color = Vector4f::Ones();         // linear red, green, blue, opacity
};

/// A bar of colors with the numbers that they stand for, in a strip at the right border. The scene
/// is drawn smaller, to the left of the strip.
struct ColorScale {
    std::string title;            // the quantity and its unit
    std::vector<Vector4f> colors; // from the low end of the bar to its high end, linear light
    struct Tick {
        float place = 0; // 0 at the low end, 1 at the high end
        std::string text;
    };
    std::vector<Tick> ticks;
};

/// A plane through `position` with a grid of lines. Its normal is the y axis (column 1) of `axes`.
struct Ground {
    Matrix3f axes = Matrix3f::Identity(); // a rotation
    Vector3f position = Vector3f::Zero(); // [m]
    bool solid = true; // false if only grid and shadows are drawn, as in a scene without a plane
    bool grid = true;
};

/// A line of text at a point of the scene or in the top left corner.
struct Text {
    std::string text; // UTF-8
    Vector4f color = Vector4f(0, 0, 0, 1);
    bool large = false;
    // The text is centered above this point. Without a value, it is the next line in the corner.
    std::optional<Vector3f> point;
};

struct Picture {
    Vector3f eye = Vector3f(4, 3, 6), target = Vector3f::Zero(); // [m]
    float field_of_view = 40;                                    // vertical [degrees]
    float grid_spacing = 1;                                      // [m]
    bool shadows = true;

    std::vector<Instance> boxes, balls;             // parts of bodies; they cast shadows
    std::vector<Model> models;                      // parts of other shapes; they cast shadows
    std::vector<Instance> ghost_boxes, ghost_balls; // translucent
    std::vector<Model> ghost_models;
    std::vector<DeformedVertex> deformed;       // corners of triangles of solids; cast shadows
    std::vector<DeformedVertex> ghost_deformed; // translucent
    // Overlays: cylinders and cones from the base at z = 0 to the tip at z = 1, and small balls.
    // An overlay is opaque, except where a body hides it: there it has the opacity of its color.
    std::vector<Instance> rods, cones, dots;
    std::vector<Ground> grounds;
    std::vector<Text> texts;
    std::optional<ColorScale> color_scale;
};

/// The linear light of an sRGB color with components from 0 to 1, opaque by default.
Vector4f linear_color(double red, double green, double blue, double opacity = 1);

/// Adds a rod of this radius between two points.
void add_rod(Picture& picture, const Vector3f& from, const Vector3f& to, float radius,
             const Vector4f& color);

/// Adds an arrow from `from` to `to`: a rod and a cone. An arrow that is too short to be seen is
/// left out.
void add_arrow(Picture& picture, const Vector3f& from, const Vector3f& to, float radius,
               const Vector4f& color);

} // namespace rigor
