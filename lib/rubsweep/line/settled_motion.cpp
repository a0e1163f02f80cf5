#include "rubsweep/line/settled_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "rubsweep/integrate/run/state_scale.hpp"
#include "rubsweep/integrate/start.hpp"
#include "rubsweep/response/motion/section.hpp"
#include "rubsweep/trace/trace_state.hpp"

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

/// The quiet motion, from its closed form.
SettledMotion quiet_motion(const scene::Cell& cell, const sweep::Study& study,
                           response::motion::Workspace& workspace) {
  const scene::Scene& scene = cell.scene;
  const auto& rotor = scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
  SettledMotion motion;
  motion.end = {cell.quiet.displacement(0), cell.quiet.velocity(0)};
  motion.section = {
      {rotor * motion.end.displacement_m, scene.speed_rad_per_s * (rotor * motion.end.velocity_m_per_rad)}};
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
        samples_per_turn_(study.response.samples_per_revolution) {
    turn_.section = integrate::run::scaled_initial_state(scene);
  }

  const std::vector<double>& section() const { return turn_.section; }

  bool pass(int turns) {
    for (; turns > 0; --turns)
      if (run_.advance({}, turn_) != Outcome::ok) return false;
    return true;
  }

  /// Until the section is that of `order` turns ago, for so many turns at most.
  bool pass_until_it_returns(int order, long most) {
    response::motion::SectionReturns returns(order);
    returns.returned(turn_.section);
    for (long turn = 0; turn < most; ++turn) {
      if (run_.advance({}, turn_) != Outcome::ok) return false;
      if (returns.returned(turn_.section)) return true;
    }
    return true;
  }

  /// A turn with its samples, of which the first is the section at its start.
  bool record(std::vector<SectionPoint>& section, std::vector<Complex>& displacement_m) {
    request_.samples_per_revolution = samples_per_turn_;
    if (run_.advance(request_, turn_) != Outcome::ok) return false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(samples_per_turn_); ++k) {
      const trace::TraceState state =
          reader_.read(std::span(turn_.samples).subspan(k * reader_.size(), reader_.size()));
      if (k == 0) section.push_back({state.displacement_m, state.velocity_m_per_s});
      displacement_m.emplace_back(state.displacement_m.x(), state.displacement_m.y());
    }
    return true;
  }

 private:
  integrate::run::Run run_;
  trace::StateReader reader_;
  int samples_per_turn_;
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
