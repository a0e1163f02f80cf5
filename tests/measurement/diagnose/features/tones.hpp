#pragma once

#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose {

/// A circular motion; it is backward for a negative order.
struct Tone {
  double order = 0, amplitude = 0;
};

/// Lines of the sum of these circles over 30 turns, by a transform of its samples.
inline MotionLines tones(const std::vector<Tone>& all) {
  constexpr int turns = 30, samples_of_a_turn = 32;
  std::vector<std::complex<double>> samples;
  for (int j = 0; j < turns * samples_of_a_turn; ++j) {
    const double angle = 2 * std::numbers::pi * j / samples_of_a_turn;
    samples.emplace_back(0);
    for (const Tone& tone : all) samples.back() += std::polar(tone.amplitude, tone.order * angle);
  }
  response::spectrum::SpectrumWorkspace workspace;
  return lines_of(samples, turns, 8, workspace);
}

}  // namespace rubsweep::diagnose
