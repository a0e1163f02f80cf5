#include "rubsweep/maps/batch/sha256.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace rubsweep::batch {
namespace {

/// First 32 bits of the fractional parts of the cube roots of the first 64 primes.
constexpr std::array<std::uint32_t, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

std::array<std::uint32_t, 64> schedule_of(const unsigned char* block) {
  std::array<std::uint32_t, 64> w;
  for (std::size_t i = 0; i < 16; ++i) {
    w[i] = 0;
    for (std::size_t k = 0; k < 4; ++k) w[i] = w[i] << 8U | block[4 * i + k];
  }
  for (std::size_t i = 16; i < w.size(); ++i) {
    const std::uint32_t a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3U) + w[i - 7] +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10U);
  }
  return w;
}

constexpr std::string_view before_digits = "<!-- sha256 ", behind_digits = " -->\n";

}  // namespace

void Sha256::take_block(const unsigned char* block) {
  const auto w = schedule_of(block);
  auto [a, b, c, d, e, f, g, h] = state_;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const std::uint32_t choice = (e & f) ^ (~e & g), majority = (a & b) ^ (a & c) ^ (b & c),
                        first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + choice +
                                round_constants[i] + w[i],
                        second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + majority;
    h = g;
    g = f;
    f = e;
    e = d + first;
    d = c;
    c = b;
    b = a;
    a = first + second;
  }
  const std::array<std::uint32_t, 8> mixed{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i] += mixed[i];
}

void Sha256::add(std::string_view text) {
  while (!text.empty()) {
    const std::size_t used = bytes_ % waiting_.size(), length = std::min(waiting_.size() - used, text.size());
    std::memcpy(waiting_.data() + used, text.data(), length);
    bytes_ += length;
    text.remove_prefix(length);
    if (used + length == waiting_.size()) take_block(waiting_.data());
  }
}

/// Padding: a bit 1 follows the text, and the last block ends with the length of the text in bits.
std::string Sha256::digits() {
  const std::uint64_t bits = 8 * bytes_;
  add(std::string_view("\x80", 1));
  constexpr std::size_t place_of_length = 56;
  while (bytes_ % waiting_.size() != place_of_length) add(std::string_view("\0", 1));
  std::string length;
  for (unsigned shift = 64; shift > 0; shift -= 8)
    length += static_cast<char>(static_cast<unsigned char>(bits >> (shift - 8)));
  add(length);
  std::string digits;
  for (const std::uint32_t word : state_) digits += fmt::format("{:08x}", word);
  return digits;
}

std::string sha256_of(std::string_view text) {
  Sha256 sum;
  sum.add(text);
  return sum.digits();
}

std::string with_page_sum(std::string_view page) {
  const std::size_t after_first = std::min(page.find('\n'), page.size() - 1) + 1;
  return std::string(page.substr(0, after_first))
      .append(before_digits)
      .append(sha256_of(page))
      .append(behind_digits)
      .append(page.substr(after_first));
}

PageSum check_page(std::string_view page) {
  const std::string text = without_carriage_returns(page);
  const std::size_t line = std::min(text.find('\n'), text.size() - 1) + 1;
  const std::string_view marked = std::string_view(text).substr(line);
  if (!marked.starts_with(before_digits)) return PageSum::none;
  const std::size_t length = std::min(marked.find('\n'), marked.size() - 1) + 1;
  const std::string other = text.substr(0, line).append(marked.substr(length));
  const bool same =
      marked.substr(0, length) == std::string(before_digits).append(sha256_of(other)).append(behind_digits);
  return same ? PageSum::right : PageSum::wrong;
}

std::string without_carriage_returns(std::string_view text) {
  const std::size_t first = text.find('\n');
  if (first == std::string_view::npos || first == 0 || text[first - 1] != '\r') return std::string(text);
  std::string same;
  same.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i)
    if (!text.substr(i).starts_with("\r\n")) same += text[i];
  return same;
}

}  // namespace rubsweep::batch
