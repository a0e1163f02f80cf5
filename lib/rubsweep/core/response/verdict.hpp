#pragma once

#include <optional>
#include <span>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/survival.hpp"
#include "rubsweep/core/response/torus_watch.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response {

/// Properties of a scene that decide how it is looked at, computed once a run.
struct SceneFacts {
  bool rotationally_symmetric = false;
  bool same_every_turn = false;  ///< as integrate::run has it

  explicit SceneFacts(const scene::Scene& scene);
};

/// Verdict at the end of a whole run.
struct Verdict {
  motion::Motion motion;
  std::optional<Survival> survival;  ///< of chaos
};

/// Whether the motion at the end of the run may have no period: the window shows neither a period nor rest.
bool may_be_aperiodic(const motion::WindowVerdict& verdict);

/// Verdict at the end of the run; `section` is that of its last turn, `watch` what was seen on the way there.
/// Class and measures are those of one motion: where a motion that is followed for its class is another one
/// than that of the windows in `record`, it is measured again in its own last windows.
Verdict verdict_of(const scene::Scene& scene, const SceneFacts& facts,
                   const integrate::run::SolverOptions& solver, const motion::ResponseOptions& options,
                   const motion::Record& record, std::span<const double> section, const TorusWatch& watch,
                   motion::Workspace& workspace);

}  // namespace rubsweep::response
