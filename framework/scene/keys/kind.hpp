// SPDX-License-Identifier: MIT
// Reads the object below the name of a kind of shape or mesh, such as the inner one in
// {"torus": {"radius": 1, "tube": 0.2}}. Each kind has keys of its own, such as "radius" or "file".
#pragma once

#include "scene/language/keys.hpp"

#include <fmt/format.h>

#include <initializer_list>

namespace rigor {

/// Reads the keys of an object of one kind. Refuses an object that lacks one of the keys `needed`.
template <class T>
T read_kind(const Value& value, Keys<T> keys, std::initializer_list<std::string_view> needed)
{
    T kind;
    read_object<T>(value, fmt::format("{{\"{}\": …}}", keys[0].name), keys, kind);
    for (const std::string_view name : needed)
        if (!find(value, name)) expected(fmt::format("a \"{}\" in the {}", name, value.key), value);
    return kind;
}

/// Refuses the length under `key` if it is not less than `limit` [m], which the caller computes
/// from another length of the object.
inline void less(const Value& object, std::string_view key, double limit)
{
    const Value& value = *find(object, key);
    if (!(value.number < limit)) expected(fmt::format("a {} < {:.6g}", key, limit), value);
}

} // namespace rigor
