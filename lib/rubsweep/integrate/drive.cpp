#include "rubsweep/integrate/drive.hpp"

#include <Eigen/LU>
#include <cmath>

#include "rubsweep/integrate/exponential_series.hpp"

namespace rubsweep::integrate {
namespace {

/// A forced amplitude beyond this many clearances comes from a resonance that nothing damps: the cancellation
/// against the free part would cost digits.
constexpr double largest_amplitude = 1e4;

using Complex = std::complex<double>;

/// Length of (Re(a e^{it}), Re(b e^{it})) at its largest.
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

/// Re(amplitude e^{i rate t} phasor) by the parts of the phasor.
SeriesTable<2> taylor_of(Complex amplitude, double rate) {
  SeriesTable<2> terms = SeriesTable<2>::Zero();
  for (std::size_t k = 0; k < most_series_terms; ++k) {
    terms.row(static_cast<Eigen::Index>(k)) << amplitude.real(), -amplitude.imag();
    const double by_i = rate * reciprocals[k + 1];
    amplitude = {-by_i * amplitude.imag(), by_i * amplitude.real()};
  }
  return terms;
}

}  // namespace

template <int N>
bool make_drive(const ModePlan<N>& mode, const Eigen::VectorXcd& force, double rate, Drive<N>& drive) {
  using ComplexVector = Eigen::Matrix<Complex, N, 1>;
  const Eigen::Index n = force.size();
  drive.rate = rate;
  drive.amplitude = ComplexVector::Zero(n);
  if (!force.isZero(0)) {
    Eigen::Matrix<Complex, N, N> dynamic = mode.stiffness.template cast<Complex>();
    dynamic.diagonal().array() -= rate * rate;
    dynamic += Complex(0, rate) * mode.damping.template cast<Complex>();
    drive.amplitude = dynamic.partialPivLu().solve(ComplexVector(force));
    if (!drive.amplitude.allFinite() || drive.amplitude.cwiseAbs().maxCoeff() > largest_amplitude)
      return false;
  }
  for (const auto& exit : mode.exits) {
    drive.at_exit.push_back(row_on(exit.physical, drive.amplitude, rate));
    drive.curvature.push_back(std::abs(drive.at_exit.back()) * rate * rate);
    drive.taylor.push_back(taylor_of(drive.at_exit.back(), rate / mode.fastest_rad_per_s));
  }
  for (const auto& ring : mode.rings) {
    drive.at_ring.push_back(
        {row_on(ring.physical[0], drive.amplitude, rate), row_on(ring.physical[1], drive.amplitude, rate)});
    drive.ring_length.push_back(longest(drive.at_ring.back()[0], drive.at_ring.back()[1]));
  }
  for (const auto& touch : mode.touches) {
    drive.at_force.push_back(row_on(touch.force, drive.amplitude, rate));
    drive.force_curvature.push_back(std::abs(drive.at_force.back()) * rate * rate);
    drive.sliding.push_back(std::abs(row_on(touch.sliding, drive.amplitude, rate)) * rate);
  }
  return true;
}

template bool make_drive<2>(const ModePlan<2>&, const Eigen::VectorXcd&, double, Drive<2>&);
template bool make_drive<4>(const ModePlan<4>&, const Eigen::VectorXcd&, double, Drive<4>&);
template bool make_drive<6>(const ModePlan<6>&, const Eigen::VectorXcd&, double, Drive<6>&);
template bool make_drive<Eigen::Dynamic>(const ModePlan<Eigen::Dynamic>&, const Eigen::VectorXcd&, double,
                                         Drive<Eigen::Dynamic>&);

}  // namespace rubsweep::integrate
