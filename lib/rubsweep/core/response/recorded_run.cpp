#include "rubsweep/core/response/recorded_run.hpp"

#include <algorithm>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::response {

std::optional<motion::Record> recorded_run(const scene::Scene& scene,
                                           const integrate::run::SolverOptions& solver,
                                           const motion::ResponseOptions& options, long turns,
                                           motion::Workspace& workspace) {
  const integrate::run::Run run = integrate::start(scene, solver, workspace.modes);
  const double most_work = integrate::run::most_work_of_a_run(solver, scene.structure.coordinates());
  const long first_recorded = turns - 2L * options.window_revolutions;
  motion::Record record(scene, options);
  integrate::run::TurnRequest request;
  integrate::run::TurnReport turn;
  turn.section = integrate::run::scaled_initial_state(scene);
  for (long k = 0; k < turns; ++k) {
    if (k == first_recorded) {
      request.samples_per_revolution = options.samples_per_revolution;
      request.peaks = true;
      record.begin(turn.section);
    }
    if (run.advance(request, turn) != integrate::run::Outcome::ok ||
        integrate::run::work(turn.effort) > most_work)
      return std::nullopt;
    if (k >= first_recorded) record.add(turn);
  }
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
