#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Variables of the bytes of a MATLAB file, version 4, 5 (also compressed, what MATLAB calls version 7) or
/// 7.3. Compressed ones are read to their end, and the checksum of zlib must be right, whether they are
/// wanted or not. Structures and cells are read with those in them, to most_depth. Throws FileError for what
/// is no such file or a damaged one, for more than most_numbers, and for one of version 7.3 whose variables
/// are in other files.
std::vector<Variable> read_variables(std::string_view bytes, const Wanted& wanted);

/// Whether bytes begin like a file of version 4, which has no text at its begin.
bool is_version_4(std::string_view bytes);

}  // namespace rubsweep::matlab
