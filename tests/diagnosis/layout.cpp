// SPDX-License-Identifier: MIT
// Encoded values become numbers and numbers become encoded values, by a description of the type.
#include "diagnosis/layout.hpp"

#include "worker/protocol/wire.hpp"

namespace rigor::diagnosis {

namespace {

bool is_leaf(Form form)
{
    return form == Form::real || form == Form::integer || form == Form::boolean ||
           form == Form::quaternion;
}

void add_roles(Encoding& type, const std::string& name, bool in_list, std::vector<Role>& roles)
{
    if (is_leaf(type.form)) {
        type.role = static_cast<int>(roles.size());
        roles.push_back({name, type.quantity, type.form, type.rows, type.columns, in_list});
        return;
    }
    const bool is_list = type.form == Form::list || type.form == Form::array;
    for (std::size_t i = 0; i < type.parts.size(); ++i) {
        std::string inner = name;
        if (is_list) inner += "[i]";
        if (type.form == Form::record) inner += (name.empty() ? "" : ".") + type.names[i];
        add_roles(type.parts[i], inner, in_list || is_list, roles);
    }
}

void decode_leaf(const Encoding& type, wire::Reader& reader, Value& value)
{
    value.leaves.push_back({type.role, value.numbers.size()});
    for (int i = 0; i < type.rows * type.columns; ++i) {
        double number = 0;
        if (type.form == Form::integer) {
            int integer = 0;
            wire::decode(reader, integer);
            number = integer;
        } else if (type.form == Form::boolean) {
            bool is_true = false;
            wire::decode(reader, is_true);
            number = is_true;
        } else {
            wire::decode(reader, number);
        }
        value.numbers.push_back(number);
    }
}

void decode_into(const Encoding& type, wire::Reader& reader, Value& value)
{
    if (is_leaf(type.form)) return decode_leaf(type, reader, value);
    if (type.form == Form::record) {
        for (const Encoding& part : type.parts)
            decode_into(part, reader, value);
        return;
    }
    std::size_t n = type.size;
    if (type.form == Form::list) {
        n = reader.count(1);
        value.sizes.push_back(n);
    } else if (type.form == Form::optional) {
        bool present = false;
        wire::decode(reader, present);
        n = present;
        value.sizes.push_back(n);
    }
    for (std::size_t i = 0; i < n; ++i)
        decode_into(type.parts[0], reader, value);
}

// Where the next number and the next size are.
struct Position {
    std::size_t number = 0, size = 0;
};

void encode_leaf(const Encoding& type, const Value& value, Position& next, Bytes& bytes)
{
    for (int i = 0; i < type.rows * type.columns; ++i) {
        const double number = value.numbers[next.number++];
        if (type.form == Form::integer)
            wire::encode(bytes, static_cast<int>(number));
        else if (type.form == Form::boolean)
            wire::encode(bytes, number != 0);
        else
            wire::encode(bytes, number);
    }
}

void encode_from(const Encoding& type, const Value& value, Position& next, Bytes& bytes)
{
    if (is_leaf(type.form)) return encode_leaf(type, value, next, bytes);
    if (type.form == Form::record) {
        for (const Encoding& part : type.parts)
            encode_from(part, value, next, bytes);
        return;
    }
    std::size_t n = type.size;
    if (type.form == Form::list) {
        n = value.sizes[next.size++];
        wire::encode(bytes, static_cast<std::uint64_t>(n));
    } else if (type.form == Form::optional) {
        n = value.sizes[next.size++];
        wire::encode(bytes, n != 0);
    }
    for (std::size_t i = 0; i < n; ++i)
        encode_from(type.parts[0], value, next, bytes);
}

} // namespace

Layout::Layout(Encoding type, const std::string& name) : encoding(std::move(type))
{
    add_roles(encoding, name, false, roles);
}

Value Layout::decode(std::span<const std::byte> bytes) const
{
    wire::Reader reader(bytes);
    Value value;
    decode_into(encoding, reader, value);
    reader.end();
    return value;
}

Bytes Layout::encode(const Value& value) const
{
    Bytes bytes;
    Position next;
    encode_from(encoding, value, next, bytes);
    return bytes;
}

std::vector<Leaf> Layout::leaves(const Value& value, int role) const
{
    std::vector<Leaf> result;
    for (const Leaf& leaf : value.leaves)
        if (leaf.role == role) result.push_back(leaf);
    return result;
}

} // namespace rigor::diagnosis
