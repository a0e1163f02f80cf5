#pragma once

#include <span>
#include <string>

#include "rubsweep/analysis/line/follow_line.hpp"
#include "rubsweep/core/model/length_text.hpp"
#include "rubtrace/ramp_record.hpp"

namespace rubsweep::apps {

/// Results of a run-up or run-down with rubbing, as texts. Lengths in m, forces in N, times in s, speeds in
/// Hz.
struct RampTables {
  std::string envelope_csv;      ///< extremes, peaks and contacts over the ramp
  std::string orbits_csv;        ///< orbit, speed_hz, t_s, x_m, y_m
  std::string spectrogram_csv;   ///< t_s, speed_hz, order, amplitude_m: significant lines up to order 8
  std::string quasi_static_csv;  ///< speed_hz, class, order, peak_displacement_m
  std::string rub_csv;           ///< source (ramp or quasi_static), from_hz, to_hz of every stretch that rubs
  std::string summary;           ///< text for a terminal
};

/// Ranges of speed in which neighbouring cells all rub, in the order of the points.
std::vector<ramp::RubbingSpan> rubbing_spans(std::span<const line::LinePoint> points);

/// `quasi_static`: motions at steady speeds, in the order of the ramp. `shown`: unit of lengths in the
/// summary, m by default.
RampTables tables_of(const ramp::RampRecord& record, std::span<const line::LinePoint> quasi_static,
                     const model::ShownLengths& shown = {});

}  // namespace rubsweep::apps
