#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace rubsweep::page {

/// Appends an integer to `bytes`, the lowest byte first, as a browser's DataView reads it.
template <std::unsigned_integral Integer>
void append(std::string& bytes, Integer value) {
  for (unsigned shift = 0; shift < 8 * sizeof(Integer); shift += 8)
    bytes.push_back(static_cast<char>(static_cast<unsigned char>(std::uint64_t{value} >> shift)));
}

/// Appends a floating-point number (IEEE 754) in the same byte order.
template <std::floating_point Number>
void append(std::string& bytes, Number value) {
  using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
  append(bytes, std::bit_cast<Bits>(value));
}

/// Appends `records` of `width` bytes each in byte planes: first the lowest byte of every record, then the
/// second byte of every record, and so on. Similar numbers compress better in this order.
inline void append_planes(std::string& bytes, const std::string& records, std::size_t width) {
  for (std::size_t plane = 0; plane < width; ++plane)
    for (std::size_t i = plane; i < records.size(); i += width) bytes.push_back(records[i]);
}

std::string base64(std::string_view bytes);  ///< Text of `bytes` in base64 (RFC 4648), with padding.

/// Text of `bytes`, compressed in the zlib format and then in base64. A browser decodes it by atob and
/// DecompressionStream("deflate"). Equal bytes give equal texts. Throws std::bad_alloc.
std::string compressed(std::string_view bytes);

}  // namespace rubsweep::page
