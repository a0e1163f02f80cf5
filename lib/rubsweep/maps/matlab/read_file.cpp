#include "rubsweep/maps/matlab/read_file.hpp"

#include <cstdint>
#include <string>

#include "rubsweep/maps/matlab/bytes.hpp"
#include "rubsweep/maps/matlab/version_4.hpp"
#include "rubsweep/maps/matlab/version_5.hpp"
#include "rubsweep/maps/matlab/version_73.hpp"

namespace rubsweep::matlab {

std::size_t count_of(const Variable& variable) {
  std::size_t count = 1;
  for (const std::size_t size : variable.dims) {
    if (size > 0 && count > most_numbers / size)
      throw FileError{
          "holds more than " + std::to_string(most_numbers) + " numbers in '" + variable.name + '\'',
          "at most so many"};
    count *= size;
  }
  return count;
}

std::vector<Variable> read_variables(std::string_view bytes, const Wanted& wanted) {
  constexpr std::size_t head = 128;
  if (bytes.size() >= head && (bytes.substr(126, 2) == "IM" || bytes.substr(126, 2) == "MI")) {
    const bool swapped = bytes[126] == 'M';
    const auto version = Bytes(bytes.substr(124, 2), swapped).number<std::uint16_t>();
    if (version == 0x0100) return read_version_5(Bytes(bytes.substr(head), swapped), wanted);
    if (version == 0x0200) return read_version_73(bytes, wanted);
  } else if (is_version_4(bytes)) {
    return read_version_4(bytes, wanted);
  }
  throw FileError{"is no MATLAB file, or a damaged one", "a file of version 4, 5 or 7.3"};
}

}  // namespace rubsweep::matlab
