// fit_coverage TRIALS SEED [EXPERIMENT...]: fits simulated noisy recordings like rubfit. Counts for each
// parameter how often the true value lies within the 95 % interval, and how often a fit without the bow is
// rejected. Experiments (all by default): ring_down, run_up (run-out as a parameter), run_up_known_run_out,
// two_discs, rub. Signals of run-ups and ring-downs come from Runge-Kutta steps, lines of the rub from a long
// run; the fits use neither.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/measurement/fit/machine_fit.hpp"
#include "rubsweep/measurement/fit/ramp_phasor.hpp"
#include "rubsweep/measurement/fit/rub/rub_orbits.hpp"
#include "rubsweep/measurement/recording/recording.hpp"
#include "rubsweep/measurement/scope/waterfall.hpp"

namespace {

using namespace rubsweep;
using std::numbers::pi;
using Complex = std::complex<double>;

std::mt19937_64 random_numbers;
double noise(double size) { return std::normal_distribution<double>(0, size)(random_numbers); }

struct Score {
  int inside = 0, trials = 0;
  double sum = 0, squares = 0;  ///< sums of (value - truth) / standard error and of its square
};
std::map<std::string, Score> scores;

void count(const std::string& experiment, const fit::MachineFit& problem, const fit::MachineFitResult& result,
           const std::vector<double>& truth) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    Score& score = scores[experiment + ' ' + problem.parameters[i].name];
    const double off = result.fit.value(k) - truth[i];
    score.inside += std::abs(off) <= result.uncertainty.half_width(k);
    const double errors = off / result.uncertainty.standard_error(k);
    score.sum += errors;
    score.squares += errors * errors;
    ++score.trials;
  }
}

scene::PreparedMachine jeffcott(double frequency_hz, double ratio) {
  model::Machine machine = scene::one_side_machine();
  auto& rotor = std::get<model::JeffcottRotor>(machine.rotor);
  rotor.natural_frequency_hz = frequency_hz;
  rotor.damping_ratio = ratio;
  return scene::prepare_machine(machine);
}

void ring_down() {
  static const scene::PreparedMachine truth = jeffcott(31, 0.015);
  static const Eigen::MatrixXd signal = linear::run_linear(
      truth, {.kick = true, .sample_s = 1e-3, .samples = 1500}, linear::sensor_rows(truth).rows);
  constexpr int first = 8;
  fit::RingDown data;
  for (int k = first; k < signal.rows(); ++k) data.t_s.push_back(k * 1e-3 + 0.0013);
  data.signal_m = signal.bottomRows(signal.rows() - first);
  for (double& value : data.signal_m.reshaped()) value += 5e-5 + noise(2e-5);
  fit::MachineFit problem{.parameters = {{"frequency", 30, 25, 36, 30},
                                         {"ratio", 0.02, 1e-3, 0.2, 0.02},
                                         {fit::hit_name, 0, -0.005, 0.005, 1e-3}},
                          .data = {{"ring-down", data, false}},
                          .machine = [](const Eigen::VectorXd& at) { return jeffcott(at(0), at(1)); }};
  count("ring-down", problem, fit::fit_machine(problem, {}), {31, 0.015, 0.0013});
}

/// A kit with gyroscopic moments and modal damping only.
model::Machine kit_machine() {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.discs.front().position_m = 0.15;
  kit.discs.front().polar_inertia_kg_m2 = 1e-3;
  kit.discs.front().diametral_inertia_kg_m2 = 6e-4;
  kit.bow = model::Bow{.shape = model::BowMode{.mode = 1, .amplitude_m = 1e-5}, .phase_deg = 0};
  return machine;
}

/// The prepared kit with scaled stiffness, damping and bow: new parameter values need no new reduction.
scene::PreparedMachine scaled(const scene::PreparedMachine& kit, double stiffness, double damping,
                              Complex bow) {
  scene::PreparedMachine changed = kit;
  changed.assembly.system.stiffness *= stiffness;
  changed.assembly.system.damping *= damping;
  changed.assembly.bow_n *= bow * stiffness;
  return changed;
}

/// Seconds shown by the instrument's clock per true second.
constexpr double clock_rate = 1 + 20e-6;

/// A recording of a run-up as an instrument makes it: with noise, run-out of this size, a keyphasor, and a
/// clock that is slightly wrong.
recording::Channels run_up_recording(const Eigen::MatrixXd& signal, const linear::LinearRun& run,
                                     double mark_rad, double run_out_m) {
  recording::Channels table;
  table.channels = {{"X", "m", {}}, {"Y", "m", {}}, {"KP", "V", {}}};
  const Complex x(noise(run_out_m), noise(run_out_m)), y(noise(run_out_m), noise(run_out_m));
  for (Eigen::Index k = 0; k < signal.rows(); ++k) {
    const double phi = linear::shaft_angle_rad(run, static_cast<double>(k) * run.sample_s);
    const Complex turn = std::polar(1.0, phi);
    table.channels[0].values.push_back(signal(k, 0) + (x * turn).real() + noise(2e-6));
    table.channels[1].values.push_back(signal(k, 1) + (y * turn).real() + noise(2e-6));
    const double turns = (phi - mark_rad) / (2 * pi);
    table.channels[2].values.push_back(turns - std::floor(turns) < 0.08 ? -12 : -2);
  }
  return table;
}

/// Reads bode.csv of a recording by way of a temporary file.
fit::RunUp read_run_up(const recording::Recording& read) {
  const auto file = std::filesystem::temp_directory_path() / fmt::format("fit_coverage_{}.csv", getpid());
  std::ofstream(file) << scope::bode_csv(read, {1});
  fit::RunUp data = fit::read_run_up(file);
  std::filesystem::remove(file);
  return data;
}

/// Run-up experiment; known run-out is subtracted in advance, so none is left.
void run_up(const std::string& name, bool known_run_out) {
  constexpr double stiffness = 1.03, damping = 0.8, bow = 1.5, bow_deg = 40, eccentricity_m = 2e-5;
  // The mark has another angle in every trial, so its rounding to readings has other errors, too.
  const double mark_rad = std::uniform_real_distribution<double>(-2, 2)(random_numbers);
  static const scene::PreparedMachine start = scene::prepare_machine(kit_machine());
  static const scene::PreparedMachine truth =
      scaled(start, stiffness, damping, std::polar(bow, bow_deg * pi / 180));
  static const linear::LinearRun run{.from_hz = 24,
                                     .rate_hz_per_s = 4,
                                     .eccentricity_m = eccentricity_m,
                                     .sample_s = 1 / (5000 * clock_rate),
                                     .samples = 28000};
  static const Eigen::MatrixXd signal = [] {
    linear::LinearRun driven = run;
    driven.driven = linear::Driven::in_phase;
    return linear::run_linear(truth, driven, linear::sensor_rows(truth).rows);
  }();
  const recording::Instrument instrument{.sampling_rate_hz = 5000,
                                         .probes = {{"X", 0}, {"Y", 90}},
                                         .keyphasor = recording::Keyphasor{.column = "KP"}};
  const auto read = recording::make_recording(
      run_up_recording(signal, run, mark_rad, known_run_out ? 0 : 2e-6), instrument, "run-up");
  fit::MachineFit problem{.parameters = {{"stiffness", 1, 0.8, 1.25, 1},
                                         {"damping", 1, 0.1, 10, 1},
                                         {fit::eccentricity_name, 1e-5, 1e-6, 1e-4, 1e-5},
                                         {fit::mark_name, 0, -180, 180, 30},
                                         {"bow", 1, 0, 20, 1},
                                         {"bow_deg", 0, -180, 180, 30}},
                          .data = {{"run-up", read_run_up(read), !known_run_out}},
                          .machine = [](const Eigen::VectorXd& at) {
                            return scaled(start, at(0), at(1), std::polar(at(4), at(5) * pi / 180));
                          }};
  const fit::MachineFitResult result = fit::fit_machine(problem, {});
  // When the measured mark passes, the shaft has turned by mark_rad, which is the model's mark angle. The
  // clock's error makes the rotor appear slower, and no fit can detect it.
  count(name, problem, result,
        {stiffness / (clock_rate * clock_rate), damping, eccentricity_m, mark_rad * 180 / pi, bow, bow_deg});
  problem.parameters.resize(4);
  problem.machine = [](const Eigen::VectorXd& at) { return scaled(start, at(0), at(1), 0); };
  const fit::MachineFitResult straight = fit::fit_machine(problem, {});
  Score& score = scores[name + ": a model without the bow is found out"];
  score.inside += straight.bic - result.bic > 10;
  ++score.trials;
}

scene::PreparedMachine with_unbalance(const std::vector<scene::PreparedMachine>& each, Complex first,
                                      Complex second) {
  scene::PreparedMachine machine = each[0];
  machine.assembly.system.unbalance_kg =
      first * each[0].assembly.system.unbalance_kg + second * each[1].assembly.system.unbalance_kg;
  return machine;
}

void two_discs() {
  static const std::vector<scene::PreparedMachine> each = [] {
    std::vector<scene::PreparedMachine> machines;
    for (const int disc : {0, 1}) {
      model::Machine machine = scene::light_shaft_machine();
      auto& kit = std::get<model::RotorKit>(machine.rotor);
      kit.modes = 2;
      kit.discs = {{.position_m = 0.1,
                    .mass_kg = 0.8,
                    .polar_inertia_kg_m2 = 4e-4,
                    .diametral_inertia_kg_m2 = 2e-4,
                    .eccentricity_ratio = disc == 0 ? 1.0 : 0.0},
                   {.position_m = 0.27,
                    .mass_kg = 0.8,
                    .polar_inertia_kg_m2 = 4e-4,
                    .diametral_inertia_kg_m2 = 2e-4,
                    .eccentricity_ratio = disc == 1 ? 1.0 : 0.0}};
      kit.sensors = {{0.08, 0}, {0.08, 90}, {0.3, 0}, {0.3, 90}};
      machines.push_back(scene::prepare_machine(machine));
    }
    return machines;
  }();
  const scene::PreparedMachine truth = with_unbalance(each, std::polar(2.0, 0.5), std::polar(1.2, -1.1));
  fit::Steady data{.speed_hz = {15, 32}, .phasor_m = {}};
  data.phasor_m.resize(2, 4);
  const Eigen::MatrixXd rows = linear::sensor_rows(truth).rows;
  for (Eigen::Index k = 0; k < 2; ++k)
    data.phasor_m.row(k) = fit::steady_phasors(truth, rows, 1e-5, data.speed_hz[static_cast<std::size_t>(k)]);
  for (Complex& value : data.phasor_m.reshaped()) value += Complex(noise(3e-7), noise(3e-7));
  fit::MachineFit problem{.parameters = {{"first", 1, 0.05, 20, 1},
                                         {"first_deg", 0, -180, 180, 30},
                                         {"second", 1, 0.05, 20, 1},
                                         {"second_deg", 0, -180, 180, 30}},
                          .data = {{"steady", data, false}},
                          .eccentricity_m = 1e-5,
                          .machine = [](const Eigen::VectorXd& at) {
                            return with_unbalance(each, std::polar(at(0), at(1) * pi / 180),
                                                  std::polar(at(2), at(3) * pi / 180));
                          }};
  count("two discs", problem, fit::fit_machine(problem, {}), {2, 0.5 * 180 / pi, 1.2, -1.1 * 180 / pi});
}

constexpr double rub_speed_hz = 70, rub_eccentricity_m = 1.6e-4;
constexpr int rub_turns = 2;

scene::PreparedMachine rubbing(double clearance_m, double stiffness_n_per_m) {
  model::Machine machine = scene::one_side_machine();
  machine.stops.front().clearance_m = clearance_m;
  machine.stops.front().stiffness_n_per_m = stiffness_n_per_m;
  return scene::prepare_machine(machine);
}

/// Lines of the last two turns of a long run from the kick; phi = 0 where the run begins.
Eigen::VectorXcd lines_of_a_long_run(const scene::PreparedMachine& machine,
                                     const std::vector<double>& orders) {
  constexpr int long_enough = 1200, samples = 512;
  const scene::Cell cell = scene::build_cell(machine, rub_speed_hz, scene::Eccentricity{rub_eccentricity_m});
  response::motion::Workspace workspace;
  const integrate::run::Run run = integrate::start(cell.scene, {}, workspace.modes);
  const auto& observed = cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
  const Eigen::Index coordinates = cell.scene.structure.coordinates();
  integrate::run::TurnReport report;
  for (int turn = 0; turn < long_enough; ++turn) run.advance({}, report);
  Eigen::VectorXcd lines = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(orders.size()));
  integrate::run::TurnRequest request;
  request.samples_per_revolution = samples;
  for (int turn = 0; turn < rub_turns; ++turn) {
    run.advance(request, report);
    for (int k = 0; k < samples; ++k) {
      const Eigen::Map<const Eigen::VectorXd> q(report.samples.data() + k * 2 * coordinates, coordinates);
      const Eigen::Vector2d place_m = cell.scene.length_scale_m * (observed * q);
      const double phi = 2 * pi * (turn + static_cast<double>(k) / samples);
      for (std::size_t i = 0; i < orders.size(); ++i)
        lines(static_cast<Eigen::Index>(i)) +=
            Complex(place_m.x(), place_m.y()) * std::polar(1.0 / (rub_turns * samples), -orders[i] * phi);
    }
  }
  return lines;
}

/// A 1/2 subharmonic rub at 70 Hz against one screw: lines up to 8X from a long recording by two probes, with
/// equal white noise in each line.
void rub() {
  constexpr double clearance_m = 1.02e-3, stiffness_n_per_m = 1.95e6, line_noise_m = 5e-8;
  static const std::vector<double> orders = [] {
    std::vector<double> found;
    for (int k = -16; k <= 16; ++k)
      if (k != 0) found.push_back(0.5 * k);
    return found;
  }();
  static const Eigen::VectorXcd truth = lines_of_a_long_run(rubbing(clearance_m, stiffness_n_per_m), orders);
  fit::RubLines data{.speed_hz = rub_speed_hz, .turns = rub_turns, .order = orders, .line_m = truth};
  for (Complex& line : data.line_m.reshaped())
    line += Complex(noise(line_noise_m), noise(line_noise_m)) / std::sqrt(2.0);
  fit::rub::RubOrbits orbits({}, {});
  const fit::MachineFit problem{
      .parameters = {{"clearance_m", 1e-3, 9e-4, 1.2e-3, 1e-3},
                     {"stiffness_n_per_m", 2e6, 1e6, 4e6, 2e6},
                     {fit::eccentricity_name, 1.5e-4, 1e-5, 1e-3, 1e-4},
                     {fit::mark_name, 0, -180, 180, 30}},
      .data = {{"rub", data, false}},
      .machine = [](const Eigen::VectorXd& at) { return rubbing(at(0), at(1)); },
      .rub_lines = [&](const scene::PreparedMachine& machine, const fit::RubLines& lines,
                       double e) { return orbits.lines_m(machine, lines, e); },
      .follow_rub = [&](const scene::PreparedMachine& machine, const fit::RubLines& lines,
                        double e) { orbits.follow(machine, lines, e); }};
  // The run begins with the quiet whirl at the screw; the shaft is ahead of the whirl by the lag of the
  // response.
  const auto rotor = std::get<model::JeffcottRotor>(scene::one_side_machine().rotor);
  const double r = rub_speed_hz / rotor.natural_frequency_hz;
  const double begin_deg = 90 + std::arg(Complex(1 - r * r, 2 * rotor.damping_ratio * r)) * 180 / pi;
  count("rub", problem, fit::fit_machine(problem, {}),
        {clearance_m, stiffness_n_per_m, rub_eccentricity_m, std::remainder(begin_deg, 360.0)});
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::pair<std::string, std::function<void()>>> experiments{
      {"ring_down", ring_down},
      {"run_up", [] { run_up("run-up", false); }},
      {"run_up_known_run_out", [] { run_up("run-up, run-out known", true); }},
      {"two_discs", two_discs},
      {"rub", rub}};
  if (argc < 3) {
    fmt::print(stderr, "usage: fit_coverage TRIALS SEED [EXPERIMENT...]\n");
    return 1;
  }
  const std::vector<std::string> wanted(argv + 3, argv + argc);
  const std::uint64_t seed = std::strtoull(argv[2], nullptr, 10);
  for (int trial = 0; trial < std::atoi(argv[1]); ++trial) {
    for (const auto& [name, run] : experiments) {
      if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
      // Each trial has its own random numbers, independent of which other trials run.
      random_numbers.seed(1000 * seed + static_cast<std::uint64_t>(trial));
      run();
    }
  }
  fmt::print("what,trials,inside,share,mean_offset_in_standard_errors,root_mean_square_offset\n");
  for (const auto& [name, score] : scores)
    fmt::print("\"{}\",{},{},{:.3f},{:.2f},{:.2f}\n", name, score.trials, score.inside,
               1.0 * score.inside / score.trials, score.sum / score.trials,
               std::sqrt(score.squares / score.trials));
}
