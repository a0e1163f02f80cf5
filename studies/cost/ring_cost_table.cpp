// Not a test: prints the cost of an onset by bisection and by polishing, and its growth with the numbers of
// speeds and loads. Times are medians of five runs on one thread; compare them only with each other.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "ring/support.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/ring/analysis.hpp"
#include "rubsweep/ring/study.hpp"

namespace {

using namespace rubsweep;
using namespace rubsweep::ring;

template <class Work>
double median_ms(Work work) {
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + 2, times.end());
  return times[2];
}

void onset_row(const NormalForm& form, const std::vector<double>& speeds,
               const std::vector<Signature>& signatures, const std::vector<Change>& exact,
               const ChangeOptions& options) {
  std::vector<Change> found;
  const double time = median_ms([&] { found = find_changes(form, speeds, signatures, options); });
  int evaluations = 0;
  for (const Change& change : found) evaluations += change.evaluations;
  double error = 0;
  for (const Change& onset : exact) {
    double least = INFINITY;
    for (const Change& change : found) {
      least = std::min(least, std::abs(change.speed_rad_per_s - onset.speed_rad_per_s));
    }
    error = std::max(error, least);
  }
  fmt::print("{:<10} {:>8.0e} {:>7} {:>12} {:>12.1e} {:>8.3f}\n", options.polish ? "polish" : "bisection",
             options.tolerance_rad_per_s, found.size(), evaluations, error, time);
}

void onsets() {
  const NormalForm form = normal_form(spring_masses({60, 87}));
  const auto speeds = batch::evenly_spaced(0.0, 1500 * rpm, 301);
  std::vector<Signature> signatures;
  for (const double speed : speeds) signatures.push_back(signature(form, speed));
  const auto exact = find_changes(form, speeds, signatures);
  fmt::print("method     end(rad/s) onsets  spectra   error(rad/s)  ms\n");
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    onset_row(form, speeds, signatures, exact, {.polish = false, .tolerance_rad_per_s = tolerance});
  }
  onset_row(form, speeds, signatures, exact, {});
}

void loads() {
  fmt::print("loads  us per speed\n");
  for (const int count : {1, 2, 4, 8, 16, 32}) {
    System system = spring_masses({});
    for (int j = 0; j < count; ++j) {
      system.loads.push_back(at(7.0 + 11 * j, spring_mass(100 + j, 1e6, 1e6 + 1e4 * j)));
    }
    const NormalForm form = normal_form(system);
    const double time = median_ms([&] {
      for (int k = 0; k < 100; ++k) eigenvalues(form, 20 + 0.1 * k);
    });
    fmt::print("{:>5} {:>10.2f}\n", count, 10 * time);
  }
}

void speeds() {
  fmt::print("speeds  ms of a whole analysis, two loads\n");
  for (const int count : {500, 1000, 2000, 4000}) {
    const double time = median_ms([&] {
      analyse(spring_masses({60, 87}), batch::evenly_spaced(0.0, 1500 * rpm, count));
    });
    fmt::print("{:>6} {:>10.1f}\n", count, time);
  }
}

void chart() {
  fmt::print("threads  ms of a chart of 500 x 500 points with its onsets, one load\n");
  const std::atomic<bool> never{false};
  const ChartAxis axis{Parameter::inclination_deg, {}, batch::evenly_spaced(0.0, 90.0, 500)};
  for (const int threads : {1, 2}) {
    const double time = median_ms([&] {
      run_chart(
          spring_masses({60}), axis, batch::evenly_spaced(0.0, 2000 * rpm, 500), threads,
          [](const ChartLine&) {}, never);
    });
    fmt::print("{:>7} {:>10.0f}\n", threads, time);
  }
}

}  // namespace

int main() {
  onsets();
  loads();
  speeds();
  chart();
}
