// SPDX-License-Identifier: MIT
#pragma once

namespace rigor {

/// An OpenGL 3.3 core context without a window. Each drawing module makes it in its own way.
class Context {
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    virtual void make_current() = 0;
    virtual const char* name() const = 0;
};

} // namespace rigor
