// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "pictures.hpp"
#include "render/shape_surfaces.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

using namespace rigor;

namespace {

const Vector4f red = linear_color(0.85, 0.1, 0.1), blue = linear_color(0.1, 0.2, 0.85);

Image drawn(const Picture& picture, int width = 160, int height = 120, Gl gl = default_gl())
{
    return open_renderer(width, height, gl).renderer->draw(picture);
}

/// The FNV-1a hash of an image, to compare pictures of two processes.
unsigned hash(const Image& image)
{
    unsigned h = 2166136261U;
    for (const std::uint8_t byte : image.rgba)
        h = (h ^ byte) * 16777619U;
    return h;
}

Picture full_picture()
{
    Picture picture = ball_over_ground();
    picture.boxes.push_back({Matrix3f::Identity() * 0.4F, Vector3f(1.5F, 0.4F, 0), red});
    picture.ghost_boxes.push_back(
        {Matrix3f::Identity() * 0.4F, Vector3f(1.7F, 0.6F, 0), linear_color(0.5, 0.3, 0.6, 0.3)});
    add_arrow(picture, Vector3f(0, 1, 0), Vector3f(1, 2, 0), 0.03F, blue);
    picture.texts.push_back({"ω of a ball", blue, true, {}});
    picture.texts.push_back({"box", red, false, Vector3f(1.5F, 1, 0)});
    return picture;
}

} // namespace

TEST_CASE("render: a red box is red and a blue one blue", "[render]")
{
    const Image a = drawn(box_picture(red)), b = drawn(box_picture(blue));
    REQUIRE(a.width == 160);
    REQUIRE(a.height == 120);
    REQUIRE(a.rgba.size() == 160 * 120 * 4);
    const auto* middle = a.pixel(80, 60);
    CHECK(middle[0] > middle[1] + 60);
    CHECK(middle[0] > middle[2] + 60);
    CHECK(b.pixel(80, 60)[2] > b.pixel(80, 60)[0] + 60);
    CHECK(brightness(a.pixel(2, 2)) > 600); // the sky is pale
    CHECK(largest_difference(a, b) > 60);
}

TEST_CASE("render: a ring has a hole to look through and casts its shadow", "[render]")
{
    Picture picture;
    picture.eye = Vector3f(0, 6, 0.01F);
    picture.grounds.push_back({Matrix3f::Identity(), Vector3f(0, -1, 0), true, false});
    const auto surface = std::make_shared<Surface>(surface_of(Torus{1, 0.3}));
    picture.models.push_back({surface, {{Matrix3f::Identity(), Vector3f::Zero(), red}}});
    const Image image = drawn(picture, 240, 240);
    const auto is_red = [&](const Vector3f& p) {
        const Eigen::Vector2f at = on_screen(picture, p, 240, 240);
        const auto* pixel = image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
        return pixel[0] > pixel[1] + 10; // the ground is bluish
    };
    for (int i = 0; i < 8; ++i) { // in both tones of the octants
        const float angle = 0.2F + 0.785F * static_cast<float>(i);
        const Vector3f out(std::cos(angle), 0, std::sin(angle));
        CHECK(is_red(out));
        CHECK_FALSE(is_red(0.5F * out));
        CHECK_FALSE(is_red(1.5F * out));
    }
    Picture without = picture;
    without.shadows = false;
    CHECK(largest_difference(image, drawn(without, 240, 240)) > 40);
    picture.ghost_models = std::exchange(picture.models, {});
    const Image ghost = drawn(picture, 240, 240);
    picture.ghost_models.clear();
    CHECK(largest_difference(ghost, drawn(picture, 240, 240)) > 20);
}

TEST_CASE("render: the picture stands upright", "[render]")
{
    Picture picture;
    picture.eye = Vector3f(0, 0, 8);
    picture.boxes.push_back({0.5F * Matrix3f::Identity(), Vector3f(-1.5F, 1.2F, 0), red});
    const Image image = drawn(picture);
    const Eigen::Vector2f at = on_screen(picture, Vector3f(-1.5F, 1.2F, 0.5F), 160, 120);
    CHECK(at.x() < 60); // to the left of the middle and above it
    CHECK(at.y() < 45);
    const auto* pixel = image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
    CHECK(pixel[0] > pixel[1] + 60);
    const auto* mirrored = image.pixel(static_cast<int>(at.x()), 119 - static_cast<int>(at.y()));
    CHECK(mirrored[0] < mirrored[1] + 20);
}

TEST_CASE("render: a ball casts a shadow on the ground", "[render]")
{
    const Picture picture = ball_over_ground();
    Picture without = picture;
    without.shadows = false;
    const Image shaded = drawn(picture, 320, 240), plain = drawn(without, 320, 240);
    int darker = 0, other = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
            const int change = brightness(plain.pixel(x, y)) - brightness(shaded.pixel(x, y));
            darker += change > 40;
            other += change < -3; // a shadow makes nothing brighter
        }
    CHECK(darker > 300);
    CHECK(darker < 20000);
    CHECK(other == 0);
}

TEST_CASE("render: the eight octants of a ball have two tones", "[render]")
{
    Picture picture;
    picture.eye = Vector3f(0, 0, 6);
    picture.balls.push_back({Matrix3f::Identity(), Vector3f::Zero(), blue});
    const Image image = drawn(picture, 240, 240);
    const auto tone = [&](float x, float y) {
        const Vector3f p = Vector3f(x, y, 0.9F).normalized();
        const Eigen::Vector2f at = on_screen(picture, p, 240, 240);
        return brightness(image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y())));
    };
    CHECK(tone(0.4F, 0.4F) > tone(-0.4F, 0.4F) + 60);
    CHECK(tone(-0.4F, -0.4F) > tone(0.4F, -0.4F) + 60);
}

TEST_CASE("render: a label changes pixels near its point and nowhere else", "[render]")
{
    const Picture bare = box_picture(red);
    Picture labelled = bare;
    labelled.texts.push_back({"Kreisel ω", blue, false, Vector3f(0, 1.2F, 0)});
    const Image a = drawn(bare, 320, 240), b = drawn(labelled, 320, 240);
    const Eigen::Vector2f at = on_screen(bare, Vector3f(0, 1.2F, 0), 320, 240);
    int near = 0, far = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
            if (std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y))) continue;
            const bool close = std::abs(static_cast<float>(x) - at.x()) < 60 &&
                               std::abs(static_cast<float>(y) - at.y()) < 20;
            ++(close ? near : far);
        }
    CHECK(near > 40);
    CHECK(far == 0);
}

TEST_CASE("render: a text that is not UTF-8 or endless does no harm", "[render]")
{
    Picture picture = box_picture(red);
    picture.texts.push_back({"\xff\xfe\xc3", blue, true, {}});
    picture.texts.push_back({std::string(100000, 'W'), blue, true, {}});
    picture.texts.push_back({"behind", blue, true, Vector3f(40, 30, 60)});
    picture.texts.push_back({"nowhere", blue, true, Vector3f(NAN, 0, 0)});
    CHECK(largest_difference(drawn(picture), drawn(box_picture(red))) > 0);
}

TEST_CASE("render: positions that are not numbers do no harm", "[render]")
{
    Picture picture = full_picture();
    for (const float bad : {NAN, INFINITY, -1e30F}) {
        picture.boxes.push_back({Matrix3f::Identity(), Vector3f(bad, 0, 0), red});
        picture.balls.push_back({Matrix3f::Identity() * bad, Vector3f::Zero(), red});
        add_arrow(picture, Vector3f::Zero(), Vector3f(bad, bad, 0), 0.1F, red);
    }
    CHECK(drawn(picture).rgba.size() == 160 * 120 * 4);
}

TEST_CASE("render: the same picture gives the same bits", "[render]")
{
    const OpenRenderer a = open_renderer(333, 217), b = open_renderer(333, 217);
    const Image first = a.renderer->draw(full_picture());
    a.renderer->draw(box_picture(red));
    CHECK(a.renderer->draw(full_picture()).rgba == first.rgba);
    CHECK(b.renderer->draw(full_picture()).rgba == first.rgba);
}

TEST_CASE("render: prints the hash of a picture", "[.hash]")
{
    std::printf("pixels=%08x\n", hash(drawn(full_picture(), 333, 217)));
    SUCCEED();
}

TEST_CASE("render: the number of threads that draw changes no bit", "[render]")
{
    const auto pixels = [](const std::string& output) {
        const std::size_t at = output.find("pixels=");
        REQUIRE(at != std::string::npos);
        return output.substr(at, 15);
    };
    CHECK(pixels(run_again("LP_NUM_THREADS=0", "[.hash]")) ==
          pixels(run_again("LP_NUM_THREADS=3", "[.hash]")));
}

TEST_CASE("render: OSMesa and EGL draw the same", "[render]")
{
    if (!has(Gl::osmesa) || !has(Gl::egl)) {
        WARN("only one of OSMesa and EGL was built");
        SUCCEED();
        return;
    }
    OpenRenderer osmesa = open_renderer(320, 200, Gl::osmesa),
                 egl = open_renderer(320, 200, Gl::egl);
    if (!egl.notice.empty() || egl.renderer->name().find("llvmpipe") == std::string::npos) {
        WARN("EGL draws with something else here: " << egl.notice << egl.renderer->name());
        SUCCEED();
        return;
    }
    CHECK(osmesa.notice.empty());
    CHECK(osmesa.renderer->name().starts_with("OSMesa"));
    CHECK(egl.renderer->name().starts_with("EGL"));
    const Picture picture = full_picture();
    CHECK(largest_difference(osmesa.renderer->draw(picture), egl.renderer->draw(picture)) <= 1);
}

TEST_CASE("render: says that EGL has no driver and draws with OSMesa", "[.without_egl]")
{
    OpenRenderer opened = open_renderer(64, 48, Gl::egl);
    CHECK(opened.renderer->name().starts_with("OSMesa"));
    CHECK(opened.notice ==
          "cannot draw with egl: EGL has no surfaceless display; drawing with osmesa");
    CHECK(opened.renderer->draw(box_picture(red)).width == 64);
}

TEST_CASE("render: where one way to draw is missing the other is taken", "[render]")
{
    if (!has(Gl::osmesa) || !has(Gl::egl)) {
        SUCCEED();
        return;
    }
    const std::string output = run_again("__EGL_VENDOR_LIBRARY_DIRS=/nowhere", "[.without_egl]");
    INFO(output);
    CHECK(output.ends_with("status=0"));
    CHECK(output.find("All tests passed") != std::string::npos);
}

TEST_CASE("renderer: a ghost is not seen where it lies in a body's own faces", "[render]")
{
    Picture picture = box_picture(linear_color(0.2, 0.4, 0.8));
    picture.shadows = false;
    const Image alone = drawn(picture, 240, 240);
    Instance ghost = picture.boxes[0];
    ghost.color = linear_color(0.4, 0.3, 0.6, 0.34);
    ghost.axes *= 1 + 1e-7F; // the same except for rounding
    picture.ghost_boxes.push_back(ghost);
    const Image with_ghost = drawn(picture, 240, 240);
    const std::uint8_t *body = alone.pixel(120, 120), *same = with_ghost.pixel(120, 120);
    CHECK(std::equal(body, body + 4, same));
    int different = 0; // its outline may be seen, half a pixel wide
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 240; ++x)
            different +=
                !std::equal(alone.pixel(x, y), alone.pixel(x, y) + 4, with_ghost.pixel(x, y));
    CHECK(different < 4 * 240);

    picture.ghost_boxes[0].axes *= 1.01F;
    CHECK(largest_difference(alone, drawn(picture, 240, 240)) > 20);
}

TEST_CASE("render: any size that fits is drawn and others are refused", "[render]")
{
    const Picture picture = full_picture();
    for (const auto& [width, height] : {std::pair(1, 1), {1, 77}, {333, 1}, {641, 359}}) {
        const Image image = drawn(picture, width, height);
        CHECK(image.width == width);
        CHECK(image.height == height);
        CHECK(image.rgba.size() == 4UL * width * height);
        CHECK(brightness(image.pixel(0, 0)) > 0);
    }
    for (const auto& [width, height] :
         {std::pair(0, 10), {10, 0}, {-1, 10}, {8193, 10}, {8192, 8192}, {1 << 30, 1 << 30}})
        CHECK_THROWS_AS(open_renderer(width, height), InputError);
    CHECK_THROWS_WITH(
        open_renderer(20000, 100),
        "size: expected from 1x1 to 8192x8192, and no more pixels than 7680x4320 has, "
        "found 20000x100");
    CHECK_THROWS_AS(gl_from_text("vulkan"), InputError);
}
