// Numbers to and from bytes in the order that a file format names, on any machine.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "weft/vec3.h"

namespace weft {

/// A growing block of bytes, later written in one go.
using Bytes = std::vector<std::byte>;

/// The unsigned integer with as many bytes as T.
template <typename T>
using BitsOf = std::conditional_t<
    sizeof(T) == 8, std::uint64_t,
    std::conditional_t<sizeof(T) == 4, std::uint32_t,
                       std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;

/// Writes `value` to `bytes`; `order` is that of the file.
template <std::endian order, typename T>
    requires std::is_arithmetic_v<T>
void put(std::byte* bytes, T value) {
    if constexpr (order == std::endian::native) {
        std::memcpy(bytes, &value, sizeof(T));
    } else {
        const auto bits = std::bit_cast<BitsOf<T>>(value);
        for (std::size_t i = 0; i < sizeof(T); ++i) {
            const std::size_t place = order == std::endian::little ? i : sizeof(T) - 1 - i;
            bytes[i] = static_cast<std::byte>((bits >> (8 * place)) & 0xff);
        }
    }
}

/// Appends `value`.
template <std::endian order, typename T>
    requires std::is_arithmetic_v<T>
void append(Bytes& bytes, T value) {
    const std::size_t end = bytes.size();
    bytes.resize(end + sizeof(T));
    put<order>(bytes.data() + end, value);
}

template <typename T>
void append_little(Bytes& bytes, T value) {
    append<std::endian::little>(bytes, value);
}

template <typename T>
void append_big(Bytes& bytes, T value) {
    append<std::endian::big>(bytes, value);
}

inline void append_text(Bytes& bytes, std::string_view text) {
    for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
}

/// The number at `bytes[offset]`; the caller has checked that it lies inside.
template <std::endian order, typename T>
    requires std::is_arithmetic_v<T>
T number_at(std::span<const std::byte> bytes, std::size_t offset) {
    BitsOf<T> bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        const std::size_t place = order == std::endian::little ? i : sizeof(T) - 1 - i;
        const auto part = static_cast<std::uint64_t>(bytes[offset + i]) << (8 * place);
        bits = static_cast<BitsOf<T>>(bits | part);
    }
    return std::bit_cast<T>(bits);
}

}  // namespace weft
