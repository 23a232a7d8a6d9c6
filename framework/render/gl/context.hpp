// SPDX-License-Identifier: MIT
// An OpenGL 3.3 core context without a window. Each module links one source that makes it.
#pragma once

#include <memory>

namespace rigor {

class Context {
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    virtual void make_current() = 0;
    virtual const char* name() const = 0;
};

/// @throws std::runtime_error if there is no such context on this machine
std::unique_ptr<Context> make_context();

} // namespace rigor
