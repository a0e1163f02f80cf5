#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/analysis/page/settled_orbit.hpp"

namespace rubsweep::page {

/// Which of the equidistant samples of some signals are enough to draw all of them by straight lines: with
/// the samples at the places returned (ascending, the first and the last among them), linear interpolation
/// misses no sample of any signal by more than `tolerance`. `always` lists places that stay in any case,
/// ascending. All signals have the same length, two samples or more. The method is that of Ramer, Douglas
/// and Peucker, with distances along the axis of values.
std::vector<std::size_t> needed_samples(std::span<const std::vector<double>> signals, double tolerance,
                                        std::span<const std::size_t> always);

/// Levels from the smallest to the largest value of a signal.
inline constexpr int levels = 4095;

/// Straight lines between the samples that are kept miss none of the others by more than this, as a share of
/// the larger extent of the orbit in x and y.
inline constexpr double drawing_tolerance = 1.0 / 400;

/// Spectral lines are kept up to this order, and from this share of the largest line on.
inline constexpr double highest_order = 12, smallest_line = 1e-3;

/// Appends `values` as they are drawn: the smallest and the width of one level (two floats), then for each
/// value its level as the difference from the one before (modulo 65536, two bytes, byte plane by byte plane).
void append_levels(std::string& bytes, std::span<const double> values);

/// One settled motion as the page reads it, numbers with the lowest byte first:
///   u32 cell; u32 bytes that follow;
///   u32 first revolution; u16 turns; u16 steps per turn; u16 kept samples; u16 signals;
///   u16 x kept samples: steps since the sample before (byte planes);
///   for each signal its kept samples, as append_levels writes them, in metres;
///   u16 points of the section; their x, then their y, as append_levels writes them;
///   u16 turns of the spectrum; u16 lines; f32 largest amplitude in metres; i16 x lines: the line's place k,
///   at order k / turns; u16 x lines: amplitude in 65535ths of the largest.
/// The samples kept are those that a drawing needs (needed_samples), and those on either side of each change
/// between gap and contact.
std::string encode_orbit(std::size_t cell, const SettledOrbit& orbit);

}  // namespace rubsweep::page
