#pragma once

#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose {

/// A circle; backward at an order below 0.
struct Tone {
  double order = 0, amplitude = 0;
};

/// Their sum over 30 turns, as a transform of its samples has it.
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
