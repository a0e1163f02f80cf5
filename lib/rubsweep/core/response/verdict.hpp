#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/response/aperiodic.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/survival.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response {

/// Runs the scene for `turns` turns, at least two windows, and records the last two. Empty where a turn
/// fails, or where the run exceeds the limit of work.
std::optional<motion::Record> recorded_run(const scene::Scene& scene,
                                           const integrate::run::SolverOptions& solver,
                                           const motion::ResponseOptions& options, long turns,
                                           motion::Workspace& workspace);

/// Sections that a run has passed, an eighth of a window apart. If the run is stopped, its last two windows
/// are computed again from one of them.
class Checkpoints {
 public:
  struct Checkpoint {
    long revolutions = 0;  ///< number of revolutions before this section
    std::vector<double> section;
  };

  /// `start`: section at the start of the run, as TurnReport::section.
  Checkpoints(int window_revolutions, std::span<const double> start);

  /// Notes that the run is at `section` after `revolutions` turns.
  void pass(long revolutions, std::span<const double> section);

  /// Latest checkpoint not after `revolutions`, a position of the run at most two windows back.
  const Checkpoint& before(long revolutions) const;

 private:
  static constexpr int parts = 8;  ///< parts of a window
  int spacing_;
  std::array<Checkpoint, 2 * parts + 2> last_;  ///< checkpoints, the newest first; at first all at the start
};

/// Properties of a scene that decide how it is examined, computed once per run.
struct SceneFacts {
  bool rotationally_symmetric = false;
  bool same_every_turn = false;  ///< result of integrate::run::same_every_turn

  explicit SceneFacts(const scene::Scene& scene);
};

/// Verdict at the end of a whole run.
struct Verdict {
  motion::Motion motion;
  std::optional<Survival> survival;  ///< survival of chaos
};

/// Whether the motion at the end of the run may be aperiodic: the window shows neither a period nor rest.
bool may_be_aperiodic(const motion::WindowVerdict& verdict);

/// Verdict at the end of the run; `section` is that of its last turn, `watch` the result of the search for a
/// torus. Class and measures belong to one motion. The motion that was followed for its class may differ from
/// that in `record`; it is then measured again in its own last windows.
Verdict verdict_of(const scene::Scene& scene, const SceneFacts& facts,
                   const integrate::run::SolverOptions& solver, const motion::ResponseOptions& options,
                   const motion::Record& record, std::span<const double> section, const TorusWatch& watch,
                   motion::Workspace& workspace);

}  // namespace rubsweep::response
