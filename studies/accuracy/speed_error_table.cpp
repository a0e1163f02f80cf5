// Speed and error on one rubbing cell (parameter set A, one side, 75 Hz, whirl ratio 0.4) over 60 turns.
// Compares the plain dopri5 to which all speed ratios refer with the library's dopri5, located and smoothed.
// The error is the largest component of the section's difference from the long double reference, in units of
// (clearance, clearance omega).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "support/long_double_reference.hpp"
#include "support/plain_dopri5.hpp"
#include "support/set_a_cell.hpp"

namespace {

using namespace rubsweep;

constexpr int turns = 60;
constexpr int early = 6;
constexpr int repeats = 15;

double median_microseconds_per_turn(const std::function<void()>& run) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run();
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[repeats / 2] / turns;
}

std::vector<double> scaled(const test::OneSideState<double>& state, const test::OneSideRotor& rotor) {
  std::vector<double> section(state.begin(), state.end());
  const double speed = rotor.clearance_m * 2 * std::numbers::pi * rotor.speed_hz;
  for (std::size_t i = 0; i < section.size(); ++i) section[i] /= i < 4 ? rotor.clearance_m : speed;
  return section;
}

void print(const char* name, double tolerance, double rhs_calls, double microseconds, double early_error,
           double late_error) {
  std::printf("%-10s %9.0e %12.0f %10.1f %12.2e %12.2e\n", name, tolerance, rhs_calls, microseconds,
              early_error, late_error);
}

}  // namespace

int main() {
  const test::OneSideRotor rotor;
  const auto reference = test::long_double_sections(rotor, turns);
  std::printf("%-10s %9s %12s %10s %12s %12s\n", "dopri5", "tolerance", "rhs per turn", "us/turn", "error, 6",
              "error, 60");
  for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-10}) {
    const auto short_run = test::run_plain_dopri5(rotor, early, tolerance);
    const auto long_run = test::run_plain_dopri5(rotor, turns, tolerance);
    const double time =
        median_microseconds_per_turn([&] { test::run_plain_dopri5(rotor, turns, tolerance); });
    print("plain", tolerance, static_cast<double>(long_run.rhs_calls) / turns, time,
          test::section_error(scaled(short_run.state, rotor), reference[early], rotor),
          test::section_error(scaled(long_run.state, rotor), reference[turns], rotor));
  }
  const auto cell = test::cell_of(rotor);
  for (const auto contact :
       {integrate::run::ContactHandling::located, integrate::run::ContactHandling::smoothed}) {
    for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12}) {
      integrate::run::SolverOptions options;
      options.contact = contact;
      options.relative_tolerance = tolerance;
      integrate::run::TurnReport turn;
      double early_error = 0;
      const auto run = [&] {
        const integrate::run::Cursor advance = integrate::adaptive::start_adaptive(cell.scene, options);
        for (int k = 1; k <= turns; ++k) {
          if (advance({}, turn) != integrate::run::Outcome::ok) std::printf("failed\n");
          if (k == early) early_error = test::section_error(turn.section, reference[early], rotor);
        }
      };
      const double time = median_microseconds_per_turn(run);
      print(contact == integrate::run::ContactHandling::located ? "located" : "smoothed", tolerance,
            static_cast<double>(turn.effort.rhs_calls) / turns, time, early_error,
            test::section_error(turn.section, reference[turns], rotor));
    }
  }
  return 0;
}
