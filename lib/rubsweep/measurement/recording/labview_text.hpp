#pragma once

#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads a LabVIEW measurement (.lvm) in UTF-8: its signals with the units of the head and "X_Value", the
/// times: those of the file, or X0 and Delta_X where it has none. Where each signal has times of its own
/// (X_Columns Multi) these must be the same. Segments follow each other, by their own times or by the
/// instants that their heads say. Throws table::Fault.
Channels read_labview_text(std::string_view text);

}  // namespace rubsweep::recording
