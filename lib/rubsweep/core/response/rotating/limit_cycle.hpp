#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/response/rotating/rotating_flow.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// An autonomous system: its rate, and its flow from `state` over `angle_rad` in three accuracies: about 1e-4
/// for Newton's first step (`at_first`), about 1e-6 for the next steps (`roughly`), and the accuracy required
/// of the cycle (`exactly`).
struct RotatingMotion {
  using Flow = std::function<std::optional<RotatingArc>(const Eigen::VectorXd& state, double angle_rad)>;
  std::function<Eigen::VectorXd(const Eigen::VectorXd& state)> rate;
  Flow at_first, roughly, exactly;
  /// End of the rough flow, without its derivative.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& state, double angle_rad)> end;
};

/// A stable closed orbit in the frame that turns with the shaft.
struct LimitCycle {
  Eigen::VectorXd state;       ///< a point of the orbit
  RotatingArc once;            ///< arc of exactly one period from `state`
  double floquet_modulus = 0;  ///< largest multiplier over one period, without the trivial one; < 1
};

/// Finds the closed orbit on which a transient now at `start` settles, with a period near one of
/// `periods_rad` (ascending, because a transient that alternates about an orbit returns sooner after twice
/// its period). Newton's iteration on state and period closes the orbit; the state stays on the plane through
/// `start` that is normal to the motion there. One multiplier of the monodromy matrix must be 1 (a shift
/// along the orbit) within its accuracy, and all others inside `largest_floquet_modulus`. The transient must
/// then approach the orbit: to a thousandth of its distance in the adapted norm of the return map, to 1e-5,
/// or to half of the distance by `proof::LinearConvergenceTest` with three returns in a row. The result is
/// observed, not proven: no ball about the orbit is known. Empty when no orbit closes and is stable, or when
/// the transient does not approach the first orbit found.
std::optional<LimitCycle> prove_limit_cycle(const RotatingMotion& motion, const Eigen::VectorXd& start,
                                            const std::vector<double>& periods_rad);

/// Flows of a scene for RotatingMotion.
struct CycleFlows {
  RotatingFlow exactly, roughly, at_first;

  /// `samples_per_revolution`: number of samples of the exact flow; the others have none.
  CycleFlows(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
             int samples_per_revolution);

  /// The motion with the rates of `field`. The result refers to `field` and to these flows.
  RotatingMotion motion(const RotatingField& field) const;
};

}  // namespace rubsweep::response::rotating
