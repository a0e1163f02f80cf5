#include "rubsweep/core/response/motion/record.hpp"

#include <numbers>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"

namespace rubsweep::response::motion {
namespace {

bool made(const integrate::run::Run& run, const integrate::run::TurnRequest& request, double most_work,
          integrate::run::TurnReport& turn) {
  return run.advance(request, turn) == integrate::run::Outcome::ok &&
         integrate::run::work(turn.effort) <= most_work;
}

}  // namespace

Record::Record(const scene::Scene& scene, const ResponseOptions& options)
    : options_(options),
      map_(scene::observed(scene) * scene.length_scale_m),
      length_scale_m_(scene.length_scale_m),
      states_(2 * static_cast<std::size_t>(scene.structure.coordinates())) {
  const auto turns = 2 * static_cast<std::size_t>(options.window_revolutions);
  displacement_m_.reserve(turns * static_cast<std::size_t>(options.samples_per_revolution));
  facts_.reserve(turns);
  section_.reserve((turns + 1) * states_);
}

void Record::begin(std::span<const double> section) {
  displacement_m_.clear();
  facts_.clear();
  section_.assign(section.begin(), section.end());
}

void Record::add(const integrate::run::TurnReport& turn) {
  const double* q = turn.samples.data();
  for (int k = 0; k < turn.sample_count; ++k, q += states_) {
    double x = 0, y = 0;
    for (Eigen::Index j = 0; j < map_.cols(); ++j) {
      x += map_(0, j) * q[j];
      y += map_(1, j) * q[j];
    }
    displacement_m_.emplace_back(x, y);
  }
  section_.insert(section_.end(), turn.section.begin(), turn.section.end());
  facts_.push_back(facts_of(turn));
}

Window Record::window(std::size_t which) const {
  const auto turns = static_cast<std::size_t>(options_.window_revolutions);
  const std::size_t samples = turns * static_cast<std::size_t>(options_.samples_per_revolution);
  Window window;
  window.turns = options_.window_revolutions;
  window.samples_per_revolution = options_.samples_per_revolution;
  window.clearance_m = length_scale_m_;
  window.displacement_m = std::span(displacement_m_).subspan(which * samples, samples);
  window.states = static_cast<int>(states_);
  window.section = std::span(section_).subspan(which * turns * states_, (turns + 1) * states_);
  window.contact = std::span(facts_).subspan(which * turns, turns);
  return window;
}

void add_samples(const scene::Scene& scene, const integrate::run::TurnReport& turn,
                 std::vector<std::complex<double>>& displacement_m) {
  const auto states = 2 * scene.structure.coordinates();
  const Eigen::Map<const Eigen::MatrixXd> samples(turn.samples.data(), states, turn.sample_count);
  for (Eigen::Index k = 0; k < samples.cols(); ++k) {
    const Eigen::Vector2d z =
        scene.length_scale_m * (scene::observed(scene) * samples.col(k).head(states / 2));
    displacement_m.emplace_back(z.x(), z.y());
  }
}

std::optional<long> pass_until_settled(const integrate::run::Run& run, const Settling& settling,
                                       integrate::run::TurnReport& turn) {
  SectionReturns returns(settling.order.value_or(1));
  if (settling.order) returns.returned(turn.section);
  constexpr long turns_between_looks = 16;
  long in_flight = 0;
  for (long passed = 0; passed < settling.most_turns;) {
    const bool looks = settling.most_force_n && passed > 0 && passed % turns_between_looks == 0;
    if (!made(run, {.peaks = looks}, settling.most_work, turn)) return std::nullopt;
    ++passed;
    if (looks && facts_of(turn).peak_contact_force_n > *settling.most_force_n) return std::nullopt;
    in_flight = turn.touched ? 0 : in_flight + 1;
    if (settling.longest_flight && in_flight > *settling.longest_flight) return std::nullopt;
    if (settling.order && returns.returned(turn.section) && passed >= settling.fewest_turns) return passed;
  }
  return settling.most_turns;
}

std::optional<SettledRecord> record_settled(const scene::Scene& scene,
                                            const integrate::run::SolverOptions& solver,
                                            integrate::exact::modes::ModeCache& modes, const Wanted& wanted) {
  const integrate::run::Run run = integrate::start(scene, solver, modes);
  integrate::run::TurnReport turn;
  if (wanted.start.empty()) {
    turn.section = integrate::run::scaled_initial_state(scene);
  } else {
    run.restart(wanted.start);
    turn.section.assign(wanted.start.begin(), wanted.start.end());
  }
  const auto passed = pass_until_settled(run, wanted.settling, turn);
  if (!passed) return std::nullopt;
  SettledRecord record{.passed = *passed, .displacement_m = {}, .contact = {}, .touched = false, .end = {}};
  const integrate::run::TurnRequest request{.samples_per_revolution = wanted.samples_per_revolution,
                                            .peaks = wanted.peaks};
  std::vector<ContactFacts> facts;
  std::vector<double> begin;
  for (long left = wanted.turns; left > 0; --left) {
    begin = turn.section;
    if (!made(run, request, wanted.settling.most_work, turn)) return std::nullopt;
    if (wanted.take) {
      wanted.take({turn, begin, left});
    } else {
      add_samples(scene, turn, record.displacement_m);
    }
    facts.push_back(facts_of(turn));
    record.touched = record.touched || turn.touched;
  }
  record.contact = together(facts);
  record.end = std::move(turn.section);
  return record;
}

std::vector<std::complex<double>> quiet_samples(const scene::Cell& cell, int count) {
  std::vector<std::complex<double>> displacement_m;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector2d z =
        scene::observed(cell.scene) * cell.quiet.displacement(2 * std::numbers::pi * k / count);
    displacement_m.emplace_back(z.x(), z.y());
  }
  return displacement_m;
}

}  // namespace rubsweep::response::motion
