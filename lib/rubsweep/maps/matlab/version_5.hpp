#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/bytes.hpp"
#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Variables of a file of version 5, from behind its head. Throws FileError.
std::vector<Variable> read_version_5(Bytes bytes, const Wanted& wanted);

/// A vector to be written under a name.
struct NamedVector {
  std::string_view name;
  std::span<const double> values;
};

/// Bytes of a file of version 5 with these columns, compressed; `words` are its head, at most 116.
std::string version_5_file(std::string_view words, std::span<const NamedVector> columns);

/// The first `count` bytes of what zlib packed, or fewer where it holds fewer. Throws FileError where it is
/// damaged so far.
std::string inflate_begin(std::string_view packed, std::size_t count);

/// All bytes of what zlib packed, to its end and with its checksum. Throws FileError where these are wrong,
/// or it holds more than `most`.
std::string inflate_all(std::string_view packed, std::size_t most);

}  // namespace rubsweep::matlab
