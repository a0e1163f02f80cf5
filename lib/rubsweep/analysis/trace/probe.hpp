#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::trace {

/// Proximity probes that look at a run at instants of their own clock, as an instrument does.
struct Probes {
  Eigen::MatrixXd rows;           ///< probes x n: reading in metres = row . q
  std::vector<double> angle_deg;  ///< direction of each, from +x towards +y
  double sample_s = 1e-3;         ///< > 0
  double noise_m = 0;  ///< standard deviation of white noise on every reading; the same numbers in every run
};

/// Finest samples of a turn that readings are taken between.
inline constexpr int probe_samples_per_revolution = 4096;

/// Refinement of `samples_per_revolution` for the probes of a run: at most `probe_samples_per_revolution`. A
/// cubic through values and rates so close together misses a vibration of order p by (2 pi p / 4096)^4 / 384
/// of its amplitude: 1e-7 at order 50.
int probe_refinement(int samples_per_revolution);

/// Takes readings at t = 0, sample_s, ... from a run that is sampled finely.
class ProbeReader {
 public:
  ProbeReader(const scene::Scene& scene, double speed_hz, Probes probes);

  /// Readings within the next whole turn, which has samples and a section.
  void add(const integrate::run::TurnReport& turn);

  /// Readings of all turns so far with their noise, readings x probes, in metres.
  Eigen::MatrixXd readings_m() const;

 private:
  double reading(const integrate::run::TurnReport& turn, double turns, Eigen::Index probe) const;

  Probes probes_;
  double length_m_, speed_hz_;
  std::size_t states_;
  long turn_ = 0, count_ = 0;
  std::vector<double> readings_m_;  ///< one reading of all probes after the other
};

}  // namespace rubsweep::trace
