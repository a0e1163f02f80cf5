#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "rubsweep/core/structure/matrix_shaft.hpp"

namespace rubsweep::linear {

/// Matrices written by --export-matrices for a rotor at one speed, and their determinant by elimination. They
/// give the roots and their number without an eigensolver.
class ExportedMatrices {
 public:
  ExportedMatrices(const model::Machine& machine, double speed_rad_per_s) {
    const model::Machine by_matrices = structure::machine_by_matrices(machine);
    const auto& matrices = *model::kit_of(by_matrices)->matrices;
    mass_ = matrices.mass;
    damping_ = matrices.damping + speed_rad_per_s * matrices.gyroscopic;
    stiffness_ = matrices.stiffness;
    unit_ = stiffness_.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  }

  /// Root found by the secant method from near `start`.
  std::complex<double> root_near(std::complex<double> start) const {
    std::complex<double> before = start * (1 + 1e-5), now = start * std::complex<double>(1, 1e-5);
    for (int step = 0; step < 40 && std::abs(now - before) > 1e-15 * std::abs(now); ++step) {
      // Only the ratio of the determinants is used, because each of them may overflow.
      const auto [log_a, turn_a] = determinant(before);
      const auto [log_b, turn_b] = determinant(now);
      const std::complex<double> ratio = std::polar(std::exp(log_a - log_b), turn_a - turn_b);
      if (ratio == 1.0) break;
      const std::complex<double> next = now - (now - before) / (1.0 - ratio);
      before = std::exchange(now, next);
    }
    return now;
  }

  /// Number of roots with an imaginary part from fastest / 1000 to `fastest`: winding number of the
  /// determinant around this region.
  int roots_below(double fastest) const {
    constexpr double far = 1e8, hardly = 1e-3;
    double turned = 0;
    const std::vector<std::complex<double>> corners{{-far, hardly * fastest},
                                                    {far, hardly * fastest},
                                                    {far, fastest},
                                                    {-far, fastest},
                                                    {-far, hardly * fastest}};
    for (std::size_t k = 1; k < corners.size(); ++k) turned += turn_between(corners[k - 1], corners[k]);
    return static_cast<int>(std::lround(turned / (2 * std::numbers::pi)));
  }

 private:
  /// Logarithm of the determinant's modulus, and its argument.
  std::pair<double, double> determinant(std::complex<double> rate) const {
    using Complex = std::complex<double>;
    Eigen::MatrixXcd a = (unit_.asDiagonal() * stiffness_ * unit_.asDiagonal()).cast<Complex>() +
                         rate * (unit_.asDiagonal() * damping_ * unit_.asDiagonal()).cast<Complex>() +
                         rate * rate * (unit_.asDiagonal() * mass_ * unit_.asDiagonal()).cast<Complex>();
    double log = 0, turn = 0;
    for (Eigen::Index k = 0; k < a.rows(); ++k) {
      Eigen::Index pivot = k;
      for (Eigen::Index i = k; i < a.rows(); ++i)
        if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
      if (pivot != k) {
        a.row(k).swap(a.row(pivot));
        turn += std::numbers::pi;
      }
      log += std::log(std::abs(a(k, k)));
      turn += std::arg(a(k, k));
      for (Eigen::Index i = k + 1; i < a.rows(); ++i) {
        const Complex share = a(i, k) / a(k, k);
        if (share != 0.0) a.row(i).tail(a.cols() - k) -= share * a.row(k).tail(a.cols() - k);
      }
    }
    return {log, turn};
  }

  /// Change of the determinant's argument along a straight line. Its logarithmic derivative makes the steps
  /// short near a root.
  double turn_between(std::complex<double> from, std::complex<double> to) const {
    constexpr double little = 0.4, hardly = 1e-9;
    const auto at = [&](double s) {
      // Real parts cover many decades, so steps are uniform in their asinh.
      if (from.imag() != to.imag()) return from + s * (to - from);
      const double span = std::asinh(std::abs(to.real()));
      return std::complex<double>(std::sinh((to.real() > 0 ? 1 : -1) * span * (2 * s - 1)), to.imag());
    };
    double turned = 0, share = 0;
    auto last = determinant(at(0));
    while (share < 1) {
      const auto beside = determinant(at(share + hardly));
      const double turn_rate = std::remainder(beside.second - last.second, 2 * std::numbers::pi);
      const double rate = std::hypot(beside.first - last.first, turn_rate) / hardly;
      share = std::min(1.0, share + std::min(0.01, little / rate));
      const auto now = determinant(at(share));
      turned += std::remainder(now.second - last.second, 2 * std::numbers::pi);
      last = now;
    }
    return turned;
  }

  Eigen::MatrixXd mass_, damping_, stiffness_;
  Eigen::VectorXd unit_;
};

}  // namespace rubsweep::linear
