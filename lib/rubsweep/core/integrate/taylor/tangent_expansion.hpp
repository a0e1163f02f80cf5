#pragma once

#include <Eigen/Core>

#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/integrate/taylor/tangent_bundle.hpp"

namespace rubsweep::integrate::taylor {

/// Tangent vectors of a motion (small changes of its state), moved along its expansions. They are continuous
/// at a change of mode, because the force is.
template <int N>
class TangentExpansion {
 public:
  /// Highest order: one below that of the motion, which must be known to one order more.
  static constexpr int order = TangentBundle<N, 1>::order;

  explicit TangentExpansion(const run::ScaledSystem<N>& system) : together_(system), alone_(system) {}

  /// Begins with one vector per column, as TurnRequest::tangent_vectors.
  void begin(const Eigen::MatrixXd& tangents) { tangents_ = tangents; }
  Eigen::Index count() const { return tangents_.cols(); }

  /// Moves the vectors over `duration_rad` of the expanded motion. Each vector is expanded until its last two
  /// terms are at most `accuracy` times its largest terms, in displacements and in rates. False, with nothing
  /// moved, where contacts creep and the slips of a vector still contain a transient.
  bool pass(Expansion<N>& motion, double duration_rad, double accuracy);

  /// Number of sweeps for creep since the last call.
  long take_sweeps() { return alone_.take_sweeps(); }

  /// Present vectors, which may be read or changed between two pieces.
  Eigen::MatrixXd& vectors() { return tangents_; }
  const Eigen::MatrixXd& vectors() const { return tangents_; }

 private:
  bool pass_creeping(Expansion<N>& motion, double duration_rad, double accuracy);

  Eigen::MatrixXd tangents_, before_;
  TangentBundle<N, tangents_together> together_;
  TangentBundle<N, 1> alone_;
};

}  // namespace rubsweep::integrate::taylor
