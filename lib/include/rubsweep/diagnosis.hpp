#pragma once

/// \file
/// A diagnosis: which stop of a known machine rubs in a recording, if any, with probabilities, and values of
/// the machine's parameters with their intervals. The recording (recording.hpp) has 12 turns or more at a
/// steady speed, or is a run-up or coast-down. The machine is a configuration; if the files of rubfit lie beside it, their intervals are
/// used. Candidates are the usual ones, or those of a file (`configs/recordings/candidates.yaml`).
///
/// First, motions of all candidates are simulated, 600 of each by default, which takes about a minute.
/// `kept_motions` names a directory that keeps them for further recordings of the same machine and speed. The
/// answer does not depend on `threads`. Throws ConfigError and IoError. The result is empty if the work was
/// stopped early.
///
/// ```cpp
/// using namespace rubsweep;
/// recording::Recording circle;  // of 20 um, 20 turns; else as recording::make_recording returns it
/// circle.sampling_rate_hz = 6400, circle.plane = true;
/// for (int turn = 0; turn <= 20; ++turn) circle.turn_begin_s.push_back(turn / 60.0);
/// for (int k = 0; k < 20 * recording::samples_per_revolution; ++k)
///   circle.displacement_m.push_back(
///       std::polar(2e-5, 2 * std::numbers::pi * k / recording::samples_per_revolution));
/// const recording::Instrument instrument{.probes = {{.column = "x"}, {.column = "y", .angle_deg = 90}}};
/// const auto answer =
///     diagnosis::diagnose_recording(circle, instrument, {.name = "circle", .machine =
///     "configs/minimal.yaml"},
///                                   {.motions = 40});  // few, for a quick look
/// if (answer) std::puts(diagnose::answer::answer_text(*answer).c_str());
/// ```

#include "rubsweep/measurement/diagnose/answer/answer_text.hpp"
#include "rubsweep/measurement/diagnosis/diagnose_recording.hpp"
