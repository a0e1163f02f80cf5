#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact::modes {

inline double real_product(const std::complex<double>& a, const std::complex<double>& b) {
  return a.real() * b.real() - a.imag() * b.imag();
}

/// Complex product without the checks for infinities in std::complex.
inline std::complex<double> product(const std::complex<double>& a, const std::complex<double>& b) {
  return {real_product(a, b), a.real() * b.imag() + a.imag() * b.real()};
}

/// Response of one contact mode to one harmonic force (unbalance, or the half-sine of a kick): u =
/// Re(amplitude e^{i rate t}); the caller stores the phasor e^{i rate t}. The other members are the
/// contributions to guards, forces and sliding speeds of the mode, so that the time loop need not compute
/// them from u.
template <int N>
struct HarmonicResponse {
  using Complex = std::complex<double>;
  using State = typename ExactTypes<N>::State;

  double rate = 0;  ///< rad/s
  Eigen::Matrix<Complex, N, 1> amplitude;
  Eigen::Matrix<std::complex<long double>, N, 1> unrounded_amplitude;  ///< only for compile-time N
  std::vector<Complex> at_guard;
  std::vector<double> curvature;  ///< bound for each guard: |at_guard| rate^2
  /// Per guard: Taylor coefficients as in LinearGuard, for real and imaginary part of the phasor.
  std::vector<numerics::SeriesTable<2>> taylor;
  std::vector<std::array<Complex, 2>> at_annular_guard;
  std::vector<double> annular_length;     ///< bound for each annular stop on |at_annular_guard e^{i rate t}|
  std::vector<Complex> at_force;          ///< normal force at each touch
  std::vector<double> force_curvature;    ///< bound for each touch: |at_force| rate^2
  std::vector<Complex> at_sliding;        ///< sliding speed at each touch
  std::vector<double> sliding_curvature;  ///< bound for each touch: |at_sliding| rate^2
  std::vector<std::array<Complex, 2>> at_casing;
  std::array<Complex, numerics::exact_step_count>
      steps{};  ///< e^{i rate h} of the table's steps; 0: not yet computed

  /// Adds the forced part of (u, u').
  void add_to(State& state, const Complex& phasor) const {
    const Eigen::Index n = amplitude.size();
    for (Eigen::Index j = 0; j < n; ++j) {
      const Complex z = product(amplitude(j), phasor);
      state(j) += z.real();
      state(n + j) -= rate * z.imag();
    }
  }

  /// Factor e^{i rate h} by which a step of the mode's table, of length h, turns the phasor.
  Complex turned_by(std::size_t table_step, double longest_step_s) {
    Complex& turn = steps[table_step];
    if (turn == Complex{})
      turn = std::polar(1.0, rate * longest_step_s * numerics::exact_step_sizes[table_step]);
    return turn;
  }

  /// Adds an even number of Taylor coefficients of its contribution to guard `e`; time is in units of 1 /
  /// fastest_rad_per_s of the mode.
  void expand(std::size_t e, const Complex& phasor, std::span<double> terms) const {
    numerics::add_terms(terms, numerics::SeriesColumn{taylor[e].col(0).data(), phasor.real()},
                        numerics::SeriesColumn{taylor[e].col(1).data(), phasor.imag()});
  }
};

/// Computes the response of u'' = -K u - C u' + Re(force e^{i rate t}) in the mode. False at an undamped
/// resonance.
template <int N>
bool make_harmonic_response(const LinearMode<N>& mode, const Eigen::VectorXcd& force, double rate_rad_per_s,
                            HarmonicResponse<N>& response);

}  // namespace rubsweep::integrate::exact::modes
