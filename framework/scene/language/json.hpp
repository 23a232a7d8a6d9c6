// SPDX-License-Identifier: MIT
// A JSON text as a tree whose every value knows its line, so that an error can name it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// What is wrong with a text, and in which line. The loader adds the file's name.
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
    std::string text;         // what a string says
    std::vector<Value> items; // what an array or object holds, in the order of the file
    std::string key;          // its name, if an object holds it
};

/// The tree of a text. Limits keep hostile texts small: 1 000 000 values, 32 levels, 64 keys an
/// object. Every number is finite, no key comes twice in an object.
/// @throws Mistake
Value parse_json(std::string_view text);

/// A value in an error's words: `-3`, `"bal"`, `an array of 2`.
std::string describe(const Value& value);

/// @throws Mistake `expected …, found …` in the line of the value
[[noreturn]] void expected(std::string_view what, const Value& found);

} // namespace rigor
