#include "rubsweep/analysis/line/settled_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "rubsweep/analysis/trace/trace_state.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"

namespace rubsweep::line {
namespace {

using integrate::run::Outcome;
using Complex = std::complex<double>;

/// The scene as it stands after so many revolutions, in this state.
scene::Scene scene_after(const scene::Scene& scene, const response::SettledRun& run) {
  scene::Scene later = scene;
  later.elapsed_revolutions += run.revolutions;
  for (scene::Pulse& pulse : later.pulses)
    pulse.elapsed_s += static_cast<double>(run.revolutions) * scene.period_s();
  integrate::run::set_initial_state(later, run.section);
  return later;
}

HandedState handed(const scene::Scene& scene, std::span<const double> section) {
  const integrate::run::StateScale scale = integrate::run::state_scale(scene);
  return {scale.displacement_m(section), scale.velocity_m_per_s(section) / scene.speed_rad_per_s};
}

/// How much of a turn after the instant of the kick the phase of smallest quiet gap comes, from 0 to below 1:
/// a kick with a phase comes later than that, and takes the instants at which a turn begins with it.
double turns_to_smallest_gap(const model::Machine& machine) {
  const double late = machine.kick ? machine.kick->phase_deg.value_or(0) / 360 : 0;
  const double turns = std::ceil(late) - late;
  return turns < 1 ? turns : 0;
}

/// Cubic through two states `step_s` apart, at the share `at` of the way: displacements and velocities are
/// met at both ends.
SectionPoint between(const trace::TraceState& from, const trace::TraceState& to, double step_s, double at) {
  const Eigen::Vector2d rise = to.displacement_m - from.displacement_m;
  const Eigen::Vector2d a = step_s * from.velocity_m_per_s - rise, b = rise - step_s * to.velocity_m_per_s;
  const double rest = 1 - at;
  return {from.displacement_m + at * rise + at * rest * (rest * a + at * b),
          (rise + (1 - 2 * at) * (rest * a + at * b) + at * rest * (b - a)) / step_s};
}

/// Samples of a turn between which the cubic is as good as the states: its error is 4e-12 of a motion at 1X.
constexpr int fine_samples = 1024;

/// The quiet motion, from its closed form.
SettledMotion quiet_motion(const scene::Cell& cell, const sweep::Study& study,
                           response::motion::Workspace& workspace) {
  const scene::Scene& scene = cell.scene;
  const auto& rotor = scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
  SettledMotion motion;
  motion.end = {cell.quiet.displacement(0), cell.quiet.velocity(0)};
  const double phase_rad = 2 * std::numbers::pi * turns_to_smallest_gap(study.machine);
  motion.section = {{rotor * cell.quiet.displacement(phase_rad),
                     scene.speed_rad_per_s * (rotor * cell.quiet.velocity(phase_rad))}};
  const int n = study.response.samples_per_revolution;
  std::vector<Complex> displacement_m;
  for (int k = 0; k < n; ++k) {
    const Eigen::Vector2d z = rotor * cell.quiet.displacement(2 * std::numbers::pi * k / n);
    displacement_m.emplace_back(z.x(), z.y());
  }
  motion.spectrum = response::spectrum::full_spectrum(displacement_m, 1, workspace.spectrum);
  return motion;
}

/// Runs a scene on, turn by turn.
class Follower {
 public:
  Follower(const scene::Scene& scene, const sweep::Study& study, response::motion::Workspace& workspace)
      : run_(integrate::start(scene, study.solver, workspace.modes)),
        reader_(scene, study.solver),
        samples_per_turn_(study.response.samples_per_revolution),
        period_s_(scene.period_s()),
        section_turns_(turns_to_smallest_gap(study.machine)),
        finer_(section_turns_ > 0 ? (fine_samples + samples_per_turn_ - 1) / samples_per_turn_ : 1) {
    turn_.section = integrate::run::scaled_initial_state(scene);
  }

  const std::vector<double>& section() const { return turn_.section; }

  bool pass(int turns) {
    for (; turns > 0; --turns)
      if (run_.advance({}, turn_) != Outcome::ok) return false;
    return true;
  }

  /// Passes turns until the section is that of `order` turns ago, `most` at most.
  bool pass_until_it_returns(int order, long most) {
    response::motion::SectionReturns returns(order);
    returns.returned(turn_.section);
    for (long turn = 0; turn < most; ++turn) {
      if (run_.advance({}, turn_) != Outcome::ok) return false;
      if (returns.returned(turn_.section)) return true;
    }
    return true;
  }

  /// A turn with its samples and its section.
  bool record(std::vector<SectionPoint>& section, std::vector<Complex>& displacement_m) {
    request_.samples_per_revolution = finer_ * samples_per_turn_;
    if (run_.advance(request_, turn_) != Outcome::ok) return false;
    section.push_back(section_of_turn());
    for (int k = 0; k < samples_per_turn_; ++k) {
      const Eigen::Vector2d z = sample(k * finer_).displacement_m;
      displacement_m.emplace_back(z.x(), z.y());
    }
    return true;
  }

 private:
  /// The state k / samples of the turn that was recorded last; at its end that of the next one.
  trace::TraceState sample(int k) const {
    if (k == request_.samples_per_revolution) return reader_.read_motion(turn_.section);
    return reader_.read_motion(
        std::span(turn_.samples).subspan(static_cast<std::size_t>(k) * reader_.size(), reader_.size()));
  }

  SectionPoint section_of_turn() const {
    const int samples = request_.samples_per_revolution;
    const int before = std::min(static_cast<int>(section_turns_ * samples), samples - 1);
    const trace::TraceState from = sample(before);
    const double at = section_turns_ * samples - before;
    if (at == 0) return {from.displacement_m, from.velocity_m_per_s};
    return between(from, sample(before + 1), period_s_ / samples, at);
  }

  integrate::run::Run run_;
  trace::StateReader reader_;
  int samples_per_turn_;
  double period_s_, section_turns_;  ///< where in a turn its section lies
  int finer_;                        ///< samples taken for each that is asked for
  integrate::run::TurnRequest request_;
  integrate::run::TurnReport turn_;
};

}  // namespace

std::optional<SettledMotion> settled_motion(const scene::Cell& cell, const response::SettledRun& run,
                                            const sweep::Study& study,
                                            response::motion::Workspace& workspace) {
  if (run.outcome != Outcome::ok) return std::nullopt;
  if (run.proof == response::motion::Proof::rest && cell.scene.impulses.empty())
    return quiet_motion(cell, study, workspace);
  const scene::Scene scene = scene_after(cell.scene, run);
  Follower follower(scene, study, workspace);
  const int window = study.response.window_revolutions;
  int spectrum_turns = window, section_turns = 2 * window;
  if (run.motion.order) {
    const int order = *run.motion.order;
    if (!follower.pass_until_it_returns(order, study.response.max_revolutions)) return std::nullopt;
    spectrum_turns = std::max(order, response::motion::window_turns(window, order));
    section_turns = order;
  } else if (run.proof && run.revolutions < study.response.max_revolutions) {
    if (!follower.pass(window)) return std::nullopt;
  }
  SettledMotion motion;
  std::vector<Complex> displacement_m;
  for (int turn = std::max(spectrum_turns, section_turns); turn > 0; --turn)
    if (!follower.record(motion.section, displacement_m)) return std::nullopt;
  const auto samples = static_cast<std::size_t>(spectrum_turns * study.response.samples_per_revolution);
  motion.spectrum = response::spectrum::full_spectrum(std::span(displacement_m).last(samples), spectrum_turns,
                                                      workspace.spectrum);
  motion.section.erase(motion.section.begin(), motion.section.end() - section_turns);
  motion.end = handed(scene, follower.section());
  return motion;
}

}  // namespace rubsweep::line
