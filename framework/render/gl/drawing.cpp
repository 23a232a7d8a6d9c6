// SPDX-License-Identifier: MIT
// Draws a picture with OpenGL. First comes the shadow map, which contains depths seen from the sun.
// Then come all opaque objects: bodies, overlays, grounds and background. Then come the translucent
// bodies of a second run (ghosts), the grid of a scene without a plane and the parts of overlays
// behind bodies. Last come the letters on the resolved pixels. Shaders, meshes and maps are made
// when the first picture needs them, and are kept.
#include "render/gl/drawing.hpp"

#include "render/gl/ground_mesh.hpp"
#include "render/gl/lettering.hpp"
#include "render/gl/light.hpp"
#include "render/gl/mesh.hpp"
#include "render/gl/shaders/program.hpp"
#include "render/gl/target.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace rigor {
namespace {

void send(std::optional<DeformedDrawing>& deformed, std::span<const DeformedVertex> triangles)
{
    if (!triangles.empty() && !deformed) deformed.emplace();
    if (deformed) deformed->send(triangles);
}

class Drawing final : public Renderer {
public:
    Drawing(std::unique_ptr<Context> context, int width, int height)
        : width_(width), height_(height), context_(current(std::move(context))),
          parts_(std::make_unique<Parts>(width, height))
    {
    }
    ~Drawing() override
    {
        context_->make_current(); // the parts have to be deleted in their context
        parts_.reset();
    }

    Image draw(const Picture& picture) override;
    std::string name() const override
    {
        context_->make_current();
        return std::string(context_->name()) + ", " +
               reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    }

private:
    enum class Solid { cube, coarse_ball, ball, fine_ball, rod, cone, count };
    struct Parts {
        Parts(int width, int height) : target(width, height) {}
        Target target;
        GlBuffer view;
        GlArrays no_attributes;
        FlatDrawing ground;
        std::optional<DeformedDrawing> deformed, ghost_deformed;
        std::optional<ShadowMap> shadow_map;
        std::optional<Lettering> lettering;
        std::map<std::string, Program> programs;
        std::array<std::optional<SolidDrawing>, static_cast<std::size_t>(Solid::count)> meshes;
        std::map<std::shared_ptr<const Surface>, SolidDrawing> surfaces;
    };

    static std::unique_ptr<Context> current(std::unique_ptr<Context> context)
    {
        context->make_current();
        return context;
    }
    const Program& use(Look look, const std::string& definitions);
    void draw_solids(Solid solid, std::span<const Instance> instances);
    void draw_balls(const Picture& picture, std::span<const Instance> balls);
    void draw_models(std::span<const Model> models, Look look, const std::string& definitions);
    void draw_deformed(const std::optional<DeformedDrawing>& deformed,
                       const std::string& definitions);
    void draw_shadows(const Picture& picture);
    void draw_bodies(const Picture& picture);
    void draw_ghosts(const Picture& picture);
    void draw_overlays(const Picture& picture, const std::string& definitions);
    void draw_grounds(const Picture& picture, const View& view, bool solid);

    int width_, height_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<Parts> parts_;
    std::string shadows_; // shader definitions: SHADOWS if this picture has shadows
};

const Program& Drawing::use(Look look, const std::string& definitions)
{
    const std::string key = std::to_string(static_cast<int>(look)) + definitions;
    auto known = parts_->programs.find(key);
    if (known == parts_->programs.end())
        known = parts_->programs.try_emplace(key, look, definitions).first;
    known->second.use();
    return known->second;
}

void Drawing::draw_solids(Solid solid, std::span<const Instance> instances)
{
    if (instances.empty()) return;
    auto& mesh = parts_->meshes[static_cast<std::size_t>(solid)];
    if (!mesh) {
        if (solid == Solid::cube)
            mesh.emplace(cube_mesh());
        else if (solid == Solid::rod || solid == Solid::cone)
            mesh.emplace(rod_mesh(solid == Solid::cone));
        else
            mesh.emplace(ball_mesh(solid == Solid::coarse_ball ? 2 : solid == Solid::ball ? 3 : 5));
    }
    mesh->draw(instances);
}

/// Draws balls with three levels of detail, chosen by the radius on the screen.
void Drawing::draw_balls(const Picture& picture, std::span<const Instance> balls)
{
    std::array<std::vector<Instance>, 3> by_detail;
    const float pixels_at_1 =
        static_cast<float>(height_) * 40 / std::max(picture.field_of_view, 1.0F);
    for (const Instance& ball : balls) {
        const float away = std::max((ball.position - picture.eye).norm(), 1e-6F);
        const float pixels = ball.axes.colwise().norm().maxCoeff() / away * pixels_at_1;
        by_detail[pixels < 8 ? 0 : pixels < 40 ? 1 : 2].push_back(ball);
    }
    draw_solids(Solid::coarse_ball, by_detail[0]);
    draw_solids(Solid::ball, by_detail[1]);
    draw_solids(Solid::fine_ball, by_detail[2]);
}

void Drawing::draw_models(std::span<const Model> models, Look look, const std::string& definitions)
{
    for (const Model& model : models) {
        if (model.instances.empty()) continue;
        const std::string contrast = std::to_string(model.surface->contrast);
        use(look, look == Look::model ? definitions + "#define CONTRAST " + contrast + "\n" : "");
        auto known = parts_->surfaces.find(model.surface);
        if (known == parts_->surfaces.end())
            known = parts_->surfaces.try_emplace(model.surface, model.surface->triangles).first;
        known->second.draw(model.instances);
    }
}

void Drawing::draw_deformed(const std::optional<DeformedDrawing>& deformed,
                            const std::string& definitions)
{
    if (!deformed) return;
    use(Look::model, definitions + "#define CONTRAST 0.0\n#define TINT smooth\n");
    deformed->draw();
}

void Drawing::draw_shadows(const Picture& picture)
{
    shadows_.clear();
    const bool has_casters = !picture.boxes.empty() || !picture.balls.empty() ||
                             !picture.models.empty() || !picture.deformed.empty();
    if (!picture.shadows || !has_casters) return;
    shadows_ = "#define SHADOWS\n";
    if (!parts_->shadow_map) parts_->shadow_map.emplace();
    parts_->shadow_map->start();
    use(Look::shadow, "");
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, 2.0F); // without an offset, faces would cast shadows on themselves
    draw_solids(Solid::cube, picture.boxes);
    draw_solids(Solid::ball, picture.balls);
    draw_models(picture.models, Look::shadow, "");
    use(Look::shadow, "");
    if (parts_->deformed) parts_->deformed->draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
    parts_->shadow_map->bind();
}

void Drawing::draw_bodies(const Picture& picture)
{
    if (!picture.boxes.empty()) {
        use(Look::box, shadows_);
        draw_solids(Solid::cube, picture.boxes);
    }
    if (!picture.balls.empty()) {
        use(Look::ball, shadows_);
        draw_balls(picture, picture.balls);
    }
    draw_models(picture.models, Look::model, shadows_);
    draw_deformed(parts_->deformed, shadows_);
}

void Drawing::draw_ghosts(const Picture& picture)
{
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0F, 4.0F); // avoids flicker where faces of a ghost and a body coincide
    if (!picture.ghost_boxes.empty()) {
        use(Look::box, "#define GHOST\n");
        draw_solids(Solid::cube, picture.ghost_boxes);
    }
    if (!picture.ghost_balls.empty()) {
        use(Look::ball, "#define GHOST\n");
        draw_balls(picture, picture.ghost_balls);
    }
    draw_models(picture.ghost_models, Look::model, "#define GHOST\n");
    draw_deformed(parts_->ghost_deformed, "#define GHOST\n");
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void Drawing::draw_overlays(const Picture& picture, const std::string& definitions)
{
    if (picture.rods.empty() && picture.cones.empty() && picture.dots.empty()) return;
    use(Look::overlay, definitions);
    draw_solids(Solid::rod, picture.rods);
    draw_solids(Solid::cone, picture.cones);
    draw_solids(Solid::coarse_ball, picture.dots);
}

void Drawing::draw_grounds(const Picture& picture, const View& view, bool solid)
{
    for (const Ground& ground : picture.grounds) {
        if (ground.solid != solid) continue;
        const Vector3f local = ground.axes.transpose() * (picture.target - ground.position);
        const Vector3f origin = ground.axes * Vector3f(local.x(), 0, local.z()) + ground.position;
        const float half = 9 * camera_distance(picture);
        const GroundPieces pieces = ground_pieces(ground, origin, half, view, !shadows_.empty());
        const auto draw_piece = [&](const std::vector<Spot>& piece, const std::string& shadows) {
            if (piece.empty()) return;
            const Program& program = use(Look::ground, shadows);
            const auto vector = [&](const char* name, const Vector3f& v) {
                glUniform3fv(program.uniform(name), 1, v.data());
            };
            vector("origin", origin);
            vector("along_x", ground.axes.col(0));
            vector("along_z", ground.axes.col(2));
            vector("up", ground.axes.col(1));
            const float spacing = picture.grid_spacing;
            glUniform4f(program.uniform("lines"), 1 / spacing, 1 / half, local.x() / spacing,
                        local.z() / spacing);
            glUniform1i(program.uniform("solid"), ground.solid);
            glUniform1i(program.uniform("grid"), ground.grid);
            parts_->ground.draw(piece);
        };
        draw_piece(pieces.shaded, shadows_);
        draw_piece(pieces.plain, "");
    }
}

Image Drawing::draw(const Picture& picture)
{
    context_->make_current();
    const View view = view_of(picture, width_, height_);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, parts_->view);
    glBufferData(GL_UNIFORM_BUFFER, sizeof view, &view, GL_STREAM_DRAW);

    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE); // both sides cast shadows
    send(parts_->deformed, picture.deformed);
    send(parts_->ghost_deformed, picture.ghost_deformed);
    draw_shadows(picture);

    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW); // since the projection's y points down the screen
    parts_->target.start();
    draw_bodies(picture);
    draw_overlays(picture, "");
    draw_grounds(picture, view, true);
    use(Look::background, "");
    glDisable(GL_CULL_FACE);
    glBindVertexArray(parts_->no_attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw_ghosts(picture);
    glDepthMask(GL_FALSE);
    draw_grounds(picture, view, false);
    glDepthFunc(GL_GREATER);
    draw_overlays(picture, "#define THROUGH\n");

    parts_->target.resolve();
    if (!picture.texts.empty() || picture.color_scale) {
        if (!parts_->lettering) parts_->lettering.emplace(width_, height_);
        parts_->lettering->draw(picture, view);
    }
    return parts_->target.read();
}

} // namespace

std::unique_ptr<Renderer> make_drawing(std::unique_ptr<Context> context, int width, int height)
{
    return std::make_unique<Drawing>(std::move(context), width, height);
}

} // namespace rigor
