#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::response {

/// Proves that a rotor in flight will never touch again. Free vibration about the quiet motion is a sum of
/// modes c_j e^{lambda_j t} that cannot grow, so with row r of a contact (p = r q - clearance)
///   p(t) <= static part + harmonic amplitude + sum_j |r v_j| |c_j|   for all later t;
/// below zero for every contact, no contact can ever come. In a ring |r v_j| is the length of the vector that
/// the mode moves the rotor by.
class RestProof {
 public:
  /// Factorises the free structure once. Without effect (`proves` is always false) when a mode grows or the
  /// eigenvectors are too close to dependent for the coefficients to mean anything (condition above 1e6).
  explicit RestProof(const scene::Cell& cell);

  /// `section`: scaled state at the start of a revolution with every contact open and the kick over, as
  /// Turn::section.
  bool proves(std::span<const double> section) const;

 private:
  struct Bound {
    double quiet_penetration = 0;  ///< static part + harmonic amplitude, in units of the length scale
    Eigen::VectorXd mode_weight;   ///< |r v_j|
  };

  bool usable_ = false;
  Eigen::MatrixXcd to_modes_;  ///< inverse of the eigenvector matrix
  Eigen::VectorXd quiet_;      ///< scaled state of the quiet motion at phase 0
  std::vector<Bound> bounds_;
};

}  // namespace rubsweep::response
