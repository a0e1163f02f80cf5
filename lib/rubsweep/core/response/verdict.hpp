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

/// The last two windows of a run of `turns` turns, two windows or more, which is made for them. Empty where a
/// turn fails, or where the run takes more work than any may.
std::optional<motion::Record> recorded_run(const scene::Scene& scene,
                                           const integrate::run::SolverOptions& solver,
                                           const motion::ResponseOptions& options, long turns,
                                           motion::Workspace& workspace);

/// Sections that a run has passed, a window apart: where it is stopped, its last two windows are made again
/// from one of them.
class Checkpoints {
 public:
  struct Checkpoint {
    long revolutions = 0;  ///< before it
    std::vector<double> section;
  };

  /// `start`: that of the run, as TurnReport::section.
  Checkpoints(int window_revolutions, std::span<const double> start);

  /// The run stands at `section` after `revolutions` turns.
  void pass(long revolutions, std::span<const double> section);

  /// The last one that lies two windows or more before `revolutions`, where the run stands; null where there
  /// is none.
  const Checkpoint* before_windows(long revolutions) const;

 private:
  int window_;
  std::array<Checkpoint, 3> last_;  ///< the newest first
  std::size_t count_ = 1;
};

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
