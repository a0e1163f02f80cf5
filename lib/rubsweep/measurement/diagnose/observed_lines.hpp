#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose {

/// Full spectrum of a motion over whole turns of the shaft, with phases: z = sum over k of A_k exp(i k phi /
/// turns), phi being the shaft angle.
struct MotionLines {
  int turns = 0;                 ///< turns of the shaft
  Eigen::VectorXcd amplitude{};  ///< A_k in metres, k from -last() to last(); with one probe A_-k = conj(A_k)

  int last() const { return static_cast<int>(amplitude.size() / 2); }
  std::complex<double> at(int k) const { return amplitude(k + last()); }
  std::complex<double>& at(int k) { return amplitude(k + last()); }
};

/// Spectrum up to an order from equidistant samples over whole turns. Throws SolverError where there are too
/// few samples for this order.
MotionLines lines_of(std::span<const std::complex<double>> samples, int turns, double largest_order,
                     response::spectrum::SpectrumWorkspace& workspace);

MotionLines up_to(const MotionLines& lines, double largest_order);  ///< The lines up to an order.

/// Motion without its mean, computed from its lines. `samples_per_turn`: more than twice the largest order.
Eigen::VectorXcd waveform_of(const MotionLines& lines, int samples_per_turn,
                             response::spectrum::SpectrumWorkspace& workspace);

double size_of(const MotionLines& lines);  ///< Root mean square of the motion about its mean, m.

/// Largest amplitudes of lines that come from unequal supports, couplings or remaining run-out instead of a
/// rub, as shares of the motion's size (root mean square about its mean). Each share is drawn uniformly in
/// its logarithm from `smallest_share` on, and each phase uniformly.
struct OtherLines {
  double backward_1x = 0.2, order_2 = 0.1, order_3 = 0.03;
  static constexpr double smallest_share = 1e-3;
};

/// Size of a motion: root mean square about its mean, in the unit of the samples.
double size_of(std::span<const std::complex<double>> samples);

/// Adds lines at -1X, 2X, -2X, 3X and -3X that no rub caused to a motion of this size.
void add_other_lines(std::span<std::complex<double>> samples, const OtherLines& lines, double size,
                     RandomStream& random);

/// Properties of the measurement, as far as they are known before the recording is analysed.
struct Measuring {
  int probes = 2;  ///< 2: x and y; 1: in one direction only
  double readings_per_turn = 0;
  bool directions = false;     ///< Whether the machine is anisotropic and probe directions are known.
  double probe_angle_rad = 0;  ///< direction of a single probe where it is known, from +x to +y
  bool from_rest = false;      ///< whether readings are measured from the rest position of the rotor
  /// white noise of every reading, standard deviation / size of the motion
  Spread noise_share{1e-3, 3e-2, true};
  OtherLines other_lines{};      ///< run-out and the like: lines at 1X, 2X, 3X
  double gain_error = 0.02;      ///< standard deviation of each probe's gain about 1
  double free_vibration = 0.01;  ///< largest amplitude of a free vibration / size of the motion
  double natural_order = 0;      ///< natural frequency / speed, known to 2 %; 0: not known
  /// Standard deviation of the rest position, in x and in y, divided by the size of the motion: a shaft does
  /// not always come to rest at the same place.
  static constexpr double rest_error = 0.02;
};

/// Lines of a motion as an instrument measures them, with random run-out and lines of other origin, a small
/// free vibration, probe gains, and noise. The direction of a single probe is drawn as well, unless it is
/// known, and returned in `probe_angle_rad`, from +x to +y. Shares are those of the motion's size, or
/// of `usual_size_m` if that is larger: run-out does not shrink with the motion.
MotionLines observed(const MotionLines& motion, const Measuring& measuring, RandomStream& random,
                     double& probe_angle_rad, double usual_size_m = 0);

}  // namespace rubsweep::diagnose
