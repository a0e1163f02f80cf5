#include "rubsweep/core/integrate/exact/modes/mode_change.hpp"

namespace rubsweep::integrate::exact::modes {

using numerics::LongMatrix;
using numerics::LongVector;

template <int N>
ModeChange<N> make_mode_change(const LinearMode<N>& from, const LinearMode<N>& to) {
  const LongMatrix by = to.unrounded.inverse * from.unrounded.basis;
  LongVector apart = LongVector::Zero(by.rows());
  apart.head(from.unrounded.rest.size()) = from.unrounded.rest - to.unrounded.rest;
  const LongVector constant = to.unrounded.inverse * apart;
  return {typename ExactTypes<N>::Factor(Eigen::MatrixXd(by.cast<double>())), constant.cast<double>()};
}

template <int N>
HarmonicChange<N> make_harmonic_change(const LinearMode<N>& to, const HarmonicResponse<N>& in_from,
                                       const HarmonicResponse<N>& in_to) {
  const Eigen::Index n = to.rest.size();
  // Re(d phasor) of displacements and Re(i rate d phasor) of velocities, for both parts of the phasor.
  LongMatrix apart(2 * n, 2);
  const long double rate = in_to.rate;
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::complex<long double> d = in_from.unrounded_amplitude(j) - in_to.unrounded_amplitude(j);
    apart.row(j) << d.real(), -d.imag();
    apart.row(n + j) << -rate * d.imag(), -rate * d.real();
  }
  const LongMatrix change = to.unrounded.inverse * apart;
  return {change.col(0).cast<double>(), change.col(1).cast<double>()};
}

template ModeChange<2> make_mode_change<2>(const LinearMode<2>&, const LinearMode<2>&);
template ModeChange<4> make_mode_change<4>(const LinearMode<4>&, const LinearMode<4>&);
template ModeChange<6> make_mode_change<6>(const LinearMode<6>&, const LinearMode<6>&);
template ModeChange<Eigen::Dynamic> make_mode_change<Eigen::Dynamic>(const LinearMode<Eigen::Dynamic>&,
                                                                     const LinearMode<Eigen::Dynamic>&);
template HarmonicChange<2> make_harmonic_change<2>(const LinearMode<2>&, const HarmonicResponse<2>&,
                                                   const HarmonicResponse<2>&);
template HarmonicChange<4> make_harmonic_change<4>(const LinearMode<4>&, const HarmonicResponse<4>&,
                                                   const HarmonicResponse<4>&);
template HarmonicChange<6> make_harmonic_change<6>(const LinearMode<6>&, const HarmonicResponse<6>&,
                                                   const HarmonicResponse<6>&);
template HarmonicChange<Eigen::Dynamic> make_harmonic_change<Eigen::Dynamic>(
    const LinearMode<Eigen::Dynamic>&, const HarmonicResponse<Eigen::Dynamic>&,
    const HarmonicResponse<Eigen::Dynamic>&);

}  // namespace rubsweep::integrate::exact::modes
