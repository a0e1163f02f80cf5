#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/proof/periodic_orbit.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/response/rotating/apex_return_search.hpp"
#include "rubsweep/core/response/rotating/limit_cycle.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"

namespace rubsweep::response::rotating {

/// Rate d(state)/d(phase) of an autonomous system, 2n numbers, and its 2n x 2n derivative.
struct RotatingEquations {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> rate;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian;
};

/// A synchronous circle: a stable fixed point in the frame that turns with the shaft.
struct RotatingEquilibrium {
  Eigen::VectorXd state;
  Eigen::MatrixXd transition;  ///< transition matrix over one turn
  double floquet_modulus = 0;  ///< modulus over one turn, e^{2 pi Re lambda}, lambda the rightmost eigenvalue
};

/// Newton's iteration from `start` (in the rotating frame) for a fixed point whose multipliers over one turn
/// lie inside `largest_floquet_modulus`. Empty where there is none within `farthest_orbit`.
std::optional<RotatingEquilibrium> find_rotating_equilibrium(const RotatingEquations& equations,
                                                             const Eigen::VectorXd& start);

/// Search, in the rotating frame, for the stable motion to which a transient of a rotationally symmetric
/// scene converges. There a synchronous circle is a fixed point, and a quasi-periodic oval a closed orbit. (A
/// once-per-turn section can prove only a fixed point: an orbit that moves in that frame has a multiplier of
/// 1 for each shift along it.)
class RotatingProof {
 public:
  /// Following a transient takes no more work than `budget`. `budget`, `options` and `workspace` must outlive
  /// the proof.
  RotatingProof(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                const motion::ResponseOptions& options, motion::Workspace& workspace,
                integrate::run::WorkBudget& budget);

  /// Number of samples wanted in the next turn; 0 while the rotor has been without contact for long.
  int samples_wanted() const;

  /// Adds one turn. Returns a motion once it is proven; a motion without contact is not reported.
  std::optional<motion::ProvenMotion> look(const integrate::run::TurnReport& turn);

 private:
  std::optional<motion::ProvenMotion> look_for_circle(const Eigen::VectorXd& section,
                                                      const integrate::run::TurnReport& turn);
  std::optional<motion::ProvenMotion> look_for_cycle(const Eigen::VectorXd& section,
                                                     const integrate::run::TurnReport& turn);
  std::optional<motion::ProvenMotion> look_for_fast_whirl(const Eigen::VectorXd& section,
                                                          const integrate::run::TurnReport& turn);
  std::optional<motion::ProvenMotion> proven_cycle(CycleFlows& flows, int samples_per_revolution,
                                                   const Eigen::VectorXd& section,
                                                   const std::vector<double>& periods_rad);
  bool comes_near_to(const RotatingEquilibrium& circle, std::span<const double> section);
  motion::ProvenMotion measured(const RotatingEquilibrium& circle);
  bool returns_with_the_shaft(const LimitCycle& cycle) const;

  scene::Scene scene_;
  integrate::run::SolverOptions solver_;
  const motion::ResponseOptions& options_;
  motion::Workspace& workspace_;
  integrate::run::WorkBudget& budget_;
  RotatingField field_;
  CycleFlows flows_;
  proof::PeriodSearch turns_;
  std::optional<ApexReturnSearch> maxima_;  ///< empty after a turn without samples
  std::optional<proof::SceneMap> turn_map_;
  bool many_maxima_ = true;       ///< true: many maxima in the last turn with the largest number of samples
  bool may_try_cycles_ = true;    ///< true: Newton's iteration has followed less than it may
  Eigen::VectorXd last_section_;  ///< at the end of the turn before; empty at the start
  int free_turns_ = 0;
  long looked_at_ = 0;              ///< number of turns examined so far
  double spent_on_cycles_rad_ = 0;  ///< rotation followed by Newton's iteration
};

}  // namespace rubsweep::response::rotating
