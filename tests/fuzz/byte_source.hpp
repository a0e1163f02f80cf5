#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

namespace rubsweep::fuzz {

/// Choices taken from bytes, one after the other; zeros once they are used up, so that every input is a whole
/// one.
class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t next() { return place_ < bytes_.size() ? bytes_[place_++] : std::uint8_t{0}; }

  /// 0 .. count - 1.
  int below(int count) { return next() % count; }

  /// True once in `times`; false when the bytes are used up.
  bool once_in(int times) { return below(times) == times - 1; }

  std::string one_of(std::initializer_list<const char*> texts) {
    return texts.begin()[below(static_cast<int>(texts.size()))];
  }

  /// A number as text: mostly `usual`, often near it, now and then far off or at an edge of what a double can
  /// hold.
  std::string number(double usual);

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

}  // namespace rubsweep::fuzz
