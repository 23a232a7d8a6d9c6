// SPDX-License-Identifier: MIT
#include "render/gl/osmesa_context.hpp"

#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

namespace rigor {
namespace {

class OsmesaContext final : public Context {
public:
    OsmesaContext()
    {
        const std::array<int, 11> wanted = {OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            3,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            3,
                                            OSMESA_DEPTH_BITS,
                                            0,
                                            0};
        context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
        if (!context_) throw std::runtime_error("OSMesa has no OpenGL 3.3 core");
    }
    ~OsmesaContext() override { OSMesaDestroyContext(context_); }

    void make_current() override
    {
        // One pixel is enough, since everything is drawn into framebuffer objects.
        if (!OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1))
            throw std::runtime_error("OSMesa refuses its own context");
    }
    const char* name() const override { return "OSMesa"; }

private:
    OSMesaContext context_ = nullptr;
    std::array<unsigned char, 4> pixel_{};
};

} // namespace

std::unique_ptr<Context> make_osmesa_context()
{
    return std::make_unique<OsmesaContext>();
}

} // namespace rigor
