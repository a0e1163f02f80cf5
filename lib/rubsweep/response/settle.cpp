#include "rubsweep/response/settle.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/integrate/scaled_system.hpp"
#include "rubsweep/response/rest_proof.hpp"

namespace rubsweep::response {
namespace {

using Complex = std::complex<double>;

/// The last two windows of a run, filled turn by turn.
class Record {
 public:
  Record(const scene::Scene& scene, const ResponseOptions& options)
      : options_(options),
        map_(scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map * scene.length_scale_m),
        length_scale_m_(scene.length_scale_m),
        states_(2 * static_cast<std::size_t>(scene.structure.coordinates())) {
    const auto turns = static_cast<std::size_t>(2 * options.window_revolutions);
    displacement_m_.reserve(turns * static_cast<std::size_t>(options.samples_per_revolution));
    section_.reserve((turns + 1) * states_);
  }

  /// Section at the start of the first recorded turn.
  void begin(std::span<const double> section) { section_.insert(section_.end(), section.begin(), section.end()); }

  void add(const integrate::Turn& turn) {
    for (int k = 0; k < turn.samples_per_revolution; ++k) {
      const Eigen::Map<const Eigen::VectorXd> q(turn.samples.data() + static_cast<std::size_t>(k) * states_,
                                                map_.cols());
      displacement_m_.emplace_back(map_.row(0).dot(q), map_.row(1).dot(q));
    }
    section_.insert(section_.end(), turn.section.begin(), turn.section.end());
    ContactFacts& facts = facts_[turns_ < options_.window_revolutions ? 0 : 1];
    facts.hits += turn.hits;
    facts.contact_fraction += turn.contact_fraction / options_.window_revolutions;
    facts.peak_displacement_m = std::max(facts.peak_displacement_m, turn.peak_displacement_m);
    facts.peak_contact_force_n = std::max(facts.peak_contact_force_n, turn.peak_contact_force_n);
    ++turns_;
  }

  Window window(std::size_t which) const {
    const auto turns = static_cast<std::size_t>(options_.window_revolutions);
    const std::size_t samples = turns * static_cast<std::size_t>(options_.samples_per_revolution);
    Window window;
    window.turns = options_.window_revolutions;
    window.samples_per_revolution = options_.samples_per_revolution;
    window.clearance_m = length_scale_m_;
    window.displacement_m = std::span(displacement_m_).subspan(which * samples, samples);
    window.states = static_cast<int>(states_);
    window.section = std::span(section_).subspan(which * turns * states_, (turns + 1) * states_);
    window.contact = facts_[which];
    return window;
  }

 private:
  const ResponseOptions& options_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> map_;
  double length_scale_m_;
  std::size_t states_;
  int turns_ = 0;
  std::vector<Complex> displacement_m_;
  std::vector<double> section_;
  std::array<ContactFacts, 2> facts_;
};

double pulse_end_s(const scene::Scene& scene) { return scene.pulse ? scene.pulse->duration_s : 0; }

void classify(const Record& record, const ResponseOptions& options, SpectrumWorkspace& workspace, SettledRun& run) {
  const WindowVerdict previous = classify_window(record.window(0), options, workspace);
  const WindowVerdict last = classify_window(record.window(1), options, workspace);
  run.motion = settle_verdict(previous, last);
  if (run.motion.motion_class != MotionClass::unsettled) run.proof = Proof::observed;
}

}  // namespace

SettledRun settle(const integrate::Cursor& cursor, const scene::Cell& cell, const ResponseOptions& options,
                  SpectrumWorkspace& workspace) {
  SettledRun run;
  const RestProof rest(cell);
  Record record(cell.scene, options);
  const long first_recorded = options.max_revolutions - 2L * options.window_revolutions;
  const double kick_turns = pulse_end_s(cell.scene) * cell.scene.speed_rad_per_s / (2 * std::numbers::pi);
  integrate::Turn turn;
  while (run.revolutions < options.max_revolutions) {
    if (run.revolutions == first_recorded) {
      turn.samples_per_revolution = options.samples_per_revolution;
      turn.peaks = true;
      record.begin(first_recorded == 0 ? integrate::scaled_initial_state(cell.scene) : turn.section);
    }
    run.outcome = cursor(turn);
    run.effort = turn.effort;
    if (run.outcome != integrate::Outcome::ok) {
      run.motion.motion_class = MotionClass::failed;
      return run;
    }
    ++run.revolutions;
    if (turn.touched) run.last_contact_revolution = run.revolutions;
    run.slip_reversed = run.slip_reversed || turn.slip_reversed;
    if (run.revolutions > first_recorded) record.add(turn);
    const bool may_rest = !turn.touching_at_end && static_cast<double>(run.revolutions) >= kick_turns;
    if (may_rest && rest.proves(turn.section)) {
      run.motion.motion_class = MotionClass::non_contact;
      run.motion.measures = quiet_measures(cell, options, workspace);
      run.proof = Proof::rest;
      return run;
    }
  }
  classify(record, options, workspace, run);
  return run;
}

Measures quiet_measures(const scene::Cell& cell, const ResponseOptions& options, SpectrumWorkspace& workspace) {
  const auto& map = cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
  std::vector<Complex> displacement_m;
  double peak = 0;
  for (int k = 0; k < options.samples_per_revolution; ++k) {
    const double phase = 2 * std::numbers::pi * k / options.samples_per_revolution;
    const Eigen::Vector2d z = map * cell.quiet.displacement(phase);
    displacement_m.emplace_back(z.x(), z.y());
    peak = std::max(peak, z.norm());
  }
  const std::array<double, 2> rest{0, 0};
  Window window;
  window.turns = 1;
  window.samples_per_revolution = options.samples_per_revolution;
  window.clearance_m = cell.scene.length_scale_m;
  window.displacement_m = displacement_m;
  window.states = 1;
  window.section = rest;
  window.contact.peak_displacement_m = peak;
  return classify_window(window, options, workspace).measures;
}

}  // namespace rubsweep::response
