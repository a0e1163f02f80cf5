// targets CONFIGS_DIRECTORY: prints the speed ratios that are the project's targets, part by part. The unit
// is the plain dopri5 of this folder at relative tolerance 1e-6. All numbers are medians of processor times
// of alternating runs, except the gain of two threads, which is measured in wall time.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "bench/label_agreement.hpp"
#include "bench/processor_time.hpp"
#include "bench/reference.hpp"
#include "bench/work_precision.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"
#include "support/long_double_reference.hpp"
#include "support/plain_dopri5.hpp"
#include "support/set_a_cell.hpp"

namespace {

using namespace rubsweep;

constexpr double unit_tolerance = 1e-6;
constexpr int early = 6;

/// Median processor times of several methods, run alternately.
std::vector<double> medians_s(const std::vector<std::function<void()>>& routes, int repeats) {
  std::vector<std::vector<double>> times(routes.size());
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < routes.size(); ++i) {
      const double start = bench::processor_time_s();
      routes[i]();
      times[i].push_back(bench::processor_time_s() - start);
    }
  }
  std::vector<double> medians;
  for (const auto& list : times) medians.push_back(bench::median(list));
  return medians;
}

std::vector<double> scaled(const test::OneSideState<double>& state, const test::OneSideRotor& rotor) {
  std::vector<double> section(state.begin(), state.end());
  const double speed = rotor.clearance_m * 2 * std::numbers::pi * rotor.speed_hz;
  for (std::size_t i = 0; i < section.size(); ++i) section[i] /= i < 4 ? rotor.clearance_m : speed;
  return section;
}

integrate::run::TurnReport run(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                               integrate::exact::modes::ModeCache& modes, int turns) {
  const integrate::run::Run motion = integrate::start(scene, solver, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < turns; ++k) {
    if (motion.advance({}, turn) != integrate::run::Outcome::ok) std::printf("failed in turn %d\n", k);
  }
  return turn;
}

void per_revolution(const char* name, const test::OneSideRotor& rotor, int reference_steps) {
  constexpr int turns = 300;
  const auto scene = test::cell_of(rotor).scene;
  integrate::exact::modes::ModeCache modes;
  const auto times = medians_s(
      {[&] { test::run_plain_dopri5(rotor, turns, unit_tolerance); }, [&] { run(scene, {}, modes, turns); }},
      15);
  const auto reference = test::long_double_sections(rotor, early, reference_steps);
  const auto plain = test::run_plain_dopri5(rotor, early, unit_tolerance);
  const auto effort = run(scene, {}, modes, turns).effort;
  std::printf("%s, 75 Hz, whirl ratio 0.4, 300 turns: plain %.2f us per turn, exact %.3f, ratio %.1f\n", name,
              1e6 * times[0] / turns, 1e6 * times[1] / turns, times[0] / times[1]);
  std::printf("  error after 6 turns: plain %.1e, exact %.1e; exact: %.1f steps, %.2f switches per turn\n",
              test::section_error(scaled(plain.state, rotor), reference[early], rotor),
              test::section_error(run(scene, {}, modes, early).section, reference[early], rotor),
              static_cast<double>(effort.steps) / turns, static_cast<double>(effort.switches) / turns);
}

/// Prints the processor time of a map by class, computing its cells one after another.
void time_by_class(const sweep::Study& study) {
  struct Share {
    double time_s = 0;
    long cells = 0, revolutions = 0;
  };
  std::map<std::string, Share> shares;
  response::motion::Workspace workspace;
  for (std::size_t i = 0; i < sweep::cell_count(study.grid); ++i) {
    const double start = bench::processor_time_s();
    const sweep::Row row = sweep::evaluate_cell(study, i, workspace);
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

void whole_map(const std::filesystem::path& file) {
  const sweep::Study study = config::read_run_config(file, {}).study;
  std::vector<std::size_t> cells(sweep::cell_count(study.grid));
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  const std::atomic<bool> stop{false};
  const auto map = [&](int threads) {
    sweep::run_cells(
        study, cells, threads, [](std::size_t, const sweep::Row&) {}, stop);
  };
  double plain_s = 0;
  const auto sample_u = bench::spread(study.grid.unbalance.size(), 6);
  const auto sample_s = bench::spread(study.grid.speed_hz.size(), 10);
  for (const std::size_t u : sample_u) {
    for (const std::size_t s : sample_s) {
      test::OneSideRotor rotor;
      rotor.speed_hz = study.grid.speed_hz[s];
      rotor.whirl_ratio = study.grid.unbalance[u];
      plain_s += medians_s({[&] { test::run_plain_dopri5(rotor, 260, unit_tolerance); }}, 1)[0];
    }
  }
  const double sampled = static_cast<double>(sample_u.size() * sample_s.size());
  const double whole_s = plain_s / sampled * static_cast<double>(cells.size());
  std::vector<double> one_processor, one, two;
  for (int repeat = 0; repeat < 3; ++repeat) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [&](int threads) {
      const auto start = Clock::now();
      map(threads);
      return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const double processor = static_cast<double>(std::clock());
    one.push_back(seconds(1));
    one_processor.push_back((static_cast<double>(std::clock()) - processor) / CLOCKS_PER_SEC);
    two.push_back(seconds(2));
  }
  const double map_s = bench::median(one_processor);
  std::printf(
      "%s, %zu cells: plain, 260 turns a cell, %.2f s by %.0f cells; auto with classification %.3f s, "
      "ratio %.1f\n",
      file.filename().c_str(), cells.size(), whole_s, sampled, map_s, whole_s / map_s);
  std::printf("  wall clock: one thread %.3f s, two %.3f s, gain %.2f\n", bench::median(one),
              bench::median(two), bench::median(one) / bench::median(two));
  time_by_class(study);
}

/// The machine of parameter set C, with an annular stop.
model::Machine set_c() {
  test::OneSideRotor rotor;
  rotor.damping_ratio = 0.04;
  rotor.restitution = 0.5;
  rotor.casing_damping_ratio = 1;
  rotor.friction_coefficient = 0.02;
  rotor.kick_n = 150;
  model::Machine machine = test::machine_of(rotor);
  machine.stops[0].geometry = model::AnnularGeometry{};
  return machine;
}

/// Compares a whole cell, including its proof, with 600 turns of located dopri5 at a tolerance of equal
/// error.
void annular(const char* name, double speed_hz, double whirl_ratio) {
  const auto cell = scene::build_cell(set_c(), speed_hz, scene::WhirlRatio{whirl_ratio});
  const integrate::run::SolverOptions automatic;
  const auto reference = bench::reference_section(cell.scene, early, automatic);
  integrate::exact::modes::ModeCache modes;
  const double error =
      bench::section_difference(run(cell.scene, automatic, modes, early).section, reference.section);
  integrate::run::SolverOptions dopri5;
  dopri5.method = integrate::run::Method::adaptive;
  dopri5.stepper = integrate::run::Stepper::dopri5;
  double dopri5_error = 0;
  for (dopri5.relative_tolerance = 1e-4; dopri5.relative_tolerance > 2e-13; dopri5.relative_tolerance /= 2) {
    dopri5_error =
        bench::section_difference(run(cell.scene, dopri5, modes, early).section, reference.section);
    if (dopri5_error <= 1.2 * error) break;
  }
  response::motion::Workspace workspace;
  response::SettledRun settled;
  const auto times = medians_s(
      {[&] { run(cell.scene, dopri5, modes, 600); },
       [&] { settled = response::settle(cell, automatic, response::motion::ResponseOptions{}, workspace); }},
      5);
  std::printf(
      "annular stop, set C, %s, %.4g Hz, whirl ratio %.3g: dopri5 at %.1e (error %.1e), 600 turns, %.2f ms; "
      "auto "
      "(error %.1e), whole cell, %.2f ms, ratio %.2f\n",
      name, speed_hz, whirl_ratio, dopri5.relative_tolerance, dopri5_error, 1e3 * times[0], error,
      1e3 * times[1], times[0] / times[1]);
  std::printf(
      "  class %s, orbit %s, proof %s after %ld revolutions\n",
      std::string(to_string(settled.motion.motion_class)).c_str(),
      settled.motion.measures.orbit ? std::string(to_string(*settled.motion.measures.orbit)).c_str() : "none",
      settled.proof ? std::string(to_string(*settled.proof)).c_str() : "none", settled.revolutions);
}

/// Processor time per cell on the same coarse grid for several machines, which alternate cell by cell.
void cost_per_cell(const std::filesystem::path& configs, const std::vector<std::string>& names) {
  std::vector<sweep::Study> studies;
  std::vector<scene::PreparedMachine> plans;
  for (const auto& name : names) {
    studies.push_back(config::read_run_config(configs / (name + ".yaml"), {}).study);
    studies.back().grid.speed_hz = {50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160};
    studies.back().grid.unbalance = {0.1, 0.3, 0.5, 0.7, 0.9};
    plans.push_back(scene::prepare_machine(studies.back().machine));
  }
  response::motion::Workspace workspace;
  std::vector<std::vector<double>> resting(names.size()), rubbing(names.size());
  for (std::size_t cell = 0; cell < sweep::cell_count(studies[0].grid); ++cell) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double start = bench::processor_time_s();
      const sweep::Row row = sweep::evaluate_cell(studies[i], plans[i], cell, workspace);
      const bool rests = row.motion_class == response::motion::MotionClass::non_contact;
      (rests ? resting : rubbing)[i].push_back(bench::processor_time_s() - start);
    }
  }
  std::printf("cost per cell, medians over the cells of a 12 x 5 grid, against %s\n", names[0].c_str());
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::printf("  %-20s %zu resting, %.3f ms, ratio %.1f; %zu rubbing, %.3f ms, ratio %.1f\n",
                names[i].c_str(), resting[i].size(), 1e3 * bench::median(resting[i]),
                bench::median(resting[i]) / bench::median(resting[0]), rubbing[i].size(),
                1e3 * bench::median(rubbing[i]), bench::median(rubbing[i]) / bench::median(rubbing[0]));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::printf("usage: targets CONFIGS_DIRECTORY\n");
    return 1;
  }
  per_revolution("set A", {}, 2000);
  per_revolution("set B", test::set_b_rotor(), 6000);
  annular("circle", 80, 0.6);
  annular("oval", 165, 0.6);
  annular("oval that attracts weakly", 120, 0.6);
  whole_map(std::filesystem::path(argv[1]) / "benchmark/one_side.yaml");
  cost_per_cell(argv[1], {"benchmark/one_side", "hard_case/one_side", "rotor_kit"});
  return 0;
}
