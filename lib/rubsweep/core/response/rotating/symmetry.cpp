#include "rubsweep/core/response/rotating/symmetry.hpp"

#include <algorithm>
#include <complex>

namespace rubsweep::response::rotating {
namespace {

/// Exact: an anisotropy of any size ends the symmetry, and symmetric scenes are built from equal numbers.
bool isotropic(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() % 2 != 0 || matrix.cols() % 2 != 0) return false;
  for (Eigen::Index r = 0; r < matrix.rows(); r += 2) {
    for (Eigen::Index c = 0; c < matrix.cols(); c += 2) {
      if (matrix(r, c) != matrix(r + 1, c + 1) || matrix(r, c + 1) != -matrix(r + 1, c)) return false;
    }
  }
  return true;
}

/// Re(f e^{i phase}) turns forward in every pair when f_y = -i f_x. The phase factor of the smallest gap
/// rounds.
bool turns_forward(const Eigen::VectorXcd& force) {
  constexpr double rounding = 1e-14;
  const std::complex<double> i(0, 1);
  for (Eigen::Index k = 0; k + 1 < force.size(); k += 2) {
    if (std::abs(force(k + 1) + i * force(k)) > rounding * std::abs(force(k))) return false;
  }
  return true;
}

}  // namespace

bool rotationally_symmetric(const scene::Scene& scene) {
  const auto& s = scene.structure;
  // The equations of the rotating frame know linear contacts alone.
  return std::ranges::all_of(scene.contacts,
                             [](const auto& c) { return contact::centred(c.wall) && !c.law; }) &&
         scene.constant_n.isZero(0) && scene.impulses.empty() && turns_forward(scene.harmonic_n) &&
         scene.second_harmonic_n.size() == 0 && isotropic(s.mass) && isotropic(s.damping) &&
         isotropic(s.stiffness) &&
         std::ranges::all_of(s.points, [](const auto& p) { return isotropic(p.map); });
}

}  // namespace rubsweep::response::rotating
