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

/// Probes that sample a run at the times of their own clock, as an instrument does.
struct Probes {
  Eigen::MatrixXd rows;           ///< probes x n: displacement in metres = row . q
  std::vector<double> angle_deg;  ///< direction of each probe, from +x towards +y
  double sample_s = 1e-3;         ///< sampling interval, > 0
  /// Number of derivatives that each probe takes: 0 reads m, 1 m/s, 2 m/s2; empty: displacements.
  std::vector<int> derivative{};
  /// Standard deviation of the white noise of each probe in its own unit, the same numbers in every run;
  /// empty: none has any.
  std::vector<double> noise{};
  std::vector<std::string> name{};  ///< name of each probe; empty: none has one

  /// Standard deviation of the noisiest displacement.
  double noise_m() const;
};

/// Largest number of samples per turn between which readings are interpolated.
inline constexpr int probe_samples_per_revolution = 4096;

/// Number of finer steps for each of `samples_per_revolution`; all together are at most
/// `probe_samples_per_revolution`. A cubic through values and rates at 4096 samples misses a vibration of
/// order p by (2 pi p / 4096)^4 / 384 of its amplitude: 1e-7 at order 50.
int probe_refinement(int samples_per_revolution);

/// Takes readings at t = 0, sample_s, ... from a run with finely spaced samples. Velocity and acceleration
/// are those of the cubic between two samples: an acceleration misses a vibration of order p by (2 pi p /
/// 4096)^2 / 12 of its amplitude, and the jump of a velocity has a finite one. There is no filter.
class ProbeReader {
 public:
  ProbeReader(const scene::Scene& scene, double speed_hz, Probes probes);

  /// Takes the readings within the next whole turn, which must have samples and a section.
  void add(const integrate::run::TurnReport& turn);

  /// Readings of all turns so far with noise added, readings x probes, in m, m/s or m/s2.
  Eigen::MatrixXd readings() const;

 private:
  double reading(const integrate::run::TurnReport& turn, double turns, Eigen::Index probe) const;

  Probes probes_;
  double length_m_, speed_hz_, speed_rad_per_s_;
  std::size_t states_;
  long turn_ = 0, count_ = 0;
  std::vector<double> readings_;  ///< readings of all probes at t = 0, then at the next time, ...
};

/// Numbers of two probes that measure the motion at one place in two directions.
using ProbePair = std::pair<std::size_t, std::size_t>;

/// First two probes at one place whose directions are not parallel by at least 10 degrees; empty where there
/// are none. `places_m`: position of each probe along the shaft.
std::optional<ProbePair> pair_of(const std::vector<double>& angle_deg, const std::vector<double>& places_m);

/// Displacement z = x + iy of the shaft at the pair's place, in metres.
std::vector<std::complex<double>> displacement_of(const Eigen::MatrixXd& readings_m, const ProbePair& pair,
                                                  const std::vector<double>& angle_deg);

/// Period of a pair's readings at the end of a run, found from the readings alone.
struct ProbePeriod {
  int readings = 0;
  /// Smallest n up to max_order for which lines at multiples of 1/n explain the readings; empty if none.
  std::optional<int> period;
  /// Share of the energy, without 0X, that lines at multiples of 1/n (or of the best n) do not explain.
  double unexplained_share = 0;
  double allowed_share = 0;  ///< largest unexplained share with which readings count as explained
};

/// Finds the smallest period n, up to `max_order` turns, that explains the last readings of `turns` turns.
/// For each n, lines at the orders k / n are fitted by least squares, with |k / n| up to 8 and below half the
/// sampling rate. A fit explains the readings if it leaves at most a thousandth of their energy without 0X,
/// plus 1.5 times the energy of the noise. This limit is ten times that for two windows of a map, because
/// vibration above half the sampling rate is folded to orders without a line. Probes cannot distinguish a
/// rotor that rubs from a rotor that does not, if both motions repeat.
ProbePeriod find_period(const std::vector<std::complex<double>>& displacement_m, double sample_s,
                        double speed_hz, double noise_m, int turns, int max_order);

/// Full spectrum of the last readings. Its window is nearly a whole number of periods, each of `period`
/// turns: as many as fit into the second half of `turns` turns.
response::spectrum::FullSpectrum probe_spectrum(const std::vector<std::complex<double>>& displacement_m,
                                                double sample_s, double speed_hz, int turns, int period,
                                                response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::trace
