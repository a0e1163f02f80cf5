#include "rubsweep/core/response/recorded_run.hpp"

#include <algorithm>

#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/response/motion/record_settled.hpp"

namespace rubsweep::response {

std::optional<motion::Record> recorded_run(const scene::Scene& scene,
                                           const integrate::run::SolverOptions& solver,
                                           const motion::ResponseOptions& options, long turns,
                                           motion::Workspace& workspace) {
  const long recorded = 2L * options.window_revolutions;
  motion::Wanted wanted{
      .turns = recorded, .samples_per_revolution = options.samples_per_revolution, .peaks = true};
  wanted.settling.most_turns = turns - recorded;
  wanted.settling.most_work = integrate::run::most_work_of_a_run(solver, scene.structure.coordinates());
  motion::Record record(scene, options);
  wanted.take = [&](const motion::RecordedTurn& turn) {
    if (turn.left == recorded) record.begin(turn.begin);
    record.add(turn.report);
  };
  if (!motion::record_settled(scene, solver, workspace.modes, wanted)) return std::nullopt;
  return record;
}

Checkpoints::Checkpoints(int window_revolutions, std::span<const double> start)
    : window_(window_revolutions) {
  last_[0].section.assign(start.begin(), start.end());
}

void Checkpoints::pass(long revolutions, std::span<const double> section) {
  if (revolutions % window_ != 0) return;
  std::rotate(last_.begin(), last_.end() - 1, last_.end());
  last_[0].revolutions = revolutions;
  last_[0].section.assign(section.begin(), section.end());
  count_ = std::min(count_ + 1, last_.size());
}

const Checkpoints::Checkpoint* Checkpoints::before_windows(long revolutions) const {
  for (std::size_t k = 0; k < count_; ++k) {
    if (last_[k].revolutions + 2L * window_ <= revolutions) return &last_[k];
  }
  return nullptr;
}

}  // namespace rubsweep::response
