#pragma once

#include "rubsweep/measurement/dataset/labelled_recording.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::dataset {

/// Share of a turn that the mark on the shaft passes the keyphasor: of the fewest readings a turn that a
/// study may have, which are 5, one at least falls on the mark.
inline constexpr double mark_share = 0.25;

/// Fills the columns of a recording from its motion: readings at even times from 0 on, with lines of other
/// origin, gains and noise; the leading edge of the mark passes `mark_turns` after the begin of each turn.
void read_motion(const Measurement& measurement, diagnose::RandomStream& random,
                 LabelledRecording& recording);

}  // namespace rubsweep::dataset
