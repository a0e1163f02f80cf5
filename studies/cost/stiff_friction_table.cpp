// Cost of friction that does not saturate: backward rolling (rolling_scene.hpp) with tanh laws of increasing
// steepness, by dopri5, by rosenbrock4 and by the automatic choice. Prints processor time per turn relative
// to dopri5 at the same tolerance and steepness 1e2, steps per turn, and the error of the last section from
// the closed form.
#include <algorithm>
#include <complex>
#include <cstdio>
#include <ctime>
#include <vector>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "support/rolling_scene.hpp"

namespace {

using namespace rubsweep;

constexpr int turns = 3;
constexpr int repeats = 7;

struct Cost {
  double processor_time = 0, steps = 0, implicit_share = 0, error = 0;
};

Cost measure(const test::RollingScene& rolling, const integrate::run::SolverOptions& options) {
  Cost cost;
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();
    const integrate::run::Cursor advance = integrate::adaptive::start_adaptive(rolling.scene, options);
    integrate::run::TurnReport turn;
    for (int k = 0; k < turns; ++k) {
      if (advance({}, turn) != integrate::run::Outcome::ok) std::printf("failed\n");
    }
    times.push_back(static_cast<double>(std::clock() - start));
    const double steps = static_cast<double>(turn.effort.steps);
    cost.steps = (steps + static_cast<double>(turn.effort.refused)) / turns;
    cost.implicit_share = static_cast<double>(turn.effort.implicit_steps) / steps;
    cost.error = std::abs(std::complex(turn.section[0], turn.section[1]) - rolling.displacement(turns));
  }
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  cost.processor_time = times[repeats / 2] / turns;
  return cost;
}

}  // namespace

int main() {
  using integrate::run::Stepper;
  std::printf("%9s %9s  %-11s %9s %9s %9s %9s\n", "tolerance", "steepness", "stepper", "time", "steps",
              "implicit", "error");
  for (const double tolerance : {1e-6, 1e-8}) {
    double unit = 0;
    for (const double steepness : {1e2, 1e3, 1e4, 1e5}) {
      const test::RollingScene rolling = test::rolling_scene(steepness);
      for (const auto& [stepper, name] : {std::pair{Stepper::dopri5, "dopri5"},
                                          {Stepper::rosenbrock4, "rosenbrock4"},
                                          {Stepper::automatic, "auto"}}) {
        integrate::run::SolverOptions options;
        options.stepper = stepper;
        options.relative_tolerance = tolerance;
        const Cost cost = measure(rolling, options);
        if (unit == 0) unit = cost.processor_time;
        std::printf("%9.0e %9.0e  %-11s %9.2f %9.0f %9.2f %9.1e\n", tolerance, steepness, name,
                    cost.processor_time / unit, cost.steps, cost.implicit_share, cost.error);
      }
    }
  }
  return 0;
}
