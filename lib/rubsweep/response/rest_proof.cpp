#include "rubsweep/response/rest_proof.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "rubsweep/integrate/scaled_system.hpp"

namespace rubsweep::response {
namespace {

constexpr double largest_condition = 1e6;
constexpr double growth_tolerance = 1e-12;  ///< rounding of an undamped mode's real part, per radian

/// Scaled free structure as a first-order system in (u, u').
Eigen::MatrixXd free_system(const scene::Scene& scene) {
  const auto system = integrate::scale<Eigen::Dynamic>(scene);
  const Eigen::Index n = system.coordinates();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -system.stiffness;
  a.bottomRightCorner(n, n) = -system.damping;
  return a;
}

}  // namespace

RestProof::RestProof(const scene::Cell& cell) {
  const scene::Scene& scene = cell.scene;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(free_system(scene));
  if (solver.info() != Eigen::Success) return;
  if (solver.eigenvalues().real().maxCoeff() > growth_tolerance) return;
  const Eigen::MatrixXcd vectors = solver.eigenvectors();
  to_modes_ = vectors.partialPivLu().inverse();
  if (!to_modes_.allFinite() || vectors.norm() * to_modes_.norm() > largest_condition) return;
  usable_ = true;

  const double length = scene.length_scale_m;
  const Eigen::Index n = scene.structure.coordinates();
  quiet_.resize(2 * n);
  quiet_ << cell.quiet.displacement(0) / length, cell.quiet.velocity(0) / length;
  for (const scene::Contact& contact : scene.contacts) {
    const auto [mean, amplitude] = scene::quiet_penetration(cell.quiet, scene.structure, contact);
    const Eigen::MatrixXd map = scene::relative_map(scene.structure, contact);
    const Eigen::MatrixXd seen = contact.ring ? map : Eigen::MatrixXd(contact.normal.transpose() * map);
    bounds_.push_back(
        {(mean + amplitude) / length,
         (seen.cast<std::complex<double>>() * vectors.topRows(n)).colwise().norm().transpose()});
  }
}

bool RestProof::proves(std::span<const double> section) const {
  if (!usable_) return false;
  const Eigen::Map<const Eigen::VectorXd> state(section.data(), static_cast<Eigen::Index>(section.size()));
  const Eigen::VectorXd amplitudes = (to_modes_ * (state - quiet_)).cwiseAbs();
  return std::all_of(bounds_.begin(), bounds_.end(), [&](const Bound& bound) {
    return bound.quiet_penetration + bound.mode_weight.dot(amplitudes) < 0;
  });
}

}  // namespace rubsweep::response
