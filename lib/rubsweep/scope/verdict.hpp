#pragma once

#include <cmath>
#include <complex>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rubsweep/recording/recording.hpp"
#include "rubsweep/response/spectrum/orbit_shape.hpp"

namespace rubsweep::scope {

/// Class of a measured motion. Probes do not see contacts: a quiet rotor and a synchronous rub look alike.
enum class MeasuredClass {
  at_rest,         ///< no line stands out of the noise
  synchronous,     ///< repeats every turn
  subharmonic,     ///< repeats after 2 to max_period turns
  quasi_periodic,  ///< does not, and its lines stay where they are from one half of the recording to the
                   ///< other
  aperiodic        ///< does not, and they do not: chaos, or a machine that was changing
};
std::string_view to_string(MeasuredClass value);

/// One line of the motion that repeats.
struct MeasuredLine {
  double order = 0;                      ///< in multiples of the shaft speed, negative for backward whirl
  std::complex<double> amplitude_m = 0;  ///< A of A e^{i order phi}; phi = 0 at the mark
};

/// A period that the noise does not exclude, but that would show if the recording were longer.
struct DoubtfulPeriod {
  int turns = 0;           ///< period
  double amplitude_m = 0;  ///< of its largest line that a shorter period does not have
  double more_turns = 0;   ///< after which this line would stand out of the noise or be gone
};

struct Verdict {
  MeasuredClass motion = MeasuredClass::at_rest;
  int turns = 0;                ///< that were looked at, whole periods
  std::optional<int> period{};  ///< in turns; empty: none up to the longest that the recording can tell
  int longest_period = 0;       ///< that the recording can tell
  std::optional<DoubtfulPeriod> doubtful{};
  double noise_m = 0;    ///< standard uncertainty of each component of a line
  double visible_m = 0;  ///< smallest amplitude of a line that is not taken for noise
  std::vector<std::complex<double>>
      orbit_m{};                      ///< mean of all periods about its centre; of no period, the last turns
  std::vector<MeasuredLine> lines{};  ///< of that orbit, |order| <= most_order, ascending
  std::optional<response::spectrum::OrbitKind> shape{};     ///< of two probes
  std::optional<response::spectrum::WhirlKind> whirl{};     ///< of two probes
  double forward_share = 0, forward_share_uncertainty = 0;  ///< of the energy without 0X
};

inline constexpr int max_period = 8;
inline constexpr double most_order = 8;

/// How a motion was read.
struct Reading {
  double readings_per_turn = INFINITY;  ///< > 0
  recording::AngleDoubt angle_doubt{};
};

/// Judges whole turns of a motion, `samples_per_revolution` equally spaced ones each; `plane`: x + iy of two
/// probes, else the reading of one. Needs 4 turns or more. A period of n turns is told by three of them or
/// more.
///
/// Noise is the median amplitude of the lines between the multiples of 1/1 to 1/8 (of every other line where
/// there are too few), read as that of a Rayleigh distribution. A line is visible when noise alone would
/// raise one of all lines as high in a hundredth of all recordings, and above a thousandth of the largest
/// line. The period is the smallest number of turns beside whose multiples nothing is visible, at the angles
/// at which the motion repeats best after that many turns: within the doubt that the marks leave. Lines above
/// 0.4 of the readings of a turn are not looked at: there is no order between those and half of them whose
/// noise the interpolation of the readings leaves as it is. docs/method.md, "Period of a recording".
Verdict judge(std::span<const std::complex<double>> displacement_m, int samples_per_revolution, bool plane,
              const Reading& reading = {});

/// Judges a recording.
Verdict judge(const recording::Recording& recording);

}  // namespace rubsweep::scope
