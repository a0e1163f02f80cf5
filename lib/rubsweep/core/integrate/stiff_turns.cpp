#include "rubsweep/core/integrate/stiff_turns.hpp"

#include <algorithm>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"

namespace rubsweep::integrate {
namespace {

/// Smallest number of pieces in a turn that counts as stiff: ten times that of usual turns.
constexpr long least_pieces = 2000;
/// Number of pieces that one implicit step must replace on average. A step costs as much as two or three
/// pieces. Where it follows the fast vibration, it is as short as a piece.
constexpr long pieces_of_a_step = 8;
constexpr double tolerance = 1e-9;  ///< Tolerance of the stepper, unless the options require a tighter one.
/// Number of pieces for each change of contact mode: the vibration that a change excites must decay soon.
constexpr long pieces_of_a_change = 8000;
constexpr int longest_wait = 64;
/// Number of turns after which other solvers are tried again, because closed forms may then apply.
constexpr int longest_stretch = 128;

run::SolverOptions implicit_options(run::SolverOptions options) {
  options.method = run::Method::adaptive;
  options.stepper = run::Stepper::rosenbrock4;
  options.relative_tolerance = std::min(options.relative_tolerance, tolerance);
  return options;
}

}  // namespace

StiffTurns::StiffTurns(const scene::Scene& scene, const run::SolverOptions& options)
    : scene_(scene), options_(implicit_options(options)) {}

void StiffTurns::look(long pieces, long changes) {
  end();
  most_changes_ = pieces / pieces_of_a_change;
  if (pieces < least_pieces || changes > most_changes_) return;
  due_ = ++waited_ > wait_;
  options_.max_steps_per_revolution = pieces / pieces_of_a_step;
}

bool StiffTurns::advance(std::span<const double> section, long revolution, const run::TurnRequest& request,
                         run::TurnReport& report) {
  if (!stepper_) stepper_ = adaptive::start_adaptive(run::scene_at(scene_, section, revolution), options_);
  const long before = present_.switches;
  const bool made = stepper_(request, report) == run::Outcome::ok;
  present_ = report.effort;
  waited_ = 0;
  wait_ = made ? 0 : std::clamp(2 * wait_, 1, longest_wait);
  if (!made || report.effort.switches > before + most_changes_ || ++stretch_ >= longest_stretch) end();
  return made;
}

void StiffTurns::restart() {
  end();
  wait_ = waited_ = 0;
}

void StiffTurns::end() {
  past_ = past_ + present_;
  present_ = {};
  stepper_ = nullptr;
  stretch_ = 0;
  due_ = false;
}

}  // namespace rubsweep::integrate
