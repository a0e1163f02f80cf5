#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/bytes.hpp"
#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Reads the variables of a file of version 5; `bytes` begins after the file's header. Throws FileError.
std::vector<Variable> read_version_5(Bytes bytes, const Wanted& wanted);

/// Vector that is written under a name.
struct NamedVector {
  std::string_view name;
  std::span<const double> values;
};

/// Bytes of a compressed MATLAB file of version 5 with these vectors. `words` are the text of its head, at
/// most 116 bytes.
std::string version_5_file(std::string_view words, std::span<const NamedVector> columns);

/// First `count` bytes of data packed by zlib, or all of them if there are fewer. Throws FileError where the
/// data are damaged before that.
std::string inflate_begin(std::string_view packed, std::size_t count);

/// All bytes of data packed by zlib, with the checksum verified. Throws FileError where the data are damaged
/// or unpack to more than `most` bytes.
std::string inflate_all(std::string_view packed, std::size_t most);

}  // namespace rubsweep::matlab
