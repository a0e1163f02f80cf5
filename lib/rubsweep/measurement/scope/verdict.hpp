#pragma once

#include <cmath>
#include <complex>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rubsweep/core/response/spectrum/orbit_shape.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::scope {

/// Class of a measured motion. Probes do not detect contacts: a quiet rotor and a synchronous rub look alike.
enum class MeasuredClass {
  at_rest,      ///< no line stands out of the noise
  synchronous,  ///< repeats every turn
  subharmonic,  ///< repeats after 2 to max_period turns
  /// Subharmonic within the accuracy of the recording, but perhaps a torus: the motion may turn against the
  /// shaft (may_be_torus).
  subharmonic_or_torus,
  quasi_periodic,  ///< no period; the lines are the same in both halves of the recording
  aperiodic        ///< no period; the lines differ between the halves: chaos, or a machine that changes
};
std::string_view to_string(MeasuredClass value);

/// One line of a motion that repeats.
struct MeasuredLine {
  double order = 0;                      ///< multiple of the shaft speed, negative for backward whirl
  std::complex<double> amplitude_m = 0;  ///< A of A e^{i order phi}; phi = 0 at the mark
  double uncertainty_m = 0;  ///< standard uncertainty of each component: noise and error of the method
};

/// A line of a motion without a period, at any place between the bins.
struct DiscreteLine {
  double order = 0, order_uncertainty = 0;
  double amplitude_m = 0, amplitude_uncertainty_m = 0;
  double phase_rad = 0;  ///< phase at the beginning of the orbit
};
inline constexpr int most_discrete_lines = 16;

/// A longer period that the noise does not rule out, but that a longer recording would show or rule out.
struct DoubtfulPeriod {
  int turns = 0;           ///< period
  double amplitude_m = 0;  ///< largest line of the longer period that the shorter period lacks
  double more_turns = 0;   ///< number of further turns after which this line would be visible or ruled out
};

/// Limits that decide the class.
struct Thresholds {
  double least_share = 5e-3;  ///< smallest line that counts for a period / largest line
  double most_modulation =
      0.1;  ///< share of the motion by which lines may vary and still belong to their period
};

struct Verdict {
  MeasuredClass motion = MeasuredClass::at_rest;
  int turns = 0;                ///< evaluated turns, in whole periods
  std::optional<int> period{};  ///< period in turns; empty: no period up to longest_period
  int longest_period = 0;       ///< longest period that this recording can show
  std::optional<DoubtfulPeriod> doubtful{};
  /// Largest possible distance of a subharmonic's lines from the multiples of 1 / period, in orders.
  std::optional<double> order_room{};
  double noise_m = 0;       ///< standard uncertainty of each component of a line, where integrated that of 1X
  double visible_m = 0;     ///< smallest amplitude of a line that counts, where integrated of 1X
  double modulation_m = 0;  ///< root mean square of the slow modulation of the period's lines
  /// Root mean square of the slow modulation of whole orders that exceeds the limit; it belongs to no period.
  double refused_modulation_m = 0;
  double beside_m = 0;  ///< largest line outside the period
  double seen_m = 0;    ///< smallest line outside the period that exceeds the noise
  std::vector<std::complex<double>>
      orbit_m{};                      ///< mean period about its centre; without a period, the last turns
  std::vector<MeasuredLine> lines{};  ///< lines of that orbit, |order| <= most_order, ascending
  std::vector<DiscreteLine> discrete_lines{};  ///< lines of a motion without a period, the largest first
  std::optional<response::spectrum::OrbitKind> shape{};     ///< orbit shape, with two probes
  std::optional<response::spectrum::WhirlKind> whirl{};     ///< whirl direction, with two probes
  double forward_share = 0, forward_share_uncertainty = 0;  ///< share of the energy without 0X
  Thresholds thresholds{};                                  ///< limits that were used
  recording::Integration integration{};                     ///< slope of the noise over the orders

  /// Standard uncertainty of each component of the line at an order, by noise.
  double noise_at(double order) const { return noise_m * integration.noise_at(order); }
};

inline constexpr int max_period = 8;
inline constexpr double most_order = 8;

/// Properties of the readings of a motion.
struct Reading {
  double readings_per_turn = INFINITY;  ///< > 0
  recording::AngleDoubt angle_doubt{};
  Thresholds thresholds{};
  recording::Integration integration{};

  /// Largest share of a line that is lost by interpolation through six readings (recording/shaft_turns.hpp).
  double missed_share(double order) const;
};

/// In a motion without a period: the first line between the bins whose nearest bin has this order; null if
/// there is none.
const DiscreteLine* line_of_bin(const Verdict& verdict, double order);

/// Whether the lines of a motion with a period may be those of a torus that turns against the shaft by more
/// than a tenth of a turn over the recording.
bool may_be_torus(const Verdict& verdict);

/// Classifies a motion over whole turns, given by `samples_per_revolution` equally spaced samples per turn.
/// `plane`: x + iy of two probes; otherwise the reading of one probe. Needs at least 4 turns; a period of n
/// turns is found in at least three periods.
///
/// The noise is the median amplitude of the lines between the multiples of 1/1 to 1/8 (of every second line
/// where these are too few), evaluated as a Rayleigh distribution. A line is visible if it exceeds its share
/// of the largest line, and if noise would produce such a line in only 1 % of all recordings. The period is
/// the smallest number n of turns for which all visible lines are multiples of 1/n. For each n the motion is
/// resampled to repeat best, within the errors of the marks, and freed of the slow modulation of its lines
/// (repeating_angles.hpp). Orders above 0.4 of the readings per turn are left out, because interpolation of
/// the readings changes the noise there. With `reading.integration` the samples are derivatives of the
/// displacement: their noise counts, and the orbit and its lines are integrated. See
/// docs/method/recordings.md.
Verdict judge(std::span<const std::complex<double>> displacement_m, int samples_per_revolution, bool plane,
              const Reading& reading = {});

/// Classifies the motion of a recording.
Verdict judge(const recording::Recording& recording, const Thresholds& thresholds = {});

}  // namespace rubsweep::scope
