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

/// Class of a measured motion. Probes do not see contacts: a quiet rotor and a synchronous rub look alike.
enum class MeasuredClass {
  at_rest,         ///< no line stands out of the noise
  synchronous,     ///< repeats every turn
  subharmonic,     ///< repeats after 2 to max_period turns
  /// Repeats so as well as the recording can tell, and may turn against the shaft (may_be_torus).
  subharmonic_or_torus,
  quasi_periodic,  ///< does not, and its lines stay where they are from one half of the recording to the
                   ///< other
  aperiodic        ///< does not, and they do not: chaos, or a machine that was changing
};
std::string_view to_string(MeasuredClass value);

/// One line of the motion that repeats.
struct MeasuredLine {
  double order = 0;                      ///< in multiples of the shaft speed, negative for backward whirl
  std::complex<double> amplitude_m = 0;  ///< A of A e^{i order phi}; phi = 0 at the mark
  double uncertainty_m = 0;              ///< standard, of each component: noise and the method's own
};

/// A line of a motion without a period, wherever it stands between the bins.
struct DiscreteLine {
  double order = 0, order_uncertainty = 0;
  double amplitude_m = 0, amplitude_uncertainty_m = 0;
  double phase_rad = 0;  ///< at the begin of the orbit
};
inline constexpr int most_discrete_lines = 16;

/// A period that the noise does not exclude, but that would show if the recording were longer.
struct DoubtfulPeriod {
  int turns = 0;           ///< period
  double amplitude_m = 0;  ///< amplitude of its largest line that a shorter period does not have
  double more_turns = 0;   ///< after which this line would stand out of the noise or be gone
};

/// Shares that decide the class.
struct Thresholds {
  double least_share = 5e-3;  ///< smallest line that counts for a period, of the largest one
  double most_modulation =
      0.1;  ///< share of the motion by which lines may vary and still belong to their period
};

struct Verdict {
  MeasuredClass motion = MeasuredClass::at_rest;
  int turns = 0;                ///< turns that were looked at, whole periods
  std::optional<int> period{};  ///< in turns; empty: none up to the longest that the recording can tell
  int longest_period = 0;       ///< longest one that the recording can tell
  std::optional<DoubtfulPeriod> doubtful{};
  /// How far the lines of a subharmonic may stand beside multiples of 1 / period, in orders.
  std::optional<double> order_room{};
  double noise_m = 0;       ///< standard uncertainty of each component of a line
  double visible_m = 0;     ///< smallest amplitude of a line that counts
  double modulation_m = 0;  ///< root mean square of what the lines of the period slowly vary by
  /// The same of the lines of whole orders, of no period: more than they may vary by.
  double refused_modulation_m = 0;
  double beside_m = 0;  ///< largest line beside the period
  double seen_m = 0;    ///< smallest amplitude of such a line that noise does not reach
  std::vector<std::complex<double>>
      orbit_m{};                      ///< mean of all periods about its centre; of no period, the last turns
  std::vector<MeasuredLine> lines{};  ///< lines of that orbit, |order| <= most_order, ascending
  std::vector<DiscreteLine> discrete_lines{};  ///< lines of a motion without a period, the largest first
  std::optional<response::spectrum::OrbitKind> shape{};     ///< orbit of two probes
  std::optional<response::spectrum::WhirlKind> whirl{};     ///< whirl of two probes
  double forward_share = 0, forward_share_uncertainty = 0;  ///< share of the energy without 0X
  Thresholds thresholds{};                                  ///< thresholds that decided
};

inline constexpr int max_period = 8;
inline constexpr double most_order = 8;

/// How a motion was read.
struct Reading {
  double readings_per_turn = INFINITY;  ///< > 0
  recording::AngleDoubt angle_doubt{};
  Thresholds thresholds{};

  /// Share of a line that the polynomial through six readings misses at most (recording/shaft_turns.hpp).
  double missed_share(double order) const;
};

/// The line between the bins that stands nearest to a bin of a motion without a period, if that is its
/// nearest bin.
const DiscreteLine* line_of_bin(const Verdict& verdict, double order);

/// Whether the lines of a motion with a period may be those of a torus that turns against the shaft by more than a
/// tenth of a turn over the recording.
bool may_be_torus(const Verdict& verdict);

/// Judges whole turns of a motion, `samples_per_revolution` equally spaced ones each; `plane`: x + iy of two
/// probes, else the reading of one. Needs 4 turns or more. A period of n turns is told by three of them or
/// more.
///
/// Noise is the median amplitude of the lines between the multiples of 1/1 to 1/8 (of every other line where
/// there are too few), read as that of a Rayleigh distribution. A line is visible when noise alone would
/// raise one of all lines as high in a hundredth of all recordings, and above its threshold of the largest
/// line. The period is the smallest number of turns beside whose multiples nothing is visible, at the angles
/// at which the motion repeats best after that many turns, within the doubt that the marks leave, and without
/// the slow modulation of its lines (slow_modulation.hpp). Lines above 0.4 of the readings of a turn are not
/// looked at: there is no order between those and half of them whose noise the interpolation of the readings
/// leaves as it is. docs/method/recordings.md.
Verdict judge(std::span<const std::complex<double>> displacement_m, int samples_per_revolution, bool plane,
              const Reading& reading = {});

/// Judges a recording.
Verdict judge(const recording::Recording& recording, const Thresholds& thresholds = {});

}  // namespace rubsweep::scope
