#pragma once

#include "rubsweep/core/integrate/exact/modes/harmonic_response.hpp"
#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"

namespace rubsweep::integrate::exact::modes {

/// Transformation of the free vibration from one contact mode to another at an unchanged state: z' = by z +
/// constant, plus contributions of harmonic forces. A contact is as stiff as thousands of shafts, so that the
/// rounding of a displacement of one clearance is a considerable force. But the contact depends almost only
/// on one pair of z, that of its own fast vibration, which is small. The transformation therefore avoids
/// displacements: the difference of the two modes is computed in long double, and only the result is rounded.
template <int N>
struct ModeChange {
  typename ExactTypes<N>::Factor by;
  typename ExactTypes<N>::State constant;
};

/// Computes the change between modes that have kept their unrounded matrices (LinearMode::unrounded).
template <int N>
ModeChange<N> make_mode_change(const LinearMode<N>& from, const LinearMode<N>& to) {
  const numerics::LongMatrix by = to.unrounded.inverse * from.unrounded.basis;
  numerics::LongVector apart = numerics::LongVector::Zero(by.rows());
  apart.head(from.unrounded.rest.size()) = from.unrounded.rest - to.unrounded.rest;
  const numerics::LongVector constant = to.unrounded.inverse * apart;
  return {typename ExactTypes<N>::Factor(Eigen::MatrixXd(by.cast<double>())), constant.cast<double>()};
}

/// Contribution of a harmonic force to z': Re(phasor) real + Im(phasor) imaginary.
template <int N>
struct HarmonicChange {
  typename ExactTypes<N>::State real, imaginary;
};

/// Computes the change from the responses of both modes to the force.
template <int N>
HarmonicChange<N> make_harmonic_change(const LinearMode<N>& to, const HarmonicResponse<N>& in_from,
                                       const HarmonicResponse<N>& in_to) {
  const Eigen::Index n = to.rest.size();
  // Re(d phasor) of displacements and Re(i rate d phasor) of velocities, for both parts of the phasor.
  numerics::LongMatrix apart(2 * n, 2);
  const long double rate = in_to.rate;
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::complex<long double> d = in_from.unrounded_amplitude(j) - in_to.unrounded_amplitude(j);
    apart.row(j) << d.real(), -d.imag();
    apart.row(n + j) << -rate * d.imag(), -rate * d.real();
  }
  const numerics::LongMatrix change = to.unrounded.inverse * apart;
  return {change.col(0).cast<double>(), change.col(1).cast<double>()};
}

}  // namespace rubsweep::integrate::exact::modes
