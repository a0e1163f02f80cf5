#include "rubsweep/integrate/drive.hpp"

#include <Eigen/LU>
#include <cmath>
#include <utility>

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
  for (Eigen::Index j = 0; j < n; ++j) sum += (row(j) + Complex(0, rate) * row(n + j)) * amplitude(j);
  return sum;
}

}  // namespace

template <int N>
void Drive<N>::expand(std::size_t e, const Complex& phasor, double within_s, std::span<double> terms) const {
  const Complex start = product(at_exit[e], phasor);
  const double angle = rate * within_s, minus_square = -angle * angle;
  double last = start.real(), now = -angle * start.imag();
  terms[0] += last;
  terms[1] += now;
  for (std::size_t k = 1; k + 1 < terms.size(); ++k) {
    last = std::exchange(now, minus_square * (reciprocals[k] * reciprocals[k + 1]) * last);
    terms[k + 1] += now;
  }
}

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

template struct Drive<2>;
template bool make_drive<2>(const ModePlan<2>&, const Eigen::VectorXcd&, double, Drive<2>&);
template struct Drive<4>;
template bool make_drive<4>(const ModePlan<4>&, const Eigen::VectorXcd&, double, Drive<4>&);
template struct Drive<6>;
template bool make_drive<6>(const ModePlan<6>&, const Eigen::VectorXcd&, double, Drive<6>&);
template struct Drive<Eigen::Dynamic>;
template bool make_drive<Eigen::Dynamic>(const ModePlan<Eigen::Dynamic>&, const Eigen::VectorXcd&, double,
                                         Drive<Eigen::Dynamic>&);

}  // namespace rubsweep::integrate
