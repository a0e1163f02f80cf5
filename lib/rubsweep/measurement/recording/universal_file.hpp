#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Whether bytes begin as a universal file does: a line "-1", then the number of a data set.
bool is_universal_file(std::string_view bytes);

/// Reads the time histories of a universal file: data sets 58, of text or of binary numbers (58b). Each set
/// is one signal. Its name is the first line of the set, or its point and direction where another set has the
/// same line. "time" is their abscissa. The step has six digits; if a whole number of readings per second
/// agrees with them, it is used. Spectra, complex functions, and sets with other times than the first are
/// left out with a note. Throws ConfigError with `name`:line.
Channels read_universal_file(std::string_view bytes, const std::string& name);

}  // namespace rubsweep::recording
