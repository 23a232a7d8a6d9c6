// SPDX-License-Identifier: MIT
// The shapes of the scene language: one reader a kind.
#pragma once

#include "scene/grammar.hpp"

#include <fmt/format.h>

namespace rigor {

struct ShapeDraft {
    MeshLibrary& meshes;
    std::optional<Shape> shape;
};

/// The keys of a shape of one kind; each of `needed` must be there.
template <class T>
T read_kind(const Value& value, Keys<T> keys, std::initializer_list<std::string_view> needed)
{
    T kind;
    read_object<T>(value, fmt::format("{{\"{}\": …}}", keys[0].name), keys, kind);
    for (const std::string_view name : needed)
        if (!find(value, name)) expected(fmt::format("a \"{}\" in the {}", name, value.key), value);
    return kind;
}

/// Refuses a length that leaves no room for another one.
inline void less(const Value& object, std::string_view key, double limit)
{
    const Value& value = *find(object, key);
    if (!(value.number < limit)) expected(fmt::format("a {} < {:.6g}", key, limit), value);
}

// Shapes that are meshes. Each throws a Mistake.
void read_ring(ShapeDraft& draft, const Value& value);
void read_cross(ShapeDraft& draft, const Value& value);
void read_bowl(ShapeDraft& draft, const Value& value);
void read_gear(ShapeDraft& draft, const Value& value);
void read_angle(ShapeDraft& draft, const Value& value);
void read_voussoir(ShapeDraft& draft, const Value& value);
void read_mesh(ShapeDraft& draft, const Value& value);

void mesh_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
