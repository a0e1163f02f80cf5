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

/// An autonomous system: its rate, and its flow from `state` over `angle_rad`: to about 1e-4 for the first of
/// Newton's steps (`at_first`), to about 1e-6 for the next ones (`roughly`), and with the accuracy that the
/// cycle is wanted with (`exactly`).
struct RotatingMotion {
  using Flow = std::function<std::optional<RotatingArc>(const Eigen::VectorXd& state, double angle_rad)>;
  std::function<Eigen::VectorXd(const Eigen::VectorXd& state)> rate;
  Flow at_first, roughly, exactly;
  /// Where the rough flow ends, without its derivative.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& state, double angle_rad)> end;
};

/// A stable closed orbit in the frame that turns with the shaft.
struct LimitCycle {
  Eigen::VectorXd state;       ///< a point of it
  RotatingArc once;            ///< arc of exactly one period from there
  double floquet_modulus = 0;  ///< largest multiplier over one period but the trivial one, < 1
};

/// Finds the closed orbit that a transient now at `start` settles on, of about one of `periods_rad`
/// (ascending: where the transient alternates about an orbit, its double returns sooner). Newton's iteration
/// on state and period, the state staying on the plane through `start` across the motion there, closes the
/// orbit; one multiplier of its monodromy matrix is 1, as every shift along the orbit makes it, to how well
/// it is known, and all others lie inside `largest_floquet_modulus`; and the transient, followed on, comes
/// down to a thousandth of its distance from the orbit in the adapted norm of the return map, or to 1e-5, or
/// to half of it by `proof::LinearConvergenceTest`, by three returns in a row.
/// Observed, not proven: nothing is known of a ball about the orbit. Empty when none closes and is stable, or
/// when the transient does not come near the first that is.
std::optional<LimitCycle> prove_limit_cycle(const RotatingMotion& motion, const Eigen::VectorXd& start,
                                            const std::vector<double>& periods_rad);

/// A scene's flows as RotatingMotion names them.
struct CycleFlows {
  RotatingFlow exactly, roughly, at_first;

  /// `samples_per_revolution`: of the exact one; the others take none.
  CycleFlows(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
             int samples_per_revolution);

  /// The motion with the rates of `field`; both are referred to.
  RotatingMotion motion(const RotatingField& field) const;
};

}  // namespace rubsweep::response::rotating
