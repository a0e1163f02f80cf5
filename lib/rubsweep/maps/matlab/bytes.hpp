#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Reads the bytes of a file from front to back, in either byte order. Throws FileError at the end of the
/// bytes.
class Bytes {
 public:
  Bytes(std::string_view rest, bool swapped) : rest_(rest), swapped_(swapped) {}

  std::size_t left() const { return rest_.size(); }
  bool swapped() const { return swapped_; }

  std::string_view take(std::size_t count) {
    if (count > rest_.size()) throw FileError{"breaks off"};
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  template <class Number>
  Number number() {
    std::array<char, sizeof(Number)> raw{};
    std::ranges::copy(take(raw.size()), raw.begin());
    if (swapped_) std::ranges::reverse(raw);
    Number value;
    std::memcpy(&value, raw.data(), raw.size());
    return value;
  }

 private:
  std::string_view rest_;
  bool swapped_;
};

/// Types of stored numbers, with their codes in version 5.
enum class Stored : std::uint32_t {
  int8 = 1,
  uint8 = 2,
  int16 = 3,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  float32 = 7,
  float64 = 9,
  int64 = 12,
  uint64 = 13
};

/// Takes `count` numbers. Throws FileError where fewer bytes are left, or the type is not in the list above.
inline std::vector<double> take_numbers(Bytes& bytes, Stored type, std::size_t count) {
  const auto all = [&]<class Number>(Number) {
    if (count > bytes.left() / sizeof(Number)) throw FileError{"breaks off"};
    std::vector<double> values(count);
    for (double& value : values) value = static_cast<double>(bytes.number<Number>());
    return values;
  };
  switch (type) {
    case Stored::int8: return all(std::int8_t{});
    case Stored::uint8: return all(std::uint8_t{});
    case Stored::int16: return all(std::int16_t{});
    case Stored::uint16: return all(std::uint16_t{});
    case Stored::int32: return all(std::int32_t{});
    case Stored::uint32: return all(std::uint32_t{});
    case Stored::float32: return all(float{});
    case Stored::float64: return all(double{});
    case Stored::int64: return all(std::int64_t{});
    case Stored::uint64: return all(std::uint64_t{});
  }
  throw FileError{"is damaged: numbers of an unknown type"};
}

/// Full matrix of a sparse one: `row` has the row of each stored value, `begin` the index of the first value
/// of each column.
inline std::vector<double> full_matrix(const Variable& head, const std::vector<double>& row,
                                       const std::vector<double>& begin, const std::vector<double>& stored) {
  const std::size_t rows = head.dims[0], columns = head.dims[1];
  std::vector<double> values(count_of(head), 0.0);
  bool sound = begin.size() == columns + 1 && begin.front() >= 0;
  for (std::size_t column = 0; sound && column < columns; ++column) {
    sound = begin[column] <= begin[column + 1] &&
            begin[column + 1] <= static_cast<double>(std::min(row.size(), stored.size()));
    for (auto k = static_cast<std::size_t>(begin[column]);
         sound && k < static_cast<std::size_t>(begin[column + 1]); ++k) {
      sound = row[k] >= 0 && row[k] < static_cast<double>(rows);
      if (sound) values[column * rows + static_cast<std::size_t>(row[k])] += stored[k];
    }
  }
  if (!sound) throw FileError{"is damaged: a sparse matrix whose places are none"};
  return values;
}

}  // namespace rubsweep::matlab
