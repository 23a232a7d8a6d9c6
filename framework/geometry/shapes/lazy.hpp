// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>

namespace rigor {

/// A lazily computed value: the first thread that asks for it computes it, and other threads that
/// ask meanwhile wait.
template <class T> class Lazy {
public:
    /// @param make  function that computes the value and returns it as a std::unique_ptr<T>; only
    ///              the first call of `get` calls it
    template <class Make> const T& get(const Make& make) const
    {
        std::call_once(flag_, [&] { value_ = make(); });
        return *value_;
    }

private:
    mutable std::once_flag flag_;
    mutable std::unique_ptr<const T> value_;
};

} // namespace rigor
