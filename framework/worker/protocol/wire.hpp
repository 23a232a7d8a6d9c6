// SPDX-License-Identifier: MIT
// Encodes values as bytes: numbers, fixed-size Eigen types, containers, and structs field by field.
// Both processes run on one machine, so numbers have the same bytes as in memory. A reader trusts
// no byte: it checks every length against the bytes that are there, and accepts each value in one
// encoding only.
#pragma once

#include "formulas/fields.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rigor::wire {

/// The bytes are not a value of the expected type; the text says why.
struct Malformed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A matrix or vector of doubles whose size the type fixes.
template <class T>
concept FixedMatrix =
    std::is_base_of_v<Eigen::PlainObjectBase<T>, T> && std::is_same_v<typename T::Scalar, double> &&
    T::SizeAtCompileTime != Eigen::Dynamic;

template <class T> inline constexpr bool is_vector = false;
template <class T> inline constexpr bool is_vector<std::vector<T>> = true;
template <class T> inline constexpr bool is_array = false;
template <class T, std::size_t n> inline constexpr bool is_array<std::array<T, n>> = true;
template <class T> inline constexpr bool is_optional = false;
template <class T> inline constexpr bool is_optional<std::optional<T>> = true;
template <class T> inline constexpr bool is_pair = false;
template <class A, class B> inline constexpr bool is_pair<std::pair<A, B>> = true;

using Bytes = std::vector<std::byte>;

/// Whether every T is encoded exactly as it lies in memory: numbers, one after the other, without
/// gaps and without booleans.
template <class T> bool lies_as_encoded()
{
    if constexpr (std::is_arithmetic_v<T>) {
        return !std::is_same_v<T, bool>;
    } else if constexpr (FixedMatrix<T>) {
        return sizeof(T) == sizeof(double) * T::SizeAtCompileTime;
    } else if constexpr (is_array<T>) {
        return lies_as_encoded<typename T::value_type>();
    } else if constexpr (Plain<T>) {
        const T prototype{};
        const auto address = [](const auto& part) {
            return reinterpret_cast<const std::byte*>(&part);
        };
        std::ptrdiff_t end = 0; // where the previous field ends in the struct [bytes]
        bool lies_so = true;
        Fields<T>::each(prototype, [&](std::string_view, const auto& field) {
            using Field = std::remove_cvref_t<decltype(field)>;
            lies_so &= lies_as_encoded<Field>() && address(field) - address(prototype) == end;
            end += sizeof field;
        });
        return lies_so && end == sizeof(T);
    } else {
        return false;
    }
}

/// The result of `lies_as_encoded`, computed once for each type. If it is true, a value is copied
/// as a whole, which takes a fraction of the time that a copy field by field takes.
template <class T> inline const bool is_whole = lies_as_encoded<T>();

inline void put(Bytes& bytes, const void* data, std::size_t size)
{
    const std::byte* begin = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

/// Appends `value` to `bytes`.
template <class T> void encode(Bytes& bytes, const T& value)
{
    if constexpr (std::is_same_v<T, bool>) {
        bytes.push_back(std::byte{value});
    } else if constexpr (std::is_arithmetic_v<T>) {
        put(bytes, &value, sizeof value);
    } else if constexpr (FixedMatrix<T>) {
        put(bytes, value.data(), sizeof(double) * value.size());
    } else if constexpr (is_array<T>) {
        for (const auto& element : value)
            encode(bytes, element);
    } else if constexpr (is_vector<T> || std::is_same_v<T, std::string>) {
        using Element = typename T::value_type;
        encode(bytes, static_cast<std::uint64_t>(value.size()));
        if constexpr (!std::is_same_v<Element, bool>)
            if (is_whole<Element>) return put(bytes, value.data(), value.size() * sizeof(Element));
        for (const auto& element : value)
            encode(bytes, element);
    } else if constexpr (is_optional<T>) {
        encode(bytes, value.has_value());
        if (value) encode(bytes, *value);
    } else if constexpr (is_pair<T>) {
        encode(bytes, value.first);
        encode(bytes, value.second);
    } else {
        static_assert(Plain<T>, "no encoding: list the struct in formulas/fields.hpp");
        if (is_whole<T>) return put(bytes, &value, sizeof value);
        Fields<T>::each(value, [&](std::string_view, const auto& field) { encode(bytes, field); });
    }
}

/// Replaces `bytes` by the encodings of these values, one after the other.
template <class... T> void encode_all(Bytes& bytes, const T&... values)
{
    if ((is_whole<T> && ...)) {
        bytes.resize((sizeof(T) + ...)); // usually `bytes` has this size already
        std::byte* end = bytes.data();
        ((end = std::copy_n(reinterpret_cast<const std::byte*>(&values), sizeof(T), end)), ...);
        return;
    }
    bytes.clear();
    (encode(bytes, values), ...);
}

/// The least and the largest size of an encoding of T [bytes]. The least one bounds how many
/// elements a list can have, and the largest one bounds the size of a reply.
struct Size {
    static constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();
    std::size_t least = 0, most = 0;
};

template <class T> Size encoded_size()
{
    const auto sum = [](std::size_t a, std::size_t b) {
        return a == Size::unbounded || b == Size::unbounded ? Size::unbounded : a + b;
    };
    if constexpr (std::is_arithmetic_v<T>) {
        return {sizeof(T), sizeof(T)};
    } else if constexpr (FixedMatrix<T>) {
        return {sizeof(double) * T::SizeAtCompileTime, sizeof(double) * T::SizeAtCompileTime};
    } else if constexpr (is_array<T>) {
        const Size element = encoded_size<typename T::value_type>();
        const std::size_t n = std::tuple_size_v<T>;
        return {n * element.least,
                element.most == Size::unbounded ? Size::unbounded : n * element.most};
    } else if constexpr (is_vector<T> || std::is_same_v<T, std::string>) {
        return {sizeof(std::uint64_t), Size::unbounded};
    } else if constexpr (is_optional<T>) {
        return {1, sum(1, encoded_size<typename T::value_type>().most)};
    } else if constexpr (is_pair<T>) {
        const Size a = encoded_size<typename T::first_type>();
        const Size b = encoded_size<typename T::second_type>();
        return {a.least + b.least, sum(a.most, b.most)};
    } else {
        Size total;
        const T prototype{};
        Fields<T>::each(prototype, [&](std::string_view, const auto& field) {
            const Size size = encoded_size<std::remove_cvref_t<decltype(field)>>();
            total = {total.least + size.least, sum(total.most, size.most)};
        });
        return total;
    }
}

/// Reads values from the front of a sequence of bytes.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    void get(void* data, std::size_t size)
    {
        if (size > rest_.size()) throw Malformed("it ends in the middle of a value");
        if (size > 0) std::memcpy(data, rest_.data(), size);
        rest_ = rest_.subspan(size);
    }

    /// Reads the length of a container whose elements take at least `least` bytes each.
    /// @throws Malformed if the remaining bytes cannot hold so many elements
    std::size_t count(std::size_t least)
    {
        std::uint64_t n = 0;
        get(&n, sizeof n);
        if (n > rest_.size() / std::max<std::size_t>(least, 1))
            throw Malformed("it announces " + std::to_string(n) + " elements in " +
                            std::to_string(rest_.size()) + " bytes");
        return n;
    }

    void end() const
    {
        if (!rest_.empty())
            throw Malformed("it has " + std::to_string(rest_.size()) + " bytes too many");
    }

private:
    std::span<const std::byte> rest_;
};

template <class T> void decode(Reader& reader, T& value)
{
    if constexpr (std::is_same_v<T, bool>) {
        unsigned char byte = 0;
        reader.get(&byte, 1);
        if (byte > 1) throw Malformed("it has a boolean that is " + std::to_string(byte));
        value = byte == 1;
    } else if constexpr (std::is_arithmetic_v<T>) {
        reader.get(&value, sizeof value);
    } else if constexpr (FixedMatrix<T>) {
        reader.get(value.data(), sizeof(double) * value.size());
    } else if constexpr (is_array<T>) {
        for (auto& element : value)
            decode(reader, element);
    } else if constexpr (is_vector<T> || std::is_same_v<T, std::string>) {
        using Element = typename T::value_type;
        if constexpr (std::is_same_v<Element, bool>) {
            value.resize(reader.count(1));
            for (std::size_t i = 0; i < value.size(); ++i) {
                bool element = false;
                decode(reader, element);
                value[i] = element;
            }
        } else {
            value.resize(reader.count(encoded_size<Element>().least));
            if (is_whole<Element>)
                return reader.get(static_cast<void*>(value.data()), value.size() * sizeof(Element));
            for (auto& element : value)
                decode(reader, element);
        }
    } else if constexpr (is_optional<T>) {
        bool present = false;
        decode(reader, present);
        value.reset();
        if (present) decode(reader, value.emplace());
    } else if constexpr (is_pair<T>) {
        decode(reader, value.first);
        decode(reader, value.second);
    } else {
        static_assert(Plain<T>, "no decoding: list the struct in formulas/fields.hpp");
        if (is_whole<T>) return reader.get(static_cast<void*>(&value), sizeof value);
        Fields<T>::each(value, [&](std::string_view, auto& field) { decode(reader, field); });
    }
}

/// The value of type T that all of `bytes` encode. @throws Malformed
template <class T> T decode_all(std::span<const std::byte> bytes)
{
    Reader reader(bytes);
    T value{};
    decode(reader, value);
    reader.end();
    return value;
}

} // namespace rigor::wire
