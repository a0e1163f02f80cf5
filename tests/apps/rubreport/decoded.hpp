#pragma once

#include <zlib.h>

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::page {

/// Decodes base64 (RFC 4648) bit by bit.
inline std::string from_base64(std::string_view text) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>(bits >> count & 0xff));
  }
  return bytes;
}

/// Inverse of `compressed`; returns at most `most` bytes.
inline std::string decompressed(std::string_view text, std::size_t most = 1 << 22) {
  const std::string packed = from_base64(text);
  std::string bytes(most, '\0');
  uLongf size = most;
  if (::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                   reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK)
    throw std::runtime_error("not in the zlib format");
  bytes.resize(size);
  return bytes;
}

/// Reads numbers stored with the lowest byte first.
class Bytes {
 public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes.begin(), bytes.end()) {}

  std::uint64_t integer(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{byte(at_ + i)} << (8 * i);
    at_ += size;
    return value;
  }
  float number() { return std::bit_cast<float>(static_cast<std::uint32_t>(integer(4))); }

  std::vector<int> planes16(std::size_t count) {
    std::vector<int> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(byte(at_ + i) | byte(at_ + count + i) << 8);
    at_ += 2 * count;
    return values;
  }

  std::vector<double> levels(std::size_t count) {
    const double base = number(), width = number();
    std::vector<double> values;
    int level = 0;
    for (const int difference : planes16(count)) {
      level = (level + difference) & 0xffff;
      values.push_back(base + width * level);
    }
    return values;
  }

  bool at_end() const { return at_ == bytes_.size(); }

 private:
  unsigned char byte(std::size_t i) const { return bytes_.at(i); }

  std::vector<unsigned char> bytes_;
  std::size_t at_ = 0;
};

}  // namespace rubsweep::page
