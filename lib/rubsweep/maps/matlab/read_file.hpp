#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Variables in the bytes of a MATLAB file, version 4, 5 (also compressed, which MATLAB calls version 7) or
/// 7.3. Compressed variables are read to their end, whether they are wanted or not, and zlib's checksum is
/// verified. Structures and cells are read with their contents, down to most_depth levels. Throws FileError
/// for any other or a damaged file, for more than most_numbers, and for a file of version 7.3 with variables
/// in other files.
std::vector<Variable> read_variables(std::string_view bytes, const Wanted& wanted);

/// Whether bytes begin like a file of version 4, which has no text at its begin.
bool is_version_4(std::string_view bytes);

}  // namespace rubsweep::matlab
