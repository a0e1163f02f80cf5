#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Variables of the bytes of a file of version 7.3, which is one of HDF5, in the order of the alphabet. The
/// library of HDF5 is opened when it is needed for the first time, says nothing itself, and loads no filters
/// of others. Throws FileError, also where there is no such library, and where a variable is a link or keeps
/// its numbers in another file.
std::vector<Variable> read_version_73(std::string_view bytes, const Wanted& wanted);

}  // namespace rubsweep::matlab
