#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/analysis/trace/probe.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::trace {

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
  double allowed_share = 0;  ///< by which they count as explained
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
