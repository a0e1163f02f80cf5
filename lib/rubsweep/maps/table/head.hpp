#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::table {

/// Readings per second, according to the text around a table. It is a rate or a step of time behind one of
/// its usual names, in the same cell or in the next or lower one ("SampleRate=1000", "Sampling
/// Period;1.0E-03"), or a line that has only frequencies ("1000 Hz"). Empty where the text gives no rate, or
/// different ones.
std::optional<double> sampling_rate_in(std::string_view text, const Layout& layout);

/// Readings per second from a key and its value, if the key is one of the usual names of a rate or a step.
std::optional<double> rate_of(std::string_view key, std::string_view value);

/// Takes names and units of columns from keys and values beside the table: source and units of an
/// oscilloscope's signals.
void name_from_beside(std::string_view text, Layout& layout);

}  // namespace rubsweep::table
