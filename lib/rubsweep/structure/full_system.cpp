#include "rubsweep/structure/full_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "rubsweep/numerics/dense/eigenvalues.hpp"
#include "rubsweep/numerics/dense/lu.hpp"
#include "rubsweep/numerics/split_mix.hpp"
#include "rubsweep/structure/reduction.hpp"

namespace rubsweep::structure {
namespace {

using Eigen::Index;

/// Operator 2 ratio w (m shape) (m shape)^T over all modes of a plane: a force by the velocity along it.
Eigen::MatrixXd by_modes(const BeamShaft& shaft, std::size_t plane, const std::vector<double>& ratios) {
  const Index n = shaft.coordinates();
  if (std::ranges::all_of(ratios, [](double ratio) { return ratio == 0; }))
    return Eigen::MatrixXd::Zero(n, n);
  const PlaneModes modes = plane_modes(shaft.plane_mass(plane), shaft.plane_stiffness(plane), n);
  Eigen::VectorXd rates = 2 * modes.rad_per_s;
  for (Index j = 0; j < rates.size(); ++j)
    rates(j) *= ratios[std::min(static_cast<std::size_t>(j), ratios.size() - 1)];
  const Eigen::MatrixXd momentum = shaft.plane_mass(plane) * modes.shape;
  return momentum * rates.asDiagonal() * momentum.transpose();
}

/// The block of a matrix in the coordinates of planes a (rows) and b.
auto block(Eigen::MatrixXd& matrix, Index a, Index b) {
  const Index n = matrix.rows() / 2;
  return matrix(Eigen::seqN(a, n, 2), Eigen::seqN(b, n, 2));
}

/// The inverse of the generator of (displacement, rate), in units in which all are alike.
class InverseGenerator {
 public:
  InverseGenerator(const SpeedMatrices& matrices, double rad_per_s)
      : scale_(matrices.stiffness.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse()),
        stiffness_(scale_.asDiagonal() * matrices.stiffness * scale_.asDiagonal()),
        damping_(rad_per_s * (scale_.asDiagonal() * matrices.damping * scale_.asDiagonal())),
        mass_(rad_per_s * rad_per_s * (scale_.asDiagonal() * matrices.mass * scale_.asDiagonal())) {}

  Index states() const { return 2 * scale_.size(); }

  Eigen::VectorXd operator()(const Eigen::VectorXd& state) const {
    const Index n = scale_.size();
    Eigen::VectorXd next(2 * n);
    next.head(n) = -stiffness_.solve(Eigen::VectorXd(damping_ * state.head(n) + mass_ * state.tail(n)));
    next.tail(n) = state.head(n);
    return next;
  }

 private:
  Eigen::VectorXd scale_;
  numerics::dense::LuFactors stiffness_;
  Eigen::MatrixXd damping_, mass_;
};

/// Orthonormal states and how the inverse generator maps them: inverse * states = states * map, but for the
/// last one.
class Arnoldi {
 public:
  explicit Arnoldi(const InverseGenerator& inverse)
      : inverse_(inverse), states_(inverse.states(), 1), map_(1, 0) {
    // A start with a share of every mode.
    for (Index i = 0; i < states_.rows(); ++i)
      states_(i, 0) =
          std::ldexp(static_cast<double>(numerics::split_mix(static_cast<std::uint64_t>(i))), -64) - 0.5;
    states_.col(0).normalize();
  }

  /// Goes on to so many states; fewer where the inverse maps them among themselves.
  void grow(Index states) {
    while (map_.cols() < states && !closed_) {
      const Index k = map_.cols();
      Eigen::VectorXd next = inverse_(states_.col(k));
      const double whole = next.norm();
      map_.conservativeResizeLike(Eigen::MatrixXd::Zero(k + 2, k + 1));
      for (int pass = 0; pass < 2; ++pass) {  // twice is enough: rounding of the first is taken out
        const Eigen::VectorXd share = states_.transpose() * next;
        next -= states_ * share;
        map_.col(k).head(k + 1) += share;
      }
      const double rest = next.norm();
      map_(k + 1, k) = rest;
      closed_ = !(rest > 1e-14 * whole) || k + 1 == states_.rows();
      states_.conservativeResize(Eigen::NoChange, k + 2);
      states_.col(k + 1) = closed_ ? next : next / rest;
    }
  }

  /// Rates, and whether all with |s| <= 1 are theirs to rounding.
  std::pair<Eigen::VectorXcd, bool> rates() const {
    constexpr double accuracy = 1e-10;
    const Index k = map_.cols();
    const auto modes = numerics::dense::eigenvectors(map_.topRows(k));
    if (!modes.values.allFinite()) return {modes.values, true};
    Eigen::VectorXcd found(k);
    Index kept = 0;
    bool sure = true;
    for (Index j = 0; j < k; ++j) {
      if (std::abs(modes.values(j)) < 1) continue;
      found(kept++) = 1.0 / modes.values(j);
      const double off = map_(k, k - 1) * std::abs(modes.vectors(k - 1, j));
      sure = sure && (closed_ || off <= accuracy * std::abs(modes.values(j)));
    }
    return {found.head(kept), sure};
  }

  bool complete() const { return closed_; }

 private:
  const InverseGenerator& inverse_;
  Eigen::MatrixXd states_, map_;
  bool closed_ = false;
};

}  // namespace

FullSystem full_system(const BeamShaft& shaft, const model::RotorKit& kit) {
  const Index n = shaft.coordinates();
  FullSystem full;
  LateralSystem& system = full.system;
  system.shapes = {n, n};
  system.mass = system.damping = system.gyroscopic = system.stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (Index a = 0; a < 2; ++a) {
    const auto plane = static_cast<std::size_t>(a), other = 1 - plane;
    block(system.mass, a, a) = shaft.plane_mass(plane);
    block(system.stiffness, a, a) = shaft.plane_stiffness(plane);
    block(system.damping, a, a) =
        shaft.damping + shaft.support_damping[plane][plane] + by_modes(shaft, plane, kit.damping_ratio);
    block(system.stiffness, a, 1 - a) = shaft.support_stiffness[plane][other];
    block(system.damping, a, 1 - a) = shaft.support_damping[plane][other];
  }
  block(system.gyroscopic, 0, 1) = shaft.gyroscopic;
  block(system.gyroscopic, 1, 0) = -shaft.gyroscopic.transpose();
  if (model::has_rotating_damping(kit)) {
    const Eigen::MatrixXd line = by_modes(shaft, 0, kit.rotating_damping_ratio);
    full.circulatory = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    for (Index a = 0; a < 2; ++a) block(system.damping, a, a) += line;
    block(full.circulatory, 0, 1) = line;
    block(full.circulatory, 1, 0) = -line;
  }
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
  full.tables = tabled_supports(shaft, kit, {one, one}, system, 2 * n);
  return full;
}

SpeedMatrices matrices_at(const FullSystem& full, double speed_rad_per_s,
                          std::optional<double> supports_rad_per_s) {
  SpeedMatrices at{full.system.mass, full.system.damping + speed_rad_per_s * full.system.gyroscopic,
                   full.system.stiffness};
  if (full.circulatory.size() > 0) at.stiffness += speed_rad_per_s * full.circulatory;
  if (supports_rad_per_s) {
    for (const TabledSupport& support : full.tables)
      add_lacking(support, *supports_rad_per_s, at.mass, at.damping, at.stiffness);
  }
  return at;
}

Eigen::VectorXcd slow_rates_per_s(const SpeedMatrices& matrices, double radius_rad_per_s) {
  constexpr Index first_states = 60;
  const InverseGenerator inverse(matrices, radius_rad_per_s);
  Arnoldi arnoldi(inverse);
  for (Index states = first_states;; states += states / 2) {
    arnoldi.grow(states);
    const auto [rates, sure] = arnoldi.rates();
    if (sure || arnoldi.complete()) return radius_rad_per_s * rates;
  }
}

}  // namespace rubsweep::structure
