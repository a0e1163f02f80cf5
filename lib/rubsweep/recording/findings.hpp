#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rubsweep::recording {

/// Adds what is wrong with a probe's readings: gaps (NaN), with the line of the first one; a probe that reads
/// one value only; clipping, where the largest or the smallest value stands at least five times in a row and
/// is reached by more than the converter's step.
void add_findings(std::span<const double> readings, const std::string& column,
                  std::span<const std::size_t> line, std::vector<std::string>& findings);

/// Adds what is wrong with turns: one that is longer or shorter than the one before by more than 1 %, and a
/// sampling rate of less than twenty readings a turn, from which on orders above the tenth may be folded
/// down.
void add_speed_findings(std::span<const double> turn_begin_s, double sampling_rate_hz,
                        std::vector<std::string>& findings);

}  // namespace rubsweep::recording
