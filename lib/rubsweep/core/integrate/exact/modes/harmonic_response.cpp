#include "rubsweep/core/integrate/exact/modes/harmonic_response.hpp"

#include <Eigen/LU>
#include <cmath>

#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

/// Largest forced amplitude, in clearances. A larger one means an undamped resonance, where the cancellation
/// against the free part would lose digits.
constexpr double largest_amplitude = 1e4;

using Complex = std::complex<double>;

/// Largest length of the vector (Re(a e^{it}), Re(b e^{it})).
double longest(const Complex& a, const Complex& b) {
  const Complex i(0, 1);
  return (std::abs(a + i * b) + std::abs(a - i * b)) / 2;
}

template <class Row>
Complex row_on(const Row& row, const Eigen::VectorXcd& amplitude, double rate) {
  const Eigen::Index n = amplitude.size();
  Complex sum = 0;
  for (Eigen::Index j = 0; j < n; ++j) sum += product({row(j), rate * row(n + j)}, amplitude(j));
  return sum;
}

/// Taylor coefficients of Re(amplitude e^{i rate t} phasor) for both parts of the phasor.
numerics::SeriesTable<2> taylor_of(Complex amplitude, double rate) {
  numerics::SeriesTable<2> terms = numerics::SeriesTable<2>::Zero();
  for (std::size_t k = 0; k < numerics::most_series_terms; ++k) {
    terms.row(static_cast<Eigen::Index>(k)) << amplitude.real(), -amplitude.imag();
    const double by_i = rate * numerics::reciprocals[k + 1];
    amplitude = {-by_i * amplitude.imag(), by_i * amplitude.real()};
  }
  return terms;
}

/// Dynamic stiffness: stiffness - rate^2 + i rate damping.
template <int N, class Number, class Matrix>
Eigen::Matrix<std::complex<Number>, N, N> dynamic_stiffness(const Matrix& stiffness, const Matrix& damping,
                                                            Number rate) {
  using Cast = std::complex<Number>;
  Eigen::Matrix<Cast, N, N> dynamic = stiffness.template cast<Cast>();
  dynamic.diagonal().array() -= rate * rate;
  dynamic += Cast(0, rate) * damping.template cast<Cast>();
  return dynamic;
}

/// Two steps of iterative refinement: residuals in long double, factors in double precision suffice.
template <int N, class Factors>
void refine(const UnroundedMode& mode, const Factors& factors, const Eigen::VectorXcd& force,
            HarmonicResponse<N>& response) {
  using Cast = std::complex<long double>;
  const auto dynamic =
      dynamic_stiffness<N>(mode.stiffness, mode.damping, static_cast<long double>(response.rate));
  const Eigen::Matrix<Cast, N, 1> side = force.template cast<Cast>();
  response.unrounded_amplitude = response.amplitude.template cast<Cast>();
  for (int k = 0; k < 2; ++k) {
    const Eigen::Matrix<Cast, N, 1> defect = side - dynamic * response.unrounded_amplitude;
    const Eigen::Matrix<Complex, N, 1> change =
        factors.solve(Eigen::Matrix<Complex, N, 1>(defect.template cast<Complex>()));
    response.unrounded_amplitude += change.template cast<Cast>();
  }
  response.amplitude = response.unrounded_amplitude.template cast<Complex>();
}

}  // namespace

template <int N>
bool make_harmonic_response(const LinearMode<N>& mode, const Eigen::VectorXcd& force, double rate,
                            HarmonicResponse<N>& response) {
  const Eigen::Index n = force.size();
  response.rate = rate;
  response.amplitude.setZero(n);
  if constexpr (N != Eigen::Dynamic) response.unrounded_amplitude.setZero(n);
  if (!force.isZero(0)) {
    const auto dynamic = dynamic_stiffness<N>(mode.stiffness, mode.damping, rate);
    if constexpr (N == Eigen::Dynamic) {
      response.amplitude = numerics::dense::solve(dynamic, force);
    } else {
      const auto factors = dynamic.partialPivLu();
      response.amplitude = factors.solve(Eigen::Matrix<Complex, N, 1>(force));
      refine(mode.unrounded, factors, force, response);
    }
    if (!response.amplitude.allFinite() || response.amplitude.cwiseAbs().maxCoeff() > largest_amplitude)
      return false;
  }
  for (const auto& guard : mode.guards) {
    response.at_guard.push_back(row_on(guard.physical, response.amplitude, rate));
    response.curvature.push_back(std::abs(response.at_guard.back()) * rate * rate);
    response.taylor.push_back(taylor_of(response.at_guard.back(), rate / mode.fastest_rad_per_s));
  }
  for (const auto& guard : mode.annular_guards) {
    response.at_annular_guard.push_back({row_on(guard.physical[0], response.amplitude, rate),
                                         row_on(guard.physical[1], response.amplitude, rate)});
    response.annular_length.push_back(
        longest(response.at_annular_guard.back()[0], response.at_annular_guard.back()[1]));
  }
  for (const auto& touch : mode.touches) {
    response.at_force.push_back(row_on(touch.force, response.amplitude, rate));
    response.force_curvature.push_back(std::abs(response.at_force.back()) * rate * rate);
    response.at_sliding.push_back(row_on(touch.sliding, response.amplitude, rate));
    response.sliding_curvature.push_back(std::abs(response.at_sliding.back()) * rate * rate);
  }
  for (const auto& casing : mode.casings) {
    const Eigen::Vector2cd at = casing.map * response.amplitude;
    response.at_casing.push_back({at(0), at(1)});
  }
  return true;
}

template bool make_harmonic_response<2>(const LinearMode<2>&, const Eigen::VectorXcd&, double,
                                        HarmonicResponse<2>&);
template bool make_harmonic_response<4>(const LinearMode<4>&, const Eigen::VectorXcd&, double,
                                        HarmonicResponse<4>&);
template bool make_harmonic_response<6>(const LinearMode<6>&, const Eigen::VectorXcd&, double,
                                        HarmonicResponse<6>&);
template bool make_harmonic_response<Eigen::Dynamic>(const LinearMode<Eigen::Dynamic>&,
                                                     const Eigen::VectorXcd&, double,
                                                     HarmonicResponse<Eigen::Dynamic>&);

}  // namespace rubsweep::integrate::exact::modes
