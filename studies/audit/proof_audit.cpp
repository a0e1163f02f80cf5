#include "audit/proof_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <vector>

#include "audit/section_distance.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::audit {
namespace {

using integrate::run::Outcome;
using integrate::run::TurnReport;
using response::motion::MotionClass;
using response::motion::Proof;

constexpr int revolutions_of_a_cell = 1500;
constexpr long most_turns_exact = 60'000, most_turns_adaptive = 1'500;
constexpr int window = 64;

/// Stores the last sections of a run.
class Sections {
 public:
  explicit Sections(int most_order) : kept_(2 * static_cast<std::size_t>(most_order) + 1) {}

  void add(const TurnReport& turn) {
    list_.push_front(turn.section);
    touched_.push_front(turn.touched);
    if (list_.size() > kept_) list_.pop_back(), touched_.pop_back();
  }

  /// Distance of the last section from the one `turns` turns earlier; infinite where that is not stored.
  double returns_by(int turns) const {
    const auto n = static_cast<std::size_t>(turns);
    return n < list_.size() ? section_distance(list_[0], list_[n]) : std::numeric_limits<double>::infinity();
  }

  /// Smallest number of turns after which the section returns within `tolerance`; 0: none.
  int order(double tolerance) const {
    for (int n = 1; static_cast<std::size_t>(n) < list_.size(); ++n) {
      if (returns_by(n) < tolerance) return n;
    }
    return 0;
  }

  bool touched(int turns) const {
    return std::any_of(touched_.begin(), touched_.begin() + turns, [](bool t) { return t; });
  }

 private:
  std::size_t kept_;
  std::deque<std::vector<double>> list_;
  std::deque<bool> touched_;
};

/// Follows a motion that is not periodic in turns, and compares its final state.
void follow_whirl(const integrate::run::Run& run, const response::SettledRun& settled, TurnReport& turn,
                  ProofAudit& audit) {
  double peak = 0;
  for (long k = 1; k <= most_turns_adaptive; ++k) {
    const bool peaks = k > most_turns_adaptive - window;
    if (run.advance({.peaks = peaks}, turn) != Outcome::ok) {
      audit.finding = "the run failed";
      return;
    }
    if (peaks) peak = std::max(peak, turn.peak_displacement_m);
    audit.turns = k;
  }
  const double proven = settled.motion.measures.contact.peak_displacement_m;
  audit.confirmed = std::abs(peak - proven) < 2e-3 * proven;
  if (!audit.confirmed) audit.finding = fmt::format("peak {:.6g} m instead of {:.6g} m", peak, proven);
}

void follow_orbit(const integrate::run::Run& run, const response::SettledRun& settled, int most_order,
                  TurnReport& turn, ProofAudit& audit) {
  Sections sections(most_order);
  const int proven = *settled.motion.order;
  int steady = 0;  // number of turns for which the proven period has held
  long untouched = 0;
  const long adaptive_before = turn.effort.adaptive_turns;
  for (long k = 1;; ++k) {
    if (run.advance({}, turn) != Outcome::ok) {
      audit.finding = "the run failed";
      return;
    }
    sections.add(turn);
    audit.turns = k;
    const bool adaptive = turn.effort.adaptive_turns > adaptive_before;
    const double tolerance = adaptive ? 1e-6 : 1e-9;
    untouched = turn.touched ? 0 : untouched + 1;
    if (untouched > 4L * most_order) {
      audit.finding = "rest";
      return;
    }
    steady = sections.returns_by(proven) < tolerance ? steady + 1 : 0;
    if (steady > 2 * proven) {
      // A smaller number of turns must clearly not be a period.
      const int order = sections.order(10 * tolerance);
      audit.confirmed = order == proven && sections.touched(order);
      if (!audit.confirmed) audit.finding = fmt::format("1/{} instead of 1/{}", order, proven);
      return;
    }
    if (k < (adaptive ? most_turns_adaptive : most_turns_exact)) continue;
    // A multiplier this close to 1 would take too long to follow.
    const double left = static_cast<double>(k) / proven * -std::log(settled.floquet_modulus.value_or(0));
    audit.undecided = left < 25;
    audit.finding = fmt::format("no return after {} turns, 1/{} within 1e-6", proven, sections.order(1e-6));
    return;
  }
}

}  // namespace

ProofAudit audit_proof(const RandomCell& random) {
  ProofAudit audit;
  const scene::Cell cell =
      scene::build_cell(random.machine, random.speed_hz, scene::WhirlRatio{random.whirl_ratio});
  if (cell.start != scene::Start::quiet) return audit;
  response::motion::ResponseOptions options;
  options.max_revolutions = revolutions_of_a_cell;
  response::motion::Workspace workspace;
  const integrate::run::SolverOptions solver;
  const response::SettledRun settled = response::settle(cell, solver, options, workspace);
  audit.simulated = settled.outcome == Outcome::ok;
  audit.proof = settled.proof;
  if (audit.proof != Proof::floquet && audit.proof != Proof::floquet_observed) return audit;
  audit.followed = true;
  const integrate::run::Run run = integrate::start(cell.scene, solver, workspace.modes);
  TurnReport turn;
  for (long k = 0; k < settled.revolutions; ++k) {
    if (run.advance({}, turn) != Outcome::ok) {
      audit.finding = "the run failed";
      return audit;
    }
  }
  if (settled.motion.order) {
    follow_orbit(run, settled, 2 * options.max_order, turn, audit);
  } else {
    follow_whirl(run, settled, turn, audit);
  }
  return audit;
}

RandomCell minimised(const RandomCell& cell) {
  const auto fails = [](const RandomCell& c) {
    const ProofAudit audit = audit_proof(c);
    return audit.followed && !audit.confirmed && !audit.undecided;
  };
  RandomCell best = cell;
  const auto attempt = [&](const std::function<void(RandomCell&)>& change) {
    RandomCell next = best;
    change(next);
    if (fails(next)) best = next;
  };
  for (std::size_t i = best.machine.stops.size(); i-- > 1;)
    attempt([&](RandomCell& c) { c.machine.stops.erase(c.machine.stops.begin() + static_cast<long>(i)); });
  for (std::size_t i = 0; i < best.machine.stops.size(); ++i) {
    attempt([&](RandomCell& c) { c.machine.stops[i].friction = model::NoFriction{}; });
    attempt([&](RandomCell& c) { c.machine.stops[i].casing.reset(); });
  }
  const auto shorten = [&](auto member) {
    attempt([&](RandomCell& c) {
      double& number = member(c);
      const double unit = std::pow(10, std::floor(std::log10(std::abs(number))) - 2);
      number = std::round(number / unit) * unit;
    });
  };
  shorten([](RandomCell& c) -> double& { return c.speed_hz; });
  shorten([](RandomCell& c) -> double& { return c.whirl_ratio; });
  shorten([](RandomCell& c) -> double& { return std::get<model::JeffcottRotor>(c.machine.rotor).mass_kg; });
  shorten(
      [](RandomCell& c) -> double& { return std::get<model::JeffcottRotor>(c.machine.rotor).damping_ratio; });
  shorten([](RandomCell& c) -> double& { return c.machine.kick->force_n; });
  for (std::size_t i = 0; i < best.machine.stops.size(); ++i)
    shorten([i](RandomCell& c) -> double& { return c.machine.stops[i].stiffness_n_per_m; });
  return best;
}

}  // namespace rubsweep::audit
