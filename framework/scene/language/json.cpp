// SPDX-License-Identifier: MIT
// Builds the tree of a JSON text from the events of a parser. An iterator counts the lines while
// the parser reads, so that each value and each error knows its line.
#include "scene/language/json.hpp"

#include "errors/quotes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rigor {

namespace {

// The largest number of keys in an object, such as "meshes", which has a key for each mesh. Each
// new key is compared with all keys before it, so the limit bounds the time to read an object.
constexpr std::size_t most_keys = 1000;
// Larger texts and deeper nesting are refused: the limits bound run time and memory.
constexpr std::size_t most_values = 1'000'000, most_levels = 32;

// The number of newlines that the parser has read, and the last character.
struct Progress {
    int newlines = 0;
    char last = 0;

    // The parser reads one character past a number. A newline there still belongs to the line of
    // the number.
    int line() const { return 1 + newlines - (last == '\n' ? 1 : 0); }
};

// Reads characters and counts lines.
class CountingIterator {
public:
    // NOLINTBEGIN(readability-identifier-naming): the standard library asks for these names
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    // NOLINTEND(readability-identifier-naming)

    CountingIterator(const char* at, Progress* progress) : at_(at), progress_(progress) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++()
    {
        progress_->last = *at_;
        progress_->newlines += *at_ == '\n' ? 1 : 0;
        ++at_;
        return *this;
    }
    CountingIterator operator++(int)
    {
        const CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
    bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

private:
    const char* at_;
    Progress* progress_;
};

std::string between(const std::string& text, std::string_view before, std::string_view after)
{
    const std::size_t from = text.find(before);
    if (from == std::string::npos) return {};
    const std::size_t start = from + before.size();
    const std::size_t to = after.empty() ? std::string::npos : text.find(after, start);
    return text.substr(start, to == std::string::npos ? to : to - start);
}

// The parser's error message, rewritten as "expected …, found …". The parser says "… - unexpected
// X; expected Y" or "… - invalid Z; last read: 'W'".
std::string syntax_message(const std::string& complaint)
{
    std::string wanted = "valid JSON", found = between(complaint, "unexpected ", "; expected ");
    if (!found.empty()) {
        const std::string token = between(complaint, "; expected ", "");
        if (token == "']'" || token == "'}'")
            wanted = "',' or " + token;
        else if (token == "end of input")
            wanted = "nothing after the scene";
        else if (token == "string literal")
            wanted = "a key in quotes";
        else if (token == "'[', '{', or a literal")
            wanted = "a value";
        else if (!token.empty())
            wanted = token;
        for (const char* kind : {"string", "number"})
            if (found == fmt::format("{} literal", kind)) found = fmt::format("a {}", kind);
        if (found.find("literal") != std::string::npos) found = between(found, "", " literal");
    } else {
        const std::string reason = between(complaint, " - ", "; last read: ");
        const std::string read = between(complaint, "; last read: '", "");
        found = fmt::format("{} at {}", reason, in_quotes(read.substr(0, read.rfind('\''))));
    }
    return fmt::format("expected {}, found {}", wanted, found);
}

// Receives the parser's events and builds the tree.
class TreeBuilder {
public:
    explicit TreeBuilder(const Progress& progress) : progress_(progress) {}

    bool null() { return add(Value::Kind::null), true; }
    bool boolean(bool truth) { return add(Value::Kind::boolean).truth = truth, true; }
    bool number_integer(std::int64_t number) { return add_number(static_cast<double>(number)); }
    bool number_unsigned(std::uint64_t number) { return add_number(static_cast<double>(number)); }
    bool number_float(double number, const std::string&) { return add_number(number); }
    bool string(std::string& text)
    {
        add(Value::Kind::string).text = std::move(text);
        return true;
    }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(Value::Kind::object); }
    bool start_array(std::size_t) { return open(Value::Kind::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& name)
    {
        const std::vector<Value>& items = open_.back()->items;
        for (const Value& item : items)
            if (item.key == name)
                fail(fmt::format("expected each key once, found {} again (first in line {})",
                                 in_quotes(name), item.line));
        if (items.size() >= most_keys)
            fail(fmt::format("expected at most {} keys, found more", most_keys));
        key_ = std::move(name);
        return true;
    }

    bool parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& error)
    {
        const bool overflow = error.id == 406;
        fail(overflow ? fmt::format("expected a finite number, found {}",
                                    token.size() > 40 ? token.substr(0, 40) + "…" : token)
                      : syntax_message(error.what()));
    }

    Value root;

private:
    [[noreturn]] void fail(std::string message) const
    {
        throw Mistake{progress_.line(), std::move(message)};
    }

    Value& add(Value::Kind kind)
    {
        if (++count_ > most_values)
            fail(fmt::format("expected at most {} values, found more", most_values));
        Value& value = open_.empty() ? root : open_.back()->items.emplace_back();
        value.kind = kind;
        value.line = progress_.line();
        value.key = std::move(key_);
        key_.clear();
        return value;
    }

    bool add_number(double number)
    {
        add(Value::Kind::number).number = number;
        return true;
    }

    bool open(Value::Kind kind)
    {
        if (open_.size() >= most_levels)
            fail(fmt::format("expected at most {} levels of brackets, found more", most_levels));
        open_.push_back(&add(kind));
        return true;
    }

    bool close()
    {
        open_.pop_back();
        return true;
    }

    const Progress& progress_;
    // The arrays and objects whose end has not been read yet, from the root to the innermost. The
    // pointers stay valid, because only the innermost one gets new items.
    std::vector<Value*> open_;
    std::string key_;
    std::size_t count_ = 0;
};

} // namespace

Value parse_json(std::string_view text)
{
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw Mistake{1, "expected a JSON object, found an empty text"};
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        const auto lines = std::count(text.begin(), text.begin() + zero, '\n');
        throw Mistake{static_cast<int>(lines) + 1, "expected text, found a zero byte"};
    }
    Progress progress;
    TreeBuilder builder(progress);
    nlohmann::json::sax_parse(CountingIterator(text.data(), &progress),
                              CountingIterator(text.data() + text.size(), &progress), &builder);
    return std::move(builder.root);
}

std::string describe(const Value& value)
{
    switch (value.kind) {
    case Value::Kind::null:
        return "null";
    case Value::Kind::boolean:
        return value.truth ? "true" : "false";
    case Value::Kind::number:
        return fmt::format("{}", value.number);
    case Value::Kind::string:
        return in_quotes(value.text);
    case Value::Kind::array:
        break;
    case Value::Kind::object:
        return value.items.empty() ? "{}" : fmt::format("{{{}: …}}", in_quotes(value.items[0].key));
    }
    if (value.items.size() > 4) return fmt::format("an array of {}", value.items.size());
    std::string list;
    for (const Value& item : value.items) {
        const bool is_list = item.kind == Value::Kind::array;
        list += (list.empty() ? "" : ", ") + (is_list ? std::string("[…]") : describe(item));
    }
    return fmt::format("[{}]", list);
}

void expected(std::string_view what, const Value& found)
{
    throw Mistake{found.line, fmt::format("expected {}, found {}", what, describe(found))};
}

} // namespace rigor
