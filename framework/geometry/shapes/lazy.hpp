// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>

namespace rigor {

/// A value that is made when it is first asked for, by whichever thread asks; the others wait.
template <class T> class Lazy {
public:
    /// @param make  returns a std::unique_ptr<T>
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
