#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/integrate/options.hpp"
#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/response/floquet.hpp"
#include "rubsweep/response/options.hpp"
#include "rubsweep/response/period_search.hpp"
#include "rubsweep/response/proven_motion.hpp"
#include "rubsweep/response/section_map.hpp"
#include "rubsweep/response/workspace.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response {

/// Looks for a stable orbit of up to twice max_order turns that a transient is on its way to: proven
/// (`floquet`) once the transient, followed on, is inside a ball about the orbit from which every motion
/// converges to it; where no such ball can be had, observed (`floquet_observed`) once it has come down to a
/// ten-thousandth of its distance in the adapted norm, or to 1e-6 clearances.
class OrbitProof {
 public:
  /// `options` and `workspace` must outlive the proof.
  OrbitProof(const scene::Scene& scene, const integrate::SolverOptions& solver,
             const ResponseOptions& options, Workspace& workspace);

  /// After one more turn. Empty most of the time; an orbit that touches nothing is not reported.
  std::optional<ProvenMotion> look(const integrate::Turn& turn);

 private:
  std::optional<ProvenMotion> prove(std::span<const double> section, int order);
  TurnMap as_it_runs();
  std::optional<Measures> measure(const std::vector<double>& section, int order);

  scene::Scene scene_;
  integrate::SolverOptions run_solver_, solver_;
  const ResponseOptions& options_;
  Workspace& workspace_;
  PeriodSearch search_;
  std::optional<SceneMap> map_, run_map_;
};

}  // namespace rubsweep::response
