// Measures the most expensive kernels by Google Benchmark: `kernels --help`. Not a test.
#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/exact/exact_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/numerics/matrix_vector.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "support/set_a_cell.hpp"

namespace {

using namespace rubsweep;

/// Consecutive turns of one run: parameter set A, one side, 75 Hz, whirl ratio 0.4.
void turn(benchmark::State& state, integrate::run::Method method, double tolerance) {
  integrate::run::SolverOptions options;
  options.method = method;
  options.relative_tolerance = tolerance;
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(test::cell_of({}).scene, options, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < 300; ++k) run.advance({}, turn);
  const long before = turn.effort.steps;
  for ([[maybe_unused]] auto _ : state) run.advance({}, turn);
  state.counters["steps"] =
      benchmark::Counter(static_cast<double>(turn.effort.steps - before), benchmark::Counter::kAvgIterations);
  // Time per step, independent of what else a turn contains.
  state.counters["time_per_step"] =
      benchmark::Counter(static_cast<double>(turn.effort.steps - before),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void exact_turn(benchmark::State& state) { turn(state, integrate::run::Method::exact, 1e-8); }
BENCHMARK(exact_turn);

void dopri5_turn(benchmark::State& state) { turn(state, integrate::run::Method::adaptive, 1e-6); }
BENCHMARK(dopri5_turn);

/// One certified step: values, rates and bounds of the guards, then a move with the table of precomputed
/// steps.
void certified_step(benchmark::State& state) {
  const scene::Scene scene = test::cell_of({}).scene;
  const auto prepared = std::make_shared<integrate::exact::modes::MachineModes<4>>(scene);
  integrate::exact::ExactMotion<4> motion(scene, prepared);
  motion.set_phases(0);
  Eigen::Matrix<double, 8, 1> physical;
  physical << 0, 0.4, 0, 0, -0.4, 0, 0, 0;
  integrate::run::state_scale(scene).to_seconds(physical);
  constexpr int steps = 256;  // then it starts again, because free vibration dies out
  for ([[maybe_unused]] auto _ : state) {
    if (!motion.enter(0, physical)) state.SkipWithError("no closed form");
    for (int i = 0; i < steps; ++i) {
      benchmark::DoNotOptimize(motion.guard(0));
      motion.step_by_table(8);
    }
  }
  state.counters["time_per_step"] =
      benchmark::Counter(steps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(certified_step);

/// Product of a full matrix and a vector. First argument: the size; second argument: offset in bytes of the
/// columns from a cache line.
void product(benchmark::State& state) {
  const auto size = static_cast<std::ptrdiff_t>(state.range(0));
  const Eigen::MatrixXd larger = Eigen::MatrixXd::Random(size + 8, size);
  const numerics::AlignedMatrix matrix(larger);
  const Eigen::VectorXd vector = Eigen::VectorXd::Random(size);
  Eigen::VectorXd result(size);
  const double* const first = matrix.data() + state.range(1) / static_cast<std::ptrdiff_t>(sizeof(double));
  for ([[maybe_unused]] auto _ : state) {
    numerics::multiply(size, size, first, matrix.stride(), vector.data(), result.data());
    benchmark::DoNotOptimize(result.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(product)->ArgsProduct({{38, 40}, {0, 16, 32, 48}});

/// Spectrum of 64 revolutions with 128 samples each, the window of every verdict.
void spectrum(benchmark::State& state) {
  std::vector<std::complex<double>> z;
  for (int i = 0; i < 64 * 128; ++i) {
    const double phase = 2 * std::numbers::pi * i / 128;
    z.push_back(std::polar(1e-3, phase) + std::polar(3e-4, -phase / 2));
  }
  response::spectrum::SpectrumWorkspace workspace;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(response::spectrum::full_spectrum(z, 64, workspace));
}
BENCHMARK(spectrum);

}  // namespace

BENCHMARK_MAIN();
