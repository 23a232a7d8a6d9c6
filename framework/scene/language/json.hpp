// SPDX-License-Identifier: MIT
// A JSON text as a tree. Every value stores its line number, so that an error message can name the
// line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// An error in a text, and its line. `parse_scene` and `load_scene` add the name of the file.
struct Mistake {
    int line = 1;
    std::string message;
};

struct Value {
    enum class Kind { null, boolean, number, string, array, object };
    Kind kind = Kind::null;
    int line = 1;
    bool truth = false;
    double number = 0;
    std::string text;         // content of a string
    std::vector<Value> items; // elements of an array or object, in the order of the file
    std::string key;          // key of this value, if it is part of an object
};

/// Parses a JSON text. Limits guard against hostile texts: 1 000 000 values, 32 levels, 1000 keys
/// in one object. Every number is finite, and no object has the same key twice.
/// @throws Mistake
Value parse_json(std::string_view text);

/// A value as an error message shows it: `-3`, `"bal"`, `an array of 9`.
std::string describe(const Value& value);

/// Throws the error for an unexpected value.
/// @throws Mistake `expected …, found …` in the line of the value
[[noreturn]] void expected(std::string_view what, const Value& found);

} // namespace rigor
