// SPDX-License-Identifier: MIT
// A grammar as tables: each key with its meaning and its reader. The documentation, the reading and
// the suggestion of the nearest key all follow from the table.
#pragma once

#include "formulas/types.hpp"
#include "scene/json.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace rigor {

/// One key of an object of type T.
template <class T> struct Key {
    std::string_view name;
    std::string_view meaning; // as documented in assignments/scenes.md
    void (*read)(T& target, const Value& value);
};

template <class T> using Keys = std::span<const Key<T>>;

/// A key as the documentation lists it.
struct KeyMeaning {
    std::string_view object, key, meaning;
};

/// @throws Mistake `unknown key "restituton"; did you mean "restitution"?`
[[noreturn]] void unknown_key(const Value& value, std::span<const std::string_view> names);

/// Reads each key of an object by its row of the table.
/// @param what  the object in an error's words: "a body"
/// @throws Mistake
template <class T>
void read_object(const Value& value, std::string_view what, Keys<T> keys, T& target)
{
    if (value.kind != Value::Kind::object) expected(what, value);
    for (const Value& item : value.items) {
        const Key<T>* row = nullptr;
        for (const Key<T>& key : keys)
            if (key.name == item.key) row = &key;
        if (!row) {
            std::vector<std::string_view> names;
            for (const Key<T>& key : keys)
                names.push_back(key.name);
            unknown_key(item, names);
        }
        row->read(target, item);
    }
}

/// The value of a key, or null.
const Value* find(const Value& object, std::string_view key);

// The readers of plain values. Each throws a Mistake that says what it expected; `what` names the
// quantity. Numbers are at most 1e12 in size, positive ones at least 1e-12, so that no product of a
// few of them overflows or vanishes.
double number(const Value& value, std::string_view what = "a number");
double positive(const Value& value, std::string_view what);
double not_negative(const Value& value, std::string_view what);
double in_range(const Value& value, std::string_view what, double low, double high);
std::int64_t integer(const Value& value, std::string_view what, std::int64_t low,
                     std::int64_t high);
bool boolean(const Value& value);
std::string line_of_text(const Value& value, std::string_view what);
Vector3d vector3(const Value& value, std::string_view what = "three numbers");
Vector3d positive3(const Value& value, std::string_view what);
Vector3d color(const Value& value);
const std::vector<Value>& array(const Value& value, std::string_view what);

/// One of several words.
std::size_t one_of(const Value& value, std::span<const std::string_view> words);

/// {"axis": …, "degrees": …}, {"quaternion": [s, x, y, z]} or {"euler_degrees": [φ, θ, ψ]}.
Quaternion orientation(const Value& value);

} // namespace rigor
