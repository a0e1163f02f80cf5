#pragma once

#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads a LabVIEW measurement (.lvm) in UTF-8: its signals, with the units of the header, and their times
/// "X_Value". These come from the file, or from X0 and Delta_X where the file has none. Where each signal has
/// its own times (X_Columns Multi), all must be the same. Segments follow one another by their own times, or
/// by the start instants in their headers. Throws table::Fault.
Channels read_labview_text(std::string_view text);

}  // namespace rubsweep::recording
