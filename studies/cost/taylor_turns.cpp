// taylor_turns CONFIGS_DIRECTORY [CONFIG.yaml [KEY=VALUE...]]: cost of turns by Taylor series in annular
// stops: plain, with one tangent vector, with all of them, and with the records of a window. Also prints
// their error, and cost and error of dopri5 at 1e-8. For a configuration: processor time and turns of its
// cells by class.
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bench/processor_time.hpp"
#include "bench/reference.hpp"
#include "bench/work_precision.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace {

using namespace rubsweep;

/// Scenes of the table, from the configuration of set D or from set C, which has another casing, stiffness
/// and kick.
struct Motion {
  const char* config;
  std::vector<std::string> overrides;
  double speed_hz, whirl_ratio;
  const char* name;
};

const std::vector<std::string> set_c{
    "rotor.damping_ratio=0.04",
    "stops.0.stiffness_n_per_m=2.0e6",
    "stops.0.casing.damping_ratio=1.0",
    "stops.0.casing.stiffness_n_per_m=5.0e5",
    "kick.force_n=150",
};

const std::vector<Motion> motions{
    {"benchmark/annulus", set_c, 80, 0.6, "set C, 80 Hz, 0.6: circle"},
    {"benchmark/annulus", set_c, 165, 0.6, "set C, 165 Hz, 0.6: oval"},
    {"benchmark/annulus", set_c, 120, 0.6, "set C, 120 Hz, 0.6: weak oval"},
    {"benchmark/annulus_offset", {}, 184.3, 0.66, "offset, 184.3 Hz, 0.66: always touching"},
    {"benchmark/annulus_offset", {}, 91.4, 0.98, "offset, 91.4 Hz, 0.98: chaotic"},
};

constexpr int early = 6, settling = 300, turns = 300, repeats = 5;

const integrate::run::SolverOptions by_taylor, by_dopri5{.stepper = integrate::run::Stepper::dopri5};

/// A solver, and the request for each turn.
struct Way {
  integrate::run::SolverOptions solver;
  integrate::run::TurnRequest request;
};

struct Cost {
  double us = 0, steps = 0;  ///< both per turn
};

std::vector<double> section_after(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                                  int count) {
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(scene, solver, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < count; ++k) run.advance({}, turn);
  return turn.section;
}

/// Costs of `turns` turns of the settled motion, for each way alternately.
std::vector<Cost> costs_of(const scene::Scene& scene, const std::vector<Way>& ways) {
  integrate::exact::modes::ModeCache modes;
  const std::vector<double> settled = section_after(scene, by_taylor, settling);
  std::vector<integrate::run::Run> runs;
  runs.reserve(ways.size());
  for (const Way& way : ways) runs.push_back(integrate::start(scene, way.solver, modes));
  std::vector<std::vector<double>> times(ways.size());
  std::vector<Cost> costs(ways.size());
  integrate::run::TurnReport turn;
  for (int repeat = 1; repeat <= repeats; ++repeat) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      runs[i].restart(settled);
      const double start = bench::processor_time_s();
      for (int k = 0; k < turns; ++k) runs[i].advance(ways[i].request, turn);
      times[i].push_back(1e6 * (bench::processor_time_s() - start) / turns);
      costs[i].steps = static_cast<double>(turn.effort.steps) / (repeat * turns);
    }
  }
  for (std::size_t i = 0; i < costs.size(); ++i) costs[i].us = bench::median(times[i]);
  return costs;
}

std::vector<Way> ways_of(Eigen::Index states, int samples_per_revolution) {
  std::vector<Way> ways(5, {by_taylor, {}});
  ways[1].request.tangent_vectors =
      response::first_disturbance(static_cast<std::size_t>(states)).normalized();
  ways[2].request.tangent_vectors = ways[1].request.tangent_vectors;
  ways[2].request.tangent_accuracy = response::growth_accuracy;
  ways[3].request.tangent_vectors = Eigen::MatrixXd::Identity(states, states);
  ways[4].request.peaks = true;
  ways[4].request.samples_per_revolution = samples_per_revolution;
  ways.push_back({by_dopri5, {}});
  return ways;
}

void table(const std::filesystem::path& configs) {
  std::printf("us per turn, medians of %d runs of %d turns; errors after %d turns against rkf78 at 1e-13\n",
              repeats, turns, early);
  for (const Motion& m : motions) {
    const auto study =
        config::read_run_config(configs / (std::string(m.config) + ".yaml"), m.overrides).study;
    const scene::Scene scene =
        scene::build_cell(study.machine, m.speed_hz, scene::WhirlRatio{m.whirl_ratio}).scene;
    const auto costs =
        costs_of(scene, ways_of(2 * scene.structure.coordinates(), study.response.samples_per_revolution));
    const double us = costs[0].us;
    const auto reference = bench::reference_section(scene, early, {}).section;
    const auto early_error = [&](const integrate::run::SolverOptions& solver) {
      return bench::section_difference(section_after(scene, solver, early), reference);
    };
    std::printf(
        "  %-44s %6.2f (%.1f steps, %.2f us each); tangent %.2f, to %g %.2f (%.1f steps); all %.2f (%.1f); "
        "recorded %.2f; error %.0e; dopri5 %.2f (%.1f as long), error %.1e\n",
        m.name, us, costs[0].steps, us / costs[0].steps, costs[1].us / us, response::growth_accuracy,
        costs[2].us / us, costs[2].steps, costs[3].us / us, costs[3].steps, costs[4].us / us,
        early_error(by_taylor), costs[5].us, costs[5].us / us, early_error(by_dopri5));
  }
}

void by_class(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  struct Share {
    double time_s = 0;
    long cells = 0, revolutions = 0;
  };
  const sweep::Study study = config::read_run_config(file, overrides).study;
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  std::map<std::string, Share> shares;
  response::motion::Workspace workspace;
  for (std::size_t i = 0; i < sweep::cell_count(study.grid); ++i) {
    const double start = bench::processor_time_s();
    const sweep::Row row = sweep::evaluate_cell(study, prepared, i, workspace);
    Share& share = shares[std::string(to_string(row.motion_class))];
    share.time_s += bench::processor_time_s() - start;
    ++share.cells;
    share.revolutions += row.revolutions;
  }
  for (const auto& [name, share] : shares) {
    std::printf("  %-14s %5ld cells %8ld revolutions %8.1f ms, %.2f us per revolution\n", name.c_str(),
                share.cells, share.revolutions, 1e3 * share.time_s,
                1e6 * share.time_s / static_cast<double>(std::max(share.revolutions, 1L)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::printf("usage: taylor_turns CONFIGS_DIRECTORY [CONFIG.yaml [KEY=VALUE...]]\n");
    return 1;
  }
  if (argc == 2) {
    table(argv[1]);
  } else {
    by_class(argv[2], std::vector<std::string>(argv + 3, argv + argc));
  }
  return 0;
}
