#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::diagnose {

/// Full spectrum of a motion over whole turns of the shaft, with phases: z = sum over k of A_k exp(i k phi /
/// turns).
struct MotionLines {
  int turns = 0;                 ///< of the shaft
  Eigen::VectorXcd amplitude{};  ///< A_k in metres, k from -last() to last(); of one probe A_-k = conj(A_k)

  int last() const { return static_cast<int>(amplitude.size() / 2); }
  std::complex<double> at(int k) const { return amplitude(k + last()); }
  std::complex<double>& at(int k) { return amplitude(k + last()); }
};

/// Spectrum of equidistant samples over whole turns up to an order; SolverError where there are too few
/// samples for it.
MotionLines lines_of(std::span<const std::complex<double>> samples, int turns, double most_order,
                     response::spectrum::SpectrumWorkspace& workspace);

/// Its lines up to an order.
MotionLines up_to(const MotionLines& lines, double most_order);

/// Motion without its mean from its lines: so many samples of every turn, more than twice the largest order.
Eigen::VectorXcd waveform_of(const MotionLines& lines, int samples_per_revolution,
                             response::spectrum::SpectrumWorkspace& workspace);

/// Root mean square of the motion about its mean, m.
double size_of(const MotionLines& lines);

}  // namespace rubsweep::diagnose
