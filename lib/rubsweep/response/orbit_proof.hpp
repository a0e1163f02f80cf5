#pragma once

#include <optional>

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

/// Looks for a stable orbit of up to twice max_order turns that a transient is on its way to.
class OrbitProof {
 public:
  /// `options` and `workspace` must outlive the proof.
  OrbitProof(const scene::Scene& scene, const integrate::SolverOptions& solver,
             const ResponseOptions& options, Workspace& workspace);

  /// After one more turn. Empty most of the time; an orbit that touches nothing is not reported.
  std::optional<ProvenMotion> look(const integrate::Turn& turn);

 private:
  std::optional<StableOrbit> find(const integrate::Turn& turn);
  std::optional<Measures> measure(const StableOrbit& orbit);

  scene::Scene scene_;
  integrate::SolverOptions solver_;
  const ResponseOptions& options_;
  Workspace& workspace_;
  PeriodSearch search_;
  std::optional<SceneMap> map_;
};

}  // namespace rubsweep::response
