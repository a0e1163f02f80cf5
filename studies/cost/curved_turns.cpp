// curved_turns CONFIGS_DIRECTORY [MOTION WAY TURNS]: cost of a turn of a rubbing motion whose stop pushes by
// the power 1.5 of the penetration, beside that of a Taylor turn of the same machine with a linear stop. Both
// are equally stiff at the deepest penetration of the linear motion. Also prints the error of each. With
// further arguments: makes TURNS settled turns of one motion, `linear` or `curved`, for a count of
// instructions.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/processor_time.hpp"
#include "bench/reference.hpp"
#include "bench/work_precision.hpp"
#include "rubsweep/core/integrate/run/coordinates.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace {

using namespace rubsweep;
using integrate::run::SolverOptions;
using integrate::run::TurnReport;

struct Motion {
  const char* config;
  double speed_hz, whirl_ratio;
  const char* name;
};

const std::vector<Motion> motions{
    {"benchmark/annulus_offset", 184.3, 0.66, "offset annulus, 184.3 Hz, 0.66"},
    {"benchmark/annulus_offset", 91.4, 0.98, "offset annulus, 91.4 Hz, 0.98"},
    {"benchmark/annulus", 184.3, 0.9, "annulus, 184.3 Hz, 0.9"},
    {"benchmark/annulus", 60, 0.9, "annulus, 60 Hz, 0.9"},
    {"benchmark/one_side", 60, 0.6, "set A, one stop, 60 Hz, 0.6"},
    {"benchmark/both_sides", 90, 0.7, "set A, two stops, 90 Hz, 0.7"},
    {"reference_machine", 120, 0.5, "one stop, 120 Hz, 0.5"},
    {"reference_machine", 63, 0.3, "one stop, 63 Hz, 0.3"},
    {"reference/figure09_both_sides", 90, 0.8, "two stops, 90 Hz, 0.8"},
};

constexpr int early = 6, settling = 300, turns = 300, repeats = 5;
constexpr double exponent = 1.5;

scene::Scene scene_of(const model::Machine& machine, const Motion& m) {
  return scene::build_cell(machine, m.speed_hz, scene::WhirlRatio{m.whirl_ratio}).scene;
}

integrate::run::Cursor taylor_turns(const scene::Scene& scene) {
  return integrate::run::with_coordinates(
      scene.structure.coordinates(), [&](auto n) -> integrate::run::Cursor {
        auto run = std::make_shared<integrate::taylor::TaylorRun<n()>>(scene, SolverOptions{});
        return [run](const auto& request, TurnReport& report) { return run->advance(request, report); };
      });
}

/// Turns of a scene: Taylor pieces alone for a linear stop, else the solver that the options choose.
class Turns {
 public:
  Turns(const scene::Scene& scene, bool curved, const SolverOptions& options = {})
      : cursor_(curved ? integrate::start(scene, options, modes_).advance : taylor_turns(scene)) {}

  const TurnReport& advance(int count, const integrate::run::TurnRequest& request = {}) {
    for (int k = 0; k < count; ++k) {
      if (cursor_(request, turn_) != integrate::run::Outcome::ok) std::printf("a turn failed\n");
    }
    return turn_;
  }

 private:
  integrate::exact::modes::ModeCache modes_;
  integrate::run::Cursor cursor_;
  TurnReport turn_;
};

/// The machine with stops of the power 1.5 that are as stiff where the linear motion is deepest, damped as in
/// an impact that is as deep.
model::Machine with_power(model::Machine machine, const Motion& m) {
  const scene::Scene scene = scene_of(machine, m);
  const auto scaled = integrate::run::scale<Eigen::Dynamic>(scene).contacts[0];
  const double rate = std::sqrt(scaled.stiffness * scaled.mobility()) * scene.speed_rad_per_s;
  Turns linear(scene, false);
  linear.advance(settling);
  double force_n = 0;
  for (int k = 0; k < early; ++k)
    force_n = std::max(force_n, linear.advance(1, {.peaks = true}).peak_contact_force_n);
  for (model::Stop& stop : machine.stops) {
    const double deepest_m = std::max(force_n / stop.stiffness_n_per_m, 1e-3 * stop.clearance_m);
    stop.law.kind = model::ForceCurve::power;
    stop.law.exponent = exponent;
    stop.law.stiffness_n_per_m_n = stop.stiffness_n_per_m * std::pow(deepest_m, 1 - exponent);
    stop.law.damping = model::ImpactDamping::delivered;
    stop.law.restitution = 0.5;
    stop.law.approach_speed_m_per_s = deepest_m * rate;
  }
  return machine;
}

struct Cost {
  double us = 0, steps = 0, hits = 0, contact = 0, error = 0;  ///< per turn; the error after `early` turns
};

std::vector<double> reference_of(const scene::Scene& scene, bool curved) {
  if (!curved) return bench::reference_section(scene, early, {}).section;
  SolverOptions tight{.method = integrate::run::Method::adaptive, .relative_tolerance = 1e-14};
  return Turns(scene, true, tight).advance(early).section;
}

Cost cost_of(const scene::Scene& scene, bool curved) {
  Cost cost;
  cost.error =
      bench::section_difference(Turns(scene, curved).advance(early).section, reference_of(scene, curved));
  Turns run(scene, curved);
  run.advance(settling);
  std::vector<double> times;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double start = bench::processor_time_s();
    run.advance(turns);
    times.push_back(1e6 * (bench::processor_time_s() - start) / turns);
  }
  cost.us = bench::median(times);
  const long before = run.advance(1).effort.steps;
  for (int k = 0; k < turns; ++k) {
    const TurnReport& turn = run.advance(1);
    cost.hits += double(turn.hits) / turns;
    cost.contact += turn.contact_fraction / turns;
    cost.steps = double(turn.effort.steps - before) / turns;
  }
  return cost;
}

model::Machine machine_of(const std::filesystem::path& configs, const Motion& m) {
  return config::read_run_config(configs / (std::string(m.config) + ".yaml"), {}).study.machine;
}

void table(const std::filesystem::path& configs) {
  std::printf("us per turn, medians of %d runs of %d turns; errors after %d turns\n", repeats, turns, early);
  for (const Motion& m : motions) {
    const model::Machine machine = machine_of(configs, m);
    const Cost linear = cost_of(scene_of(machine, m), false),
               curved = cost_of(scene_of(with_power(machine, m), m), true);
    std::printf("%-32s ratio %5.2f:", m.name, curved.us / linear.us);
    for (const Cost& c : {linear, curved})
      std::printf("  %7.2f us, %5.1f steps, %4.2f hits, %3.0f %% contact, error %.0e%s", c.us, c.steps,
                  c.hits, 100 * c.contact, c.error, &c == &curved ? "\n" : " |");
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2 && count != 5) {
    std::printf("usage: curved_turns CONFIGS_DIRECTORY [MOTION linear|curved TURNS]\n");
    return 2;
  }
  if (count == 2) return table(arguments[1]), 0;
  const Motion& m = motions.at(std::size_t(std::atoi(arguments[2])));
  const bool curved = std::string_view(arguments[3]) == "curved";
  const model::Machine machine = machine_of(arguments[1], m);
  Turns run(scene_of(curved ? with_power(machine, m) : machine, m), curved);
  run.advance(settling + std::atoi(arguments[4]));
  return 0;
}
