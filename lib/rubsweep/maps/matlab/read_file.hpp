#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Variables of a MATLAB file, version 4, 5 (also compressed, which MATLAB calls version 7) or 7.3, from its
/// bytes. Compressed variables are always read to their end, wanted or not, and their zlib checksum is
/// verified. Fields of a structure are read, but not structures inside it. Throws FileError for other or
/// damaged files, for more than most_numbers, and for version 7.3 with variables in other files.
std::vector<Variable> read_variables(std::string_view bytes, const Wanted& wanted);

/// Whether bytes begin like a file of version 4, which has no text at its begin.
bool is_version_4(std::string_view bytes);

}  // namespace rubsweep::matlab
