#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "rubsweep/measurement/recording/recording.hpp"

/// Recordings of known motions on a machine with wandering speed and amplitude, through an instrument with
/// noise, quantisation and a keyway. They share no code with the simulators.
namespace rubsweep::scope {

struct Unsteady {
  double speed_wander = 0;                  ///< largest relative deviation of the speed
  double speed_cycles = 0;                  ///< cycles of the speed per recording; 0: two random slow waves
  double amplitude_wander = 0;              ///< largest relative deviation of the amplitude
  double other_order = 0, other_share = 0;  ///< a further line, amplitude / 1X
  double other_swing = 0;                   ///< relative modulation of this line, one cycle per recording
  double near_bins = 0, near_share = 0;     ///< a third line: distance from it in bins, ratio to it
  double noise_share = 5e-3;                ///< noise of every reading / size of the motion
  double step_um = 1e-3;                    ///< quantisation step; 1X has 100 um
  double edge_readings = 0;                 ///< number of readings on an edge of the mark
  double mark_noise_v = 0.05;               ///< noise of the mark signal, which is 8 V high
  double readings_per_turn = 20;
  int turns = 32;
};

/// A smooth random function between -1 and 1: two slow waves and a trend of random sizes.
class Wander {
 public:
  explicit Wander(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    trend_ = 2 * uniform(random) - 1;
    for (int i = 0; i < 2; ++i) {
      cycles_[i] = 0.3 + 1.2 * uniform(random);
      phase_[i] = 2 * std::numbers::pi * uniform(random);
      size_[i] = uniform(random);
    }
    double largest = 0;
    for (int k = 0; k <= 200; ++k) largest = std::fmax(largest, std::abs(raw(k / 200.0)));
    scale_ = 1 / largest;
  }
  double at(double share) const { return scale_ * raw(share); }

 private:
  double raw(double share) const {
    double sum = trend_ * (share - 0.5);
    for (int i = 0; i < 2; ++i)
      sum += size_[i] * std::sin(2 * std::numbers::pi * cycles_[i] * share + phase_[i]);
    return sum;
  }
  double trend_ = 0, cycles_[2]{}, phase_[2]{}, size_[2]{}, scale_ = 1;
};

inline recording::Recording recorded(const Unsteady& put, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Wander speed(random), amplitude(random);
  const double begin = uniform(random), phase = 2 * std::numbers::pi * uniform(random);
  recording::Channels table;
  table.channels = {{"X", "um", {}}, {"Y", "um", {}}, {"KP", "V", {}}};
  double angle = begin;
  const auto read = [&](double value) { return std::round(value / put.step_um) * put.step_um; };
  // The keyway passes from its first edge on, which may last several readings.
  const auto mark_v = [&](double turned) {
    const double since = turned - std::floor(turned), edge = put.edge_readings / put.readings_per_turn;
    if (since > 0.12 + edge) return -1.0;
    if (edge == 0) return -9.0;
    return -1 - 8 * std::fmin(1, std::fmin(since, 0.12 + edge - since) / edge);
  };
  const int count = static_cast<int>(put.readings_per_turn * put.turns);
  for (int k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / count;
    const double size = 100 * (1 + put.amplitude_wander * amplitude.at(share));
    std::complex<double> z = size * std::polar(1.0, 2 * std::numbers::pi * angle);
    const double swing = 1 + put.other_swing * std::sin(2 * std::numbers::pi * share + 2 * phase);
    z += 100 * put.other_share * swing *
         std::polar(1.0, 2 * std::numbers::pi * put.other_order * angle + phase);
    z +=
        100 * put.other_share * put.near_share *
        std::polar(1.0, 2 * std::numbers::pi * (put.other_order + put.near_bins / put.turns) * angle - phase);
    table.channels[0].values.push_back(read(z.real() + 100 * put.noise_share * normal(random)));
    table.channels[1].values.push_back(read(z.imag() + 100 * put.noise_share * normal(random)));
    table.channels[2].values.push_back(mark_v(angle) + put.mark_noise_v * normal(random));
    // Small steps of the angle, each with its own speed.
    for (int i = 0; i < 4; ++i) {
      const double at = share + 0.25 * i / count, cycles = put.speed_cycles;
      const double wave = cycles > 0 ? std::sin(2 * std::numbers::pi * cycles * at) : speed.at(at);
      angle += (1 + put.speed_wander * wave) / (4 * put.readings_per_turn);
    }
  }
  const recording::Instrument instrument{.sampling_rate_hz = 50 * put.readings_per_turn,
                                         .probes = {{"X", 0}, {"Y", 90}},
                                         .keyphasor = recording::Keyphasor{.column = "KP"}};
  return recording::make_recording(table, instrument, "made.csv");
}

}  // namespace rubsweep::scope
