#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
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
  std::vector<double> readings_m_;  ///< readings, one of all probes after the other
};

/// Two probes that see the motion of one place in both directions.
using ProbePair = std::pair<std::size_t, std::size_t>;

/// The first two of the probes whose directions are at least 10 degrees off each other's line; empty where
/// there are none. `places_m`: where along the shaft each stands; two at different places see no common
/// motion.
std::optional<ProbePair> pair_of(const std::vector<double>& angle_deg, const std::vector<double>& places_m);

/// z = x + iy of the shaft at the pair's place, in metres.
std::vector<std::complex<double>> displacement_of(const Eigen::MatrixXd& readings_m, const ProbePair& pair,
                                                  const std::vector<double>& angle_deg);

/// Period of a pair's readings at the end of a run, without a mark on the shaft and without its section.
struct ProbePeriod {
  int readings = 0;
  /// Smallest n up to max_order for which lines at multiples of 1/n explain the readings; empty: none does.
  std::optional<int> period;
  /// For that n (where none does: for the best): share of the energy without 0X that these lines leave.
  double unexplained_share = 0;
  double allowed_share = 0;  ///< share by which they count as explained
};

/// Fits lines at k / n orders, |k / n| up to 8 and below half the sampling rate, by least squares to the last
/// readings of `turns` turns, for n = 1, 2, ... `max_order`. A fit explains the readings where it leaves no
/// more than a thousandth of their energy without 0X, plus one and a half times the energy of the noise: ten
/// times what two windows of a map may leave, because whatever vibrates above half the sampling rate is
/// folded to orders where no line belongs. A rotor that rubs and one that does not look alike where both
/// repeat: probes do not see contacts.
ProbePeriod find_period(const std::vector<std::complex<double>>& displacement_m, double sample_s,
                        double speed_hz, double noise_m, int turns, int max_order);

/// Full spectrum of the last readings, over as near to a whole number of periods of `period` turns as there
/// is in the second half of `turns` turns.
response::spectrum::FullSpectrum probe_spectrum(const std::vector<std::complex<double>>& displacement_m,
                                                double sample_s, double speed_hz, int turns, int period,
                                                response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::trace
