#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Whether bytes begin as a file of version 4 does, which has no words at its begin.
bool is_version_4(std::string_view bytes);

/// Its variables. Throws FileError.
std::vector<Variable> read_version_4(std::string_view bytes, const Wanted& wanted);

}  // namespace rubsweep::matlab
