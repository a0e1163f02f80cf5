#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/integrate/turning_flow.hpp"
#include "rubsweep/integrate/turning_frame.hpp"
#include "rubsweep/response/maxima_search.hpp"
#include "rubsweep/response/options.hpp"
#include "rubsweep/response/period_search.hpp"
#include "rubsweep/response/proven_motion.hpp"
#include "rubsweep/response/section_map.hpp"
#include "rubsweep/response/turning_circle.hpp"
#include "rubsweep/response/turning_cycle.hpp"
#include "rubsweep/response/workspace.hpp"

namespace rubsweep::response {

/// Looks for the stable motion that a transient of a rotationally symmetric scene is on its way to, in the
/// frame that turns with the shaft: a synchronous circle is a fixed point there, the quasi-periodic oval a
/// closed orbit. (A section once per turn can prove no other: every shift along an orbit that moves in that
/// frame is a multiplier of 1.)
class TurningProof {
 public:
  /// `options` and `workspace` must outlive the proof.
  TurningProof(const scene::Scene& scene, const integrate::SolverOptions& solver,
               const ResponseOptions& options, Workspace& workspace);

  /// Samples that the next turn should have; 0 while the rotor has been free for long.
  int samples_wanted() const;

  /// After one more turn. Empty most of the time; a motion that touches nothing is not reported.
  std::optional<ProvenMotion> look(const integrate::Turn& turn);

 private:
  std::optional<ProvenMotion> look_for_circle(const Eigen::VectorXd& section, const integrate::Turn& turn);
  std::optional<ProvenMotion> look_for_cycle(const Eigen::VectorXd& section, const integrate::Turn& turn);
  bool comes_near_to(const TurningCircle& circle, std::span<const double> section);
  ProvenMotion measured(const TurningCircle& circle);
  bool returns_with_the_shaft(const TurningCycle& cycle) const;

  scene::Scene scene_;
  integrate::SolverOptions solver_;
  const ResponseOptions& options_;
  Workspace& workspace_;
  integrate::TurningField field_;
  integrate::TurningFlow rough_flow_, flow_;
  PeriodSearch turns_;
  std::optional<MaximaSearch> maxima_;  ///< empty after a turn without samples
  std::optional<SceneMap> turn_map_;
  int free_turns_ = 0;
  long looked_at_ = 0;              ///< turns
  double spent_on_cycles_rad_ = 0;  ///< rotation that Newton's iteration followed
};

}  // namespace rubsweep::response
