#include "rubsweep/analysis/line/follow_line.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>
#include <numbers>
#include <utility>

#include "rubsweep/analysis/trace/trace_state.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/scene/scene.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::line {
namespace {

using integrate::run::Outcome;
using Complex = std::complex<double>;

HandedState handed(const scene::Scene& scene, std::span<const double> section) {
  const integrate::run::StateScale scale = integrate::run::state_scale(scene);
  return {scale.displacement_m(section), scale.velocity_m_per_s(section) / scene.speed_rad_per_s};
}

/// Turns from the start of the kick to the phase of smallest quiet gap, from 0 to below 1. A kick with a
/// phase begins later than the smallest gap, and turns are counted from the kick.
double turns_to_smallest_gap(const model::Machine& machine) {
  const double late = machine.kick ? machine.kick->phase_deg.value_or(0) / 360 : 0;
  const double turns = std::ceil(late) - late;
  return turns < 1 ? turns : 0;
}

/// State at the fraction `at` of the interval between two states that are `step_s` apart, by the cubic
/// through displacements and velocities at both ends.
SectionPoint between(const trace::TraceState& from, const trace::TraceState& to, double step_s, double at) {
  const Eigen::Vector2d rise = to.displacement_m - from.displacement_m;
  const Eigen::Vector2d a = step_s * from.velocity_m_per_s - rise, b = rise - step_s * to.velocity_m_per_s;
  const double rest = 1 - at;
  return {from.displacement_m + at * rise + at * rest * (rest * a + at * b),
          (rise + (1 - 2 * at) * (rest * a + at * b) + at * rest * (b - a)) / step_s};
}

/// Samples per turn with which the cubic is as accurate as the states: for a motion at 1X its error is 4e-12.
constexpr int fine_samples = 1024;

/// Quiet motion, from its closed form.
SettledMotion quiet_motion(const scene::Cell& cell, const sweep::Study& study,
                           response::motion::Workspace& workspace) {
  const scene::Scene& scene = cell.scene;
  const auto& rotor = scene::observed(scene);
  SettledMotion motion;
  motion.end = {cell.quiet.displacement(0), cell.quiet.velocity(0)};
  const double phase_rad = 2 * std::numbers::pi * turns_to_smallest_gap(study.machine);
  motion.section = {{rotor * cell.quiet.displacement(phase_rad),
                     scene.speed_rad_per_s * (rotor * cell.quiet.velocity(phase_rad))}};
  motion.spectrum = response::spectrum::full_spectrum(
      response::motion::quiet_samples(cell, study.response.samples_per_revolution), 1, workspace.spectrum);
  return motion;
}

/// Reads from a turn its section and its samples of the observed point.
class TurnReader {
 public:
  TurnReader(const scene::Scene& scene, const sweep::Study& study)
      : reader_(scene, study.solver),
        section_turns_(turns_to_smallest_gap(study.machine)),
        finer_(section_turns_ > 0 ? (fine_samples + study.response.samples_per_revolution - 1) /
                                        study.response.samples_per_revolution
                                  : 1),
        samples_(finer_ * study.response.samples_per_revolution),
        step_s_(scene.period_s() / samples_) {}

  /// Number of samples needed in a turn.
  int samples() const { return samples_; }

  void read(const integrate::run::TurnReport& turn, std::vector<SectionPoint>& section,
            std::vector<Complex>& displacement_m) const {
    section.push_back(section_of(turn));
    for (int k = 0; k < samples_; k += finer_) {
      const Eigen::Vector2d z = sample(turn, k).displacement_m;
      displacement_m.emplace_back(z.x(), z.y());
    }
  }

 private:
  /// State at k / samples of a turn; for k = samples the first state of the next turn.
  trace::TraceState sample(const integrate::run::TurnReport& turn, int k) const {
    if (k == samples_) return reader_.read_motion(turn.section);
    return reader_.read_motion(
        std::span(turn.samples).subspan(static_cast<std::size_t>(k) * reader_.size(), reader_.size()));
  }

  SectionPoint section_of(const integrate::run::TurnReport& turn) const {
    const int before = std::min(static_cast<int>(section_turns_ * samples_), samples_ - 1);
    const trace::TraceState from = sample(turn, before);
    const double at = section_turns_ * samples_ - before;
    if (at == 0) return {from.displacement_m, from.velocity_m_per_s};
    return between(from, sample(turn, before + 1), step_s_, at);
  }

  trace::StateReader reader_;
  double section_turns_;  ///< phase of the section, in turns
  int finer_;             ///< number of samples taken for each sample needed
  int samples_;
  double step_s_;
};

/// Continues `run`, the run that classified `cell`, from its last revolution and records its motion. A rotor
/// that is proven to be at rest is recorded from its closed form. A periodic motion is recorded once its
/// section returns within 1e-5 clearances, at the latest after max_revolutions. A proven motion without a
/// period is recorded one window later, and any other motion at once. Empty where the run has failed or now
/// fails.
std::optional<SettledMotion> settled_motion(const scene::Cell& cell, const response::SettledRun& run,
                                            const sweep::Study& study,
                                            response::motion::Workspace& workspace) {
  if (run.outcome != Outcome::ok) return std::nullopt;
  if (run.proof == response::motion::Proof::rest && cell.scene.impulses.empty())
    return quiet_motion(cell, study, workspace);
  const scene::Scene scene = integrate::run::scene_at(cell.scene, run.section, run.revolutions);
  const int window = study.response.window_revolutions;
  int spectrum_turns = window, section_turns = 2 * window;
  response::motion::Wanted wanted;
  if (run.motion.order) {
    wanted.settling.order = run.motion.order;
    wanted.settling.most_turns = study.response.max_revolutions;
    spectrum_turns = std::max(*run.motion.order, response::motion::window_turns(window, *run.motion.order));
    section_turns = *run.motion.order;
  } else if (run.proof && run.revolutions < study.response.max_revolutions) {
    wanted.settling.most_turns = window;
  }
  SettledMotion motion;
  std::vector<Complex> displacement_m;
  const TurnReader reader(scene, study);
  wanted.turns = std::max(spectrum_turns, section_turns);
  wanted.samples_per_revolution = reader.samples();
  wanted.take = [&](const response::motion::RecordedTurn& turn) {
    reader.read(turn.report, motion.section, displacement_m);
  };
  const auto record = response::motion::record_settled(scene, study.solver, workspace.modes, wanted);
  if (!record) return std::nullopt;
  const auto samples = static_cast<std::size_t>(spectrum_turns) *
                       static_cast<std::size_t>(study.response.samples_per_revolution);
  motion.spectrum = response::spectrum::full_spectrum(std::span(displacement_m).last(samples), spectrum_turns,
                                                      workspace.spectrum);
  motion.section.erase(motion.section.begin(), motion.section.end() - section_turns);
  motion.end = handed(scene, record->end);
  return motion;
}

thread_local response::motion::Workspace workspace;

/// Makes a cell start in a state of its neighbour.
void start_from(scene::Cell& cell, const HandedState& state) {
  cell.scene.pulses.clear();
  cell.scene.displacement_m = state.displacement_m;
  cell.scene.velocity_m_per_s = cell.scene.speed_rad_per_s * state.velocity_m_per_rad;
}

LinePoint run_cell(const LineCell& line_cell, Pass pass, std::size_t number,
                   const std::optional<HandedState>& before) {
  const sweep::Study& study = *line_cell.study;
  const double speed_hz = line_cell.place.speed_hz;
  // States passed from cell to cell need the same coordinates at all speeds. Cells with a kick are the same
  // as in a map.
  scene::Cell cell = scene::build_cell(
      pass == Pass::kick ? scene::prepared_at(*line_cell.machine, speed_hz) : *line_cell.machine, speed_hz,
      line_cell.place.unbalance);
  LinePoint point{pass, number, {}, std::nullopt};
  if (!scene::can_run(cell.start)) {
    point.row = sweep::row_of(cell, speed_hz, study.machine, nullptr);
    return point;
  }
  if (before) start_from(cell, *before);
  const response::SettledRun run = response::settle(cell, study.solver, study.response, workspace);
  point.row = sweep::row_of(cell, speed_hz, study.machine, &run);
  if (before) point.row.start = sweep::RunStart::handed_on;
  point.motion = settled_motion(cell, run, study, workspace);
  return point;
}

void refuse_other_coordinates(std::span<const LineCell> cells) {
  const auto coordinates = [](const LineCell& cell) { return cell.machine->assembly.system.coordinates(); };
  for (const LineCell& cell : cells) {
    if (coordinates(cell) == coordinates(cells.front())) continue;
    throw ConfigError(
        "--up, --down: the number of coordinates changes along the line, so that no state can be handed on, "
        "allowed: --kick");
  }
}

}  // namespace

std::size_t follow_line(std::span<const LineCell> cells, std::span<const Pass> passes, int threads,
                        const std::function<void(LinePoint&&)>& on_point, const std::atomic<bool>& stop) {
  std::vector<Pass> chains;
  for (const Pass pass : passes)
    if (pass != Pass::kick) chains.push_back(pass);
  if (!chains.empty()) refuse_other_coordinates(cells);
  const bool kicked = std::ranges::find(passes, Pass::kick) != passes.end();
  std::mutex mutex;
  std::size_t finished = 0;
  const auto deliver = [&](LinePoint&& point) {
    const std::lock_guard lock(mutex);
    on_point(std::move(point));
    ++finished;
  };
  const auto run_chain = [&](Pass pass) {
    std::optional<HandedState> before;
    for (std::size_t i = 0; i < cells.size() && !stop; ++i) {
      const std::size_t number = pass == Pass::up ? i : cells.size() - 1 - i;
      LinePoint point = run_cell(cells[number], pass, number, before);
      before = point.motion ? std::optional(point.motion->end) : std::nullopt;
      deliver(std::move(point));
    }
  };
  // A chain of cells takes much longer than a single cell and therefore begins first.
  batch::parallel_run(
      chains.size() + (kicked ? cells.size() : 0), threads,
      [&](std::size_t task) {
        if (task < chains.size()) {
          run_chain(chains[task]);
        } else {
          const std::size_t number = task - chains.size();
          deliver(run_cell(cells[number], Pass::kick, number, std::nullopt));
        }
      },
      {}, stop);
  return finished;
}

}  // namespace rubsweep::line
