#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Whether bytes begin as a universal file does: a line "-1", then the number of a data set.
bool is_universal_file(std::string_view bytes);

/// Reads the time histories of a universal file: data sets 58, of text or of binary numbers (58b), one signal
/// each, named by the first line of the set and, where others have the same, by point and direction; and
/// "time", their abscissa. Its step has six digits: a whole number of readings a second that fits them is
/// taken. Spectra, complex functions, and those with other times than the first are left out and told. Throws
/// ConfigError with `name`:line.
Channels read_universal_file(std::string_view bytes, const std::string& name);

}  // namespace rubsweep::recording
