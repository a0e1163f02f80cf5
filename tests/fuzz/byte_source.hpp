#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

namespace rubsweep::fuzz {

/// Makes choices from consecutive bytes; zeros follow when they are used up, so that every input is valid.
class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t next() { return place_ < bytes_.size() ? bytes_[place_++] : std::uint8_t{0}; }

  /// A number from 0 to count - 1.
  int below(int count) { return next() % count; }

  /// True with the probability 1 / times; false when the bytes are used up.
  bool once_in(int times) { return below(times) == times - 1; }

  std::string one_of(std::initializer_list<const char*> texts) {
    return texts.begin()[below(static_cast<int>(texts.size()))];
  }

  /// A number as text: mostly `usual`, often close to it, sometimes far off or at the limits of double.
  std::string number(double usual);

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

}  // namespace rubsweep::fuzz
