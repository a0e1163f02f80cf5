#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::table {

/// Readings per second that the words about a table say: a rate or a step of time by one of its usual names,
/// in the same cell or the one behind or below ("SampleRate=1000", "Sampling Period;1.0E-03"), or a line of
/// frequencies and nothing else ("1000 Hz"). Empty where it is not said, or said differently.
std::optional<double> sampling_rate_in(std::string_view text, const Layout& layout);

/// Readings per second of a value and its key, where the key is one of the usual names of a rate or a step.
std::optional<double> rate_of(std::string_view key, std::string_view value);

/// Names and units of columns with a head beside them: source and units of an oscilloscope's signals.
void name_from_beside(std::string_view text, Layout& layout);

}  // namespace rubsweep::table
