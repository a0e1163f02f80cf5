#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <span>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose {

/// Full spectrum of a motion over whole turns of the shaft, with phases: z = sum over k of A_k exp(i k phi /
/// turns).
struct MotionLines {
  int turns = 0;                 ///< turns of the shaft
  Eigen::VectorXcd amplitude{};  ///< A_k in metres, k from -last() to last(); of one probe A_-k = conj(A_k)

  int last() const { return static_cast<int>(amplitude.size() / 2); }
  std::complex<double> at(int k) const { return amplitude(k + last()); }
  std::complex<double>& at(int k) { return amplitude(k + last()); }
};

/// Spectrum of equidistant samples over whole turns up to an order; SolverError where there are too few
/// samples for it.
MotionLines lines_of(std::span<const std::complex<double>> samples, int turns, double largest_order,
                     response::spectrum::SpectrumWorkspace& workspace);

/// Its lines up to an order.
MotionLines up_to(const MotionLines& lines, double largest_order);

/// Motion without its mean from its lines: so many samples of every turn, more than twice the largest order.
Eigen::VectorXcd waveform_of(const MotionLines& lines, int samples_per_turn,
                             response::spectrum::SpectrumWorkspace& workspace);

/// Root mean square of the motion about its mean, m.
double size_of(const MotionLines& lines);

/// Largest shares of a motion's size (root mean square about its mean) that lines may have which no rub made:
/// unequal supports, couplings, run-out that was left. Each share is drawn anew, its logarithm evenly from
/// `smallest_share` on, and its phase.
struct OtherLines {
  double backward_1x = 0.2, order_2 = 0.1, order_3 = 0.03;
  static constexpr double smallest_share = 1e-3;
};

/// Size of a motion: root mean square about its mean, in the unit of the samples.
double size_of(std::span<const std::complex<double>> samples);

/// A line that no rub made.
struct OtherLine {
  int order = 0;
  std::complex<double> amplitude = 0;  ///< in the unit of the motion
};

/// Adds lines at -1X, 2X and 3X that no rub made to a motion of this size.
void add_other_lines(std::span<std::complex<double>> samples, const OtherLines& lines, double size,
                     RandomStream& random);

/// How motions are measured, as far as it is known before a recording is looked at.
struct Measuring {
  int probes = 2;  ///< 2: x and y; 1: in one direction
  double readings_per_turn = 0;
  /// Whether the machine is not the same in all directions, and those of the probes are known.
  bool directions = false;
  double probe_angle_rad = 0;  ///< of one probe whose direction is known, from +x to +y
  bool from_rest = false;      ///< readings count from where the rotor rests
  Spread noise_share{1e-3, 3e-2,
                     true};  ///< white noise of every reading, standard deviation / size of the motion
  OtherLines other_lines{};  ///< run-out and the like: lines at 1X, 2X, 3X
  double gain_error = 0.02;  ///< standard deviation of each probe's gain about 1
  /// Standard deviation of the place of rest, in x and in y, over the size of the motion: a shaft rests where
  /// it was left.
  static constexpr double rest_error = 0.02;
};

/// Lines that an instrument makes of a motion: run-out and lines of other origin, the gains of the probes,
/// and noise, all drawn. One probe stands in a direction that is drawn, too, unless it is known, and comes
/// back in `probe_angle_rad`, from +x to +y.
MotionLines observed(const MotionLines& motion, const Measuring& measuring, RandomStream& random,
                     double& probe_angle_rad);

}  // namespace rubsweep::diagnose
