#include "rubsweep/analysis/page/settled_orbit.hpp"

#include <algorithm>
#include <numbers>
#include <span>
#include <utility>

#include "rubsweep/analysis/trace/trace_state.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/sweep/hertz_secant.hpp"

namespace rubsweep::page {
namespace {

using response::motion::MotionClass;

/// Numbers of turns at the end of the motion that are used for the section, the spectrum and the drawing.
struct Lengths {
  int section = 1, spectrum = 1, drawn = 1;
  int all() const { return std::max({section, spectrum, drawn}); }
};

bool is(const KnownMotion& known, MotionClass motion_class) {
  return known.motion_class == to_string(motion_class);
}

/// Steps per turn: a multiple of the map's own sampling, so that both give the same spectrum.
int steps_of_turn(const response::motion::ResponseOptions& options) {
  const int n = options.samples_per_revolution;
  return n * ((fewest_steps_per_turn + n - 1) / n);
}

class Recorder {
 public:
  Recorder(const scene::Scene& scene, const sweep::Study& study, const Lengths& lengths)
      : reader_(scene, study.solver),
        lengths_(lengths),
        samples_per_turn_(study.response.samples_per_revolution) {
    orbit_.steps_per_turn = steps_of_turn(study.response);
    orbit_.turns = lengths.drawn;
    orbit_.signals.resize(2 + 3 * reader_.stops());
  }

  int steps_per_turn() const { return orbit_.steps_per_turn; }

  /// Adds a turn of steps_per_turn() samples. `left`: number of remaining turns, including this one.
  void add(std::span<const double> samples, int left) {
    const std::size_t stride = static_cast<std::size_t>(orbit_.steps_per_turn / samples_per_turn_);
    for (std::size_t k = 0; k * reader_.size() < samples.size(); ++k) {
      const trace::TraceState state =
          reader_.read_motion(samples.subspan(k * reader_.size(), reader_.size()));
      const std::complex<double> z(state.displacement_m.x(), state.displacement_m.y());
      if (k == 0 && left <= lengths_.section) orbit_.section_m.push_back(z);
      if (k % stride == 0 && left <= lengths_.spectrum) displacement_m_.push_back(z);
      if (left <= lengths_.drawn) add_to_signals(state);
    }
  }

  /// `begin`: number of turns before the first turn that was added.
  SettledOrbit finish(std::span<const double> end, long begin,
                      response::spectrum::SpectrumWorkspace& workspace) {
    orbit_.first_revolution = begin + lengths_.all() - lengths_.drawn;
    add_to_signals(reader_.read_motion(end));
    orbit_.spectrum = response::spectrum::full_spectrum(displacement_m_, lengths_.spectrum, workspace);
    return std::move(orbit_);
  }

 private:
  void add_to_signals(const trace::TraceState& state) {
    auto signal = orbit_.signals.begin();
    for (const double value : {state.displacement_m.x(), state.displacement_m.y()})
      (signal++)->push_back(value);
    for (const trace::StopState& stop : state.stops)
      for (const double value : {stop.casing_m.x(), stop.casing_m.y(), stop.gap_m})
        (signal++)->push_back(value);
  }

  trace::StateReader reader_;
  Lengths lengths_;
  int samples_per_turn_;
  SettledOrbit orbit_;
  std::vector<std::complex<double>> displacement_m_;
};

/// Quiet whirl of a rotor that touches nothing, which remains after the kick has died away.
SettledOrbit quiet_orbit(const scene::Cell& cell, const sweep::Study& study, long revolutions,
                         response::motion::Workspace& workspace) {
  Recorder recorder(cell.scene, study, {});
  const Eigen::Index n = cell.scene.structure.coordinates();
  const auto state = [&](int step) {
    const double phase_rad = 2 * std::numbers::pi * step / recorder.steps_per_turn();
    Eigen::VectorXd scaled(2 * n);
    scaled << cell.quiet.displacement(phase_rad), cell.quiet.velocity(phase_rad);
    return Eigen::VectorXd(scaled / cell.scene.length_scale_m);
  };
  std::vector<double> samples;
  for (int step = 0; step < recorder.steps_per_turn(); ++step) {
    const Eigen::VectorXd scaled = state(step);
    samples.insert(samples.end(), scaled.begin(), scaled.end());
  }
  recorder.add(samples, 1);
  const Eigen::VectorXd end = state(recorder.steps_per_turn());
  return recorder.finish({end.data(), static_cast<std::size_t>(end.size())}, revolutions, workspace.spectrum);
}

/// Turns after which the motion is recorded.
response::motion::Settling settling(const KnownMotion& known,
                                    const response::motion::ResponseOptions& options,
                                    const Lengths& lengths) {
  if (known.order)
    return {.most_turns = options.max_revolutions, .order = known.order, .fewest_turns = known.revolutions};
  const long most = std::max<long>(0, options.max_revolutions - lengths.all());
  return {.most_turns = known.proven ? std::min(most, known.revolutions + options.window_revolutions) : most};
}

}  // namespace

std::optional<SettledOrbit> settled_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                          std::size_t cell, const KnownMotion& known,
                                          response::motion::Workspace& workspace) {
  if (!study.grid.axes.empty()) {
    if (is(known, MotionClass::failed)) return std::nullopt;
    sweep::Study own = study.with_keys(sweep::key_values(study.grid, cell));
    own.grid = sweep::grid_of(sweep::place_of(study.grid, cell));
    return settled_orbit(own, scene::prepare_machine(own.machine), 0, known, workspace);
  }
  if (is(known, MotionClass::failed) || is(known, MotionClass::initial_contact)) return std::nullopt;
  const auto [speed_hz, unbalance] = sweep::place_of(study.grid, cell);
  const scene::PreparedMachine there = scene::prepared_at(prepared, speed_hz);
  const scene::Cell start =
      scene::build_cell(sweep::with_secant_of_row(there, known.hertz_force_n), speed_hz, unbalance);
  if (!scene::can_run(start.start)) return std::nullopt;
  if (is(known, MotionClass::non_contact) && start.scene.impulses.empty())
    return quiet_orbit(start, study, known.revolutions, workspace);

  const int window = study.response.window_revolutions;
  Lengths lengths{2 * window, window, std::min(window, longest_aperiodic_history)};
  if (known.order) lengths = {*known.order, *known.order, *known.order};
  Recorder recorder(start.scene, study, lengths);
  const auto record =
      response::motion::record_settled(start.scene, study.solver, workspace.modes,
                                       {.settling = settling(known, study.response, lengths),
                                        .turns = lengths.all(),
                                        .samples_per_revolution = recorder.steps_per_turn(),
                                        .take = [&](const response::motion::RecordedTurn& turn) {
                                          recorder.add(turn.report.samples, static_cast<int>(turn.left));
                                        }});
  if (!record) return std::nullopt;
  return recorder.finish(record->end, record->passed, workspace.spectrum);
}

}  // namespace rubsweep::page
