// SPDX-License-Identifier: MIT
// The grammar of the scene language as tables. A row holds a key with its meaning and its reader.
// The documentation, the reader and the suggestion of the nearest key all use the tables.
#pragma once

#include "scene/language/json.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A row of a table: a key of a JSON object that is read into a T. `read` stores the value of this
/// key in the T.
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

/// Names as an error message lists them: `"sphere", "box"`.
std::string list_of(std::span<const std::string_view> names);

/// Throws the error for an unknown key.
/// @throws Mistake `unknown key "restituton"; did you mean "restitution"?`
[[noreturn]] void unknown_key(const Value& value, std::span<const std::string_view> names);

/// Reads each key of an object with the reader of its row in the table.
/// @param what  the object as an error message names it: "a body"
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

/// The value of a key, or null if the object has no such key.
const Value* find(const Value& object, std::string_view key);

/// Appends the rows of a table to the documentation of `object`.
template <class T>
void add_meanings(std::string_view object, Keys<T> keys, std::vector<KeyMeaning>& meanings)
{
    for (const Key<T>& key : keys)
        meanings.push_back({object, key.name, key.meaning});
}

} // namespace rigor
